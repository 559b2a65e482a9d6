# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD runs at its start, with and without a window: light, and without the kernel."""

import FreeCAD

from freecad.sheetmorph.tests import MODULES

FreeCAD.__unit_test__ += list(MODULES)
