# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph, the FreeCAD workbench that deforms sheet metal while its holes stay round.

`freecad.sheetmorph.api` is the public scripting interface; it needs no window.
"""
