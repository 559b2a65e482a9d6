# SPDX-License-Identifier: LGPL-2.1-or-later
"""Logic of picking, moving and studies in plain Python, without Qt, Coin or FreeCAD."""
