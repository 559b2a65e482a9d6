# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes a picture of every panel in a light and in a dark style, to be looked at:
tests/gui/run.sh <add-on> looks, with SHEETMORPH_GUI_OUT for the pictures."""

import os

import FreeCAD as App
import FreeCADGui as Gui
from checks_hostile import press_if_there
from desk import panel, picture, settled, until
from hostile_panels import PANELS, is_shown, prepared
from PySide import QtGui

STYLES = {"light": "", "dark": "Behave-dark.qss"}


def put_on(style: str) -> None:
    """A style sheet of FreeCAD's, as its preferences put one on."""
    text = ""
    if style:
        places = (App.getResourceDir(), App.getHomePath(), "/usr/share/freecad")
        paths = [os.path.join(place, "Gui", "Stylesheets", style) for place in places]
        with open(next(filter(os.path.isfile, paths)), encoding="utf-8") as file:
            text = file.read()
    QtGui.QApplication.instance().setStyleSheet(text)


def taken_in(name: str):
    """Every panel, opened, used, taken and cancelled."""
    yield from prepared()
    put_on(STYLES[name])
    try:
        for title, (opener, used, _) in PANELS.items():
            opener()
            yield from until(is_shown, f"the panel {title}")
            used()
            yield from settled()
            assert panel().isVisible()
            picture(f"{name}-{title}")
            yield from press_if_there("Cancel", "Close")
            yield from until(lambda: not Gui.Control.activeDialog(), f"{title} to close")
    finally:
        put_on("")


def test_every_panel_in_light():
    yield from taken_in("light")


def test_every_panel_in_dark():
    yield from taken_in("dark")
