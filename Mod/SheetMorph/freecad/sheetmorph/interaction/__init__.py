# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse does to a morph, and the frames that follow it: between panels and scene."""
