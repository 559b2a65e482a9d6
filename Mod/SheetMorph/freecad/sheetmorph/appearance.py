# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one door from the document objects to their view providers, shut where there is no window."""

import FreeCAD


def give(obj) -> None:
    """Give one of our document objects its view provider if FreeCAD has a window."""
    if FreeCAD.GuiUp:
        from freecad.sheetmorph import views

        views.attach(obj)
