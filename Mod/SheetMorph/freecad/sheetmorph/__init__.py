# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph, the FreeCAD workbench that deforms sheet metal while its holes stay round.

`freecad.sheetmorph.api` is the public scripting interface, which needs no window. This module alone
connects the document objects, by way of `doors`, with the solver and the views.
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


def _without_traceback(method):
    from freecad.sheetmorph.bridge import kernel

    def raising(*arguments) -> None:
        error = method(*arguments)
        if error is not None:
            raise error

    return kernel.core().without_traceback(method) if kernel.is_available() else raising


doors.give_looks.lead_to(_give_looks)
doors.without_traceback.lead_to(_without_traceback)
doors.new_solver.lead_to(_new_solver)
