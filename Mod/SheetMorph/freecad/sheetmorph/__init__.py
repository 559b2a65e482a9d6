# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph, the FreeCAD workbench that deforms sheet metal while its holes stay round.

`freecad.sheetmorph.api` is the public scripting interface; it needs no window. Here alone the
document objects get to know, by way of `doors`, what solves and what shows them.
"""

from freecad.sheetmorph import doors


def _give_looks(obj) -> None:
    import FreeCAD

    if FreeCAD.GuiUp:
        from freecad.sheetmorph import views

        views.attach(obj)


def _new_solver():
    from freecad.sheetmorph.bridge.solving import SessionCache

    return SessionCache()


doors.give_looks.lead_to(_give_looks)
doors.new_solver.lead_to(_new_solver)
