# SPDX-License-Identifier: LGPL-2.1-or-later
"""The effect of the mouse on a morph and the resulting frames, between panels and scene."""
