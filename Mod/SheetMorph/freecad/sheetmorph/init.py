# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start-up code of FreeCAD, with and without a window: fast, and without the kernel."""

import FreeCAD

from freecad.sheetmorph.tests import MODULES

FreeCAD.__unit_test__ += list(MODULES)
