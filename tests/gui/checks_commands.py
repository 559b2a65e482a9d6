# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands say what they need, and context menus offer what applies to the selection."""

import FreeCAD as App
import FreeCADGui as Gui
from desk import activate, press, press_tool, settled, until, xdotool
from freecad.sheetmorph import commands
from PySide import QtCore, QtGui
from scenes import assembly, contacts, labelled, new_assembly, new_morph, part, regions

__all__ = [
    "test_the_tooltip_of_a_disabled_command_says_what_it_needs",
    "test_tooltips_follow_the_language",
    "test_the_menu_of_the_view_offers_what_applies",
    "test_commands_suit_what_is_selected",
]


def action(name: str):
    """The action of a command."""
    return Gui.getMainWindow().findChild(QtGui.QAction, f"SheetMorph_{name}")


def tip(name: str) -> str:
    """The tooltip of a command, after FreeCAD has looked whether it is available."""
    Gui.Command.get(f"SheetMorph_{name}").isActive()
    return action(name).toolTip()


def select(*objects) -> None:
    """Selects objects as a click in the tree does."""
    Gui.Selection.clearSelection()
    for obj in objects:
        Gui.Selection.addSelection(obj)


def test_the_tooltip_of_a_disabled_command_says_what_it_needs():
    yield from activate()
    assert "Create a morph or import a part first." in tip("MoveHandle")
    assert "first." not in tip("ImportPart")
    yield from new_morph()
    plain = tip("MoveHandle")
    assert "Moves and turns a handle" in plain and "first." not in plain
    assert "Select a form feature first." in tip("FeatureSettings")
    assert action("FeatureSettings").statusTip() == "Select a form feature first."
    select(*regions("form feature"))
    assert "Select a form feature first." in tip("FeatureSettings")
    assert "first." not in tip("KeepDistance")
    yield from press_tool("Mark Fixed Region…")
    assert tip("MoveHandle") == f"{plain}<p><b>Close the open panel first.</b></p>"
    assert not Gui.Command.get("SheetMorph_MoveHandle").isActive()
    yield from press("Cancel")
    assert tip("MoveHandle") == plain


def test_tooltips_follow_the_language():
    yield from new_morph()
    Gui.Selection.clearSelection()
    assert "Select a form feature first." in tip("FeatureSettings")
    try:
        Gui.setLocale("German")
        yield from settled()
        said = tip("FeatureSettings")
        assert "Wählen Sie zuerst ein Formelement." in said and "Select" not in said, said
    finally:
        Gui.setLocale("English")
        yield from settled()
    assert tip("FeatureSettings").count("first.") == 1


def texts_of(menu) -> list[str]:
    """The entries of a menu, without mnemonics."""
    return [entry.text().replace("&", "") for entry in menu.actions()]


def test_the_menu_of_the_view_offers_what_applies():
    yield from new_morph()
    viewport = Gui.activeDocument().activeView().graphicsView().viewport()
    place = viewport.mapToGlobal(QtCore.QPoint(30, 30))
    for chosen, there, absent in (
        ((), "Move Handle…", "Mark Handle…"),
        ((part(),), "Mark Handle…", "Move Handle…"),
    ):
        select(*chosen)
        yield from settled()
        yield from xdotool("mousemove", place.x(), place.y(), "click", 3)
        yield from until(QtGui.QApplication.activePopupWidget, "the context menu")
        said = texts_of(QtGui.QApplication.activePopupWidget())
        yield from xdotool("key", "Escape")
        yield from until(lambda: not QtGui.QApplication.activePopupWidget(), "its end")
        assert there in said and absent not in said, said


def suiting(*objects) -> set[str]:
    """The commands, without prefix, that are offered for selected objects."""
    select(*objects)
    return {name.partition("_")[2] for name in commands.suiting(list(objects))} - {""}


def test_commands_suit_what_is_selected():
    yield from new_assembly(is_joined=True)
    assert {"MarkFixed", "SetPrimary"} < suiting(labelled("bracket"))
    assert "SetPrimary" not in suiting(part())
    assert suiting(regions("fixed")[0]) == {"EditRegion"}
    assert suiting(regions("handle")[0]) == {"EditRegion", "MoveHandle", "ResetMotion"}
    assert suiting(*regions("form feature")) == {"GroupFeatures", "MakeCoaxial", "KeepDistance"}
    assert suiting(contacts()[0]) == {"EditContact", "ToggleContact", "Propagation"}
    assert suiting(part().Source) == {"CreateMorph", "AddPart"}
    assert {"MoveHandle", "FindContacts"} < suiting(assembly())
    App.newDocument("Empty")
    assert suiting() == {"Guide", "ImportPart"}
