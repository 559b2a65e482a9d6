# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user means while picking and moving; plain Python without Qt, Coin or FreeCAD."""
