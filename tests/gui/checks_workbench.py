# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench as a whole: panels open and close, examples open, the tree does what it should."""

import subprocess
from functools import lru_cache
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import settling
from desk import activate, child, click_point, laid_out, on_screen, panel, press, press_tool
from desk import settled, tools_called, until, xdotool
from freecad.sheetmorph import actions, api, paths, subject
from freecad.sheetmorph.commands import exchange
from freecad.sheetmorph.objects import model, watcher
from freecad.sheetmorph.qt import QtCore, QtWidgets, draw, frame_of
from pivy import coin
from scenes import assembly, new_morph, part, regions

__all__ = [
    "test_panels_open_and_close_again_and_again",
    "test_a_dialog_that_opens_late_lets_the_test_go_on",
    "test_a_panel_is_whole_and_stays_so_under_a_press",
    "test_every_example_opens_and_is_up_to_date",
    "test_who_watches_documents_does_not_lead_a_new_one_astray",
    "test_a_double_click_picks_a_region_anew",
    "test_ok_with_nothing_picked_says_what_to_do",
    "test_what_a_click_would_take_lights_up",
    "test_a_removed_part_gives_its_source_back_to_the_view",
    "test_the_help_of_freecad_has_the_manual",
    "test_no_command_fails_when_asked_whether_it_is_active",
    "test_commands_look_at_no_document_before_there_is_a_morph",
    "test_commands_know_the_morphs_that_came_and_went",
    "test_an_error_is_told_as_freecad_tells_its_own",
]


def test_panels_open_and_close_again_and_again():
    yield from new_morph()
    tools = ["Mark Fixed Region…", "Mark Form Features…", "Move Handle…"] * 4
    for number, tool in enumerate(tools):
        yield from press_tool(tool)
        assert Gui.Control.activeDialog(), f"{tool} did not open in round {number}"
        yield from press("Cancel")
    assert App.ActiveDocument.UndoNames == []


def test_a_dialog_that_opens_late_lets_the_test_go_on():
    """Of a click that FreeCAD had not read yet when the test had sent it."""
    yield from new_morph()
    (tool,) = tools_called("Import Part…")
    place = tool.mapToGlobal(tool.rect().center())
    words = ["xdotool", "mousemove", place.x(), place.y(), "sleep", 0.1, "click", 1, "sleep", 0.2]
    subprocess.run(list(map(str, words)), check=True)
    settling.receive()
    yield from until(QtWidgets.QApplication.activeModalWidget, "the dialog")
    QtWidgets.QApplication.activeModalWidget().close()
    yield from settled()


def test_a_panel_is_whole_and_stays_so_under_a_press():
    yield from new_morph()
    yield from press_tool("Mark Fixed Region…")
    docks = Gui.getMainWindow().findChildren(QtWidgets.QDockWidget)
    (dock,) = [one for one in docks if one.isAncestorOf(panel())]
    frame = frame_of(dock)
    if frame is not dock:  # beside the view no dock becomes narrower than its panel
        draw(frame, 250)
        yield from laid_out()
        assert abs(frame.width() - 250) < 5, "the user wants it narrower"
    yield from press("Cancel")
    yield from press_tool("Mark Fixed Region…")
    places = {"view": on_screen((40, 12, 0)), "panel": middle(child("message"))}
    for name, place in places.items():
        yield from xdotool("mousemove", *place, "mousedown", 1)
        yield from laid_out()
        buttons = panel().findChildren(QtWidgets.QPushButton)
        cut = [one.objectName() for one in buttons if shown_width(one) < one.width()]
        yield from xdotool("mouseup", 1)
        assert not cut, (name, cut)
    yield from press("Cancel")
    if frame is not dock:
        kept = App.ParamGet("User parameter:BaseApp/MainWindow/DockWindows/OverlayRight")
        assert abs(kept.GetInt("Width") - 250) < 5, "the user's width comes back"


def middle(widget) -> tuple[int, int]:
    """Where the middle of a widget is on the screen."""
    place = widget.mapToGlobal(widget.rect().center())
    return place.x(), place.y()


def shown_width(widget) -> int:
    """How much of a widget's width nothing round it cuts off; all of one that is not shown."""
    return widget.visibleRegion().boundingRect().width() if widget.isVisible() else widget.width()


def test_every_example_opens_and_is_up_to_date():
    yield from activate()
    recipes = exchange.example_recipes()
    assert "Door Mirror" in recipes
    for title, recipe in recipes.items():
        assert exchange.open_recipe(recipe, title.replace(" ", ""))
        yield from settled()
        for shown in model.parts(assembly()):
            assert shown.State == ["Up-to-date"], (title, shown.Label, shown.State)
        assert regions("handle"), title


class KeepsActive:
    """Watches documents: one stays the active one whatever others are made."""

    def __init__(self, kept):
        self.kept = kept

    def slotCreatedDocument(self, _document) -> None:
        """FreeCAD calls this."""
        App.setActiveDocument(self.kept)


def test_who_watches_documents_does_not_lead_a_new_one_astray():
    yield from activate()
    kept = App.newDocument("Kept")
    watcher = KeepsActive(kept.Name)
    App.addDocumentObserver(watcher)
    try:
        made = actions.new_document("Made")
        yield from until(lambda: App.ActiveDocument == kept, "the watcher's document is active")
        assert exchange.open_recipe(exchange.example_recipes()["Door Mirror"], "Mirror")
    finally:
        App.removeDocumentObserver(watcher)
    yield from settled()
    held = {name: len(document.Objects) > 0 for name, document in App.listDocuments().items()}
    assert held == {"Kept": False, made.Name: False, "Mirror": True}


def test_a_double_click_picks_a_region_anew():
    yield from new_morph()
    fixed = regions("fixed")[0]
    before = model.vertices(fixed).tolist()
    assert fixed.ViewObject.Proxy.doubleClicked(fixed.ViewObject)
    yield from settled()
    assert f"{len(before)} vertices" in child("count").text()
    child("facet").click()
    yield from click_point((60.5, 12.0, 0), "shift")
    yield from press("OK")
    assert len(model.vertices(fixed)) == len(before) + 3
    assert App.ActiveDocument.UndoNames == ["Mark Fixed Region"]
    App.ActiveDocument.undo()
    assert model.vertices(fixed).tolist() == before


def test_ok_with_nothing_picked_says_what_to_do():
    yield from new_morph()
    yield from press_tool("Mark Handle…")
    yield from press("OK")
    assert "click on the part" in child("message").text()
    yield from press("Cancel")
    assert len(regions("handle")) == 1


def test_what_a_click_would_take_lights_up():
    yield from new_morph()
    yield from press_tool("Mark Fixed Region…")
    child("facet").click()
    before = visible_patches()
    x, y = on_sheet()
    yield from xdotool("mousemove", x - 2, y)
    yield from xdotool("mousemove", x, y)
    assert visible_patches() == before + 1
    yield from xdotool("mousemove", x - 500, y - 200)
    yield from until(lambda: visible_patches() == before, "the light to go out")
    yield from press("Cancel")


def test_a_removed_part_gives_its_source_back_to_the_view():
    yield from new_morph()
    shown, source = part(), part().Source
    assert not source.ViewObject.Visibility
    held = regions("fixed") + regions("handle") + regions("form feature")
    assert shown.ViewObject.Proxy.claimChildren() == [*held, source]
    api.remove(shown)
    yield from settled()
    assert source.ViewObject.Visibility
    assert regions("fixed") == []


def test_the_help_of_freecad_has_the_manual():
    yield from activate()
    entries = Gui.getMainWindow().menuBar().actions()
    (menu,) = [action.menu() for action in entries if action.text().replace("&", "") == "Help"]
    entries = [action for action in menu.actions() if action.text() == "SheetMorph &Manual"]
    (entry,) = entries
    assert entry.isEnabled()
    # What FreeCAD opens for an entry that is clicked on in the mode "What's This?".
    assert entry.whatsThis() in (paths.manual_of("SheetMorph_Manual"), entry.statusTip())


def test_no_command_fails_when_asked_whether_it_is_active():
    yield from activate()
    names = [name for name in Gui.listCommands() if name.startswith("SheetMorph_")]
    assert len(names) >= 12
    active = {name for name in names if Gui.Command.get(name).isActive()}
    always = {"Guide", "CreateMorph", "ImportPart", "ImportRecipe", "OpenExample"}
    always |= {"CheckInstallation", "Manual"}
    assert active == {f"SheetMorph_{name}" for name in always}
    yield from new_morph()
    Gui.Selection.clearSelection()
    active = {name for name in names if Gui.Command.get(name).isActive()}
    wanting = {
        f"SheetMorph_{name}" for name in ("AddPart", "FindContacts", "MarkContact", "SetPrimary")
    }
    wanting |= {
        f"SheetMorph_{name}"
        for name in ("BlendPoses", "CopyInPose", "DeformedShape", "FollowShape")
    }
    selected = ("FeatureSettings", "GroupFeatures", "MakeCoaxial", "KeepDistance", "ApplyPose")
    selected += ("EditRegion", "EditContact", "ToggleContact")
    wanting |= {f"SheetMorph_{name}" for name in selected}
    assert active == set(names) - wanting, (set(names) - wanting) ^ active


class Untouched:
    """A document that nobody looks at."""

    def __getattr__(self, name: str):
        raise AssertionError(f"the document was asked for its {name}")


def test_commands_look_at_no_document_before_there_is_a_morph():
    yield from activate()
    names = [name for name in Gui.listCommands() if name.startswith("SheetMorph_")]
    none_yet = lru_cache(maxsize=1)(lambda: None)
    with mock.patch.object(watcher, "watch", none_yet), mock.patch.object(subject, "App") as app:
        app.ActiveDocument = Untouched()
        active = [name for name in names if Gui.Command.get(name).isActive()]
        assert subject.assemblies() == [] and subject.selected(subject.PART) == []
    assert "SheetMorph_CreateMorph" in active and "SheetMorph_MoveHandle" not in active


def test_commands_know_the_morphs_that_came_and_went():
    yield from new_morph()
    document, first = App.ActiveDocument, assembly()
    assert subject.assemblies() == [first]
    document.openTransaction("Another morph")
    second = api.create_assembly(document)
    document.commitTransaction()
    name = second.Name
    assert subject.assemblies() == [first, second]
    document.undo()
    assert subject.assemblies() == [first]
    document.redo()
    assert [morph.Name for morph in subject.assemblies()] == [first.Name, name]
    document.removeObject(name)
    assert subject.assemblies() == [first]
    App.newDocument("Other")
    assert subject.assemblies() == []
    App.closeDocument(App.ActiveDocument.Name)
    App.setActiveDocument(document.Name)
    assert subject.assemblies() == [first]


def test_an_error_is_told_as_freecad_tells_its_own():
    yield from activate()
    wishes = App.ParamGet("User parameter:BaseApp/Preferences/NotificationArea")
    has_area = hasattr(App.Console, "PrintTranslatedUserError")
    modal = QtWidgets.QApplication.activeModalWidget
    try:
        for sentence, in_a_box in (("first fault", not has_area), ("second fault", True)):
            QtCore.QTimer.singleShot(0, lambda text=sentence: actions.tell("Move Handle", text))
            yield from until(lambda text=sentence: text in words_on_top(), sentence)
            assert (modal() is not None) == in_a_box, sentence
            if in_a_box:
                modal().accept()
            wishes.SetBool("NonIntrusiveNotificationsEnabled", False)
    finally:
        wishes.RemBool("NonIntrusiveNotificationsEnabled")


def words_on_top() -> str:
    """What boxes and FreeCAD's notifications say."""
    shown = [w for w in QtWidgets.QApplication.topLevelWidgets() if w.isVisible()]
    return " ".join(
        w.text() for w in shown if isinstance(w, (QtWidgets.QMessageBox, QtWidgets.QLabel))
    )


def visible_patches() -> int:
    """How many patches of the part are drawn now."""
    root = part().ViewObject.RootNode
    children = [root.getChild(k) for k in range(root.getNumChildren())]
    switches = [c for c in children if c.isOfType(coin.SoSwitch.getClassTypeId())]
    switches = [s for s in switches if s != part().ViewObject.SwitchNode]
    return sum(s.whichChild.getValue() == coin.SO_SWITCH_ALL for s in switches)


def on_sheet() -> tuple[int, int]:
    """A place on the screen where the sheet is seen."""
    return on_screen((20.5, 12.0, 0))
