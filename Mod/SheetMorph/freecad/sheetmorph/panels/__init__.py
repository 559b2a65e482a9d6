# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: widgets and their meaning, without geometry and Coin."""
