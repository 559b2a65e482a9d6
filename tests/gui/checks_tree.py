# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions and parts in the tree: copied, renamed, deleted and edited as other objects are."""

import os

import FreeCAD as App
import FreeCADGui as Gui
from desk import WORK, answered, child, click_point, click_widget, picture, press, say_yes
from desk import settled, show_docks, until
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from hostile_acts import drag_in_tree, show_tab
from PySide import QtCore, QtGui
from scenes import assembly, contacts, labelled, new_assembly, new_morph, part, regions

__all__ = [
    "test_a_region_copied_and_pasted_belongs_to_the_morph",
    "test_a_part_deleted_in_the_tree_takes_its_regions_and_contacts_along",
    "test_a_morph_deleted_in_the_tree_leaves_the_meshes_in_view",
    "test_nothing_hidden_is_said_to_break_when_a_region_or_part_is_deleted",
    "test_a_renamed_region_is_edited_by_a_double_click",
    "test_the_context_menu_of_a_part_marks_a_region_on_it",
    "test_a_region_dragged_in_the_tree",
    "test_the_tree_shows_regions_and_contacts_below_their_parts",
]


def select(*objects) -> None:
    """Selects objects as a click in the tree does."""
    Gui.Selection.clearSelection()
    for obj in objects:
        Gui.Selection.addSelection(obj)


def delete(*objects):
    """Deletes objects as the Del key does; FreeCAD asks first where others link to them."""
    select(*objects)
    with answered(say_yes):
        Gui.runCommand("Std_Delete")
    yield from settled()


def menu_of(obj) -> dict:
    """The entries that our view provider adds to a context menu, by text; a right click selects."""
    menu = QtGui.QMenu()
    select(obj)
    obj.ViewObject.Proxy.setupContextMenu(obj.ViewObject, menu)
    entries = {action.text(): action for action in menu.actions() if action.text()}
    entries["menu"] = menu  # kept: the actions die with it
    return entries


def test_a_region_copied_and_pasted_belongs_to_the_morph():
    yield from new_morph()
    (original,) = regions("fixed")
    select(original)
    Gui.runCommand("Std_Copy")
    yield from settled()
    Gui.runCommand("Std_Paste")
    yield from until(lambda: len(regions("fixed")) == 2, "the copy in the morph")
    copied = regions("fixed")[1]
    assert copied.Part == part() and copied.Label != original.Label
    assert copied in model.deformation_of(assembly()).Regions
    assert model.vertices(copied).tolist() == model.vertices(original).tolist()
    App.ActiveDocument.recompute()
    assert "Invalid" not in part().State
    App.ActiveDocument.undo()
    assert regions("fixed") == [original]


def test_a_part_deleted_in_the_tree_takes_its_regions_and_contacts_along():
    yield from new_assembly(is_joined=True)
    gone, count = part(), len(App.ActiveDocument.Objects)
    source, names = gone.Source, [r.Name for r in model.regions(assembly())]
    yield from delete(gone, regions("handle")[0])
    assert model.regions(assembly()) == []
    assert contacts() == [] and source.ViewObject.Visibility
    assert assembly().Primary == labelled("bracket")
    assert App.ActiveDocument.UndoNames == ["Delete"]
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert len(App.ActiveDocument.Objects) == count
    assert [r.Name for r in model.regions(assembly())] == names
    assert labelled("sheet") == assembly().Primary and len(contacts()) == 1
    assert not source.ViewObject.Visibility


def test_a_morph_deleted_in_the_tree_leaves_the_meshes_in_view():
    yield from new_assembly(is_joined=True)
    yield from delete(assembly())
    left = {obj.Name: obj.ViewObject.Visibility for obj in App.ActiveDocument.Objects}
    assert left == {"sheet": True, "bracket": True, "loose": True}
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert len(model.parts(assembly())) == 3 and len(contacts()) == 1
    assert "Invalid" not in part().State


def test_nothing_hidden_is_said_to_break_when_a_region_or_part_is_deleted():
    yield from new_assembly(is_joined=True)
    for gone in (regions("fixed")[0], labelled("bracket"), labelled("sheet").Source):
        name, asked = gone.Name, []
        select(gone)
        with answered(lambda box, told=asked: told.append(refuse(box))):
            Gui.runCommand("Std_Delete")
        yield from settled()
        if name == "sheet":
            assert "sheet morphed" in asked[0] and "Deformation" not in asked[0], asked
        else:
            assert asked == [] and App.ActiveDocument.getObject(name) is None, asked


def refuse(box) -> str:
    """Closes the question that is asked; returns its words."""
    box.reject()
    return f"{box.text()} {box.informativeText()} {box.detailedText()}"


def test_a_renamed_region_is_edited_by_a_double_click():
    yield from new_morph()
    (region,) = regions("fixed")
    region.Label = "clamp, left"
    before = model.vertices(region).tolist()
    assert region.ViewObject.Proxy.doubleClicked(region.ViewObject)
    yield from settled()
    assert f"{len(before)} vertices" in child("count").text()
    yield from click_widget(child("facet"))
    yield from click_point((20.5, 12.0, 0), "shift")
    picture("tree-region-edited")
    yield from press("OK")
    assert len(model.vertices(region)) == len(before) + 3 and region.Label == "clamp, left"
    App.ActiveDocument.undo()
    assert model.vertices(region).tolist() == before


def test_the_context_menu_of_a_part_marks_a_region_on_it():
    yield from new_assembly(is_joined=True)
    bracket = labelled("bracket")
    assert "Set as Primary" not in menu_of(part())
    entries = menu_of(bracket)
    assert "Set as Primary" in entries and "Follow Shape" not in entries
    entries["Mark Follower…"].trigger()
    yield from settled()
    assert bracket.Label in child("part").text()
    yield from press("Cancel")
    assert {"menu", "Edit Region…"} == set(menu_of(regions("fixed")[0]))
    assert {"Edit Region…", "Move Handle…"} < set(menu_of(regions("handle")[0]))
    (contact,) = contacts()
    entries = menu_of(contact)
    entries["Toggle Contact"].trigger()
    yield from settled()
    assert not contact.Active and App.ActiveDocument.UndoNames == ["Toggle Contact"]
    assert "Edit Contact…" in menu_of(contact)


def places_in_tree() -> dict:
    """By object, what it hangs on."""
    return {obj.Name: sorted(o.Name for o in obj.InList) for obj in App.ActiveDocument.Objects}


def test_a_region_dragged_in_the_tree():
    """It stays in its morph and below its part, and takes nobody's place."""
    yield from new_morph()
    (fixed,), (handle,) = regions("fixed"), regions("handle")
    whole = places_in_tree()
    for target in (App.ActiveDocument, assembly(), part(), part().Source, handle):
        yield from drag_in_tree(fixed.Label, target.Label)
        assert places_in_tree() == whole, target.Label
    while App.ActiveDocument.UndoCount:
        App.ActiveDocument.undo()
    assert places_in_tree() == whole and regions("fixed") == [fixed]


def test_the_tree_shows_regions_and_contacts_below_their_parts():
    yield from new_assembly(is_joined=True)
    show_docks()
    yield from show_tab("Model")
    model_tree().expandAll()  # FreeCAD makes the rows of a part when it is opened
    sheet = ["Fixed", "Handle", "Feature", "Feature001", "Contact", "sheet"]
    bracket = ["Contact", "bracket"]
    yield from tree_shows([sheet, bracket, ["loose"]])
    document = App.ActiveDocument
    document.openTransaction("Follower")
    api.add_follower(assembly(), labelled("bracket"), [0, 1, 2, 3])
    document.commitTransaction()
    yield from tree_shows([sheet, ["Follower", *bracket], ["loose"]])
    document.undo()
    yield from tree_shows([sheet, bracket, ["loose"]])
    document.redo()
    yield from tree_shows([sheet, ["Follower", *bracket], ["loose"]])
    yield from delete(contacts()[0])
    yield from tree_shows([sheet[:4] + sheet[5:], ["Follower", "bracket"], ["loose"]])
    document.undo()
    yield from tree_shows([sheet, ["Follower", *bracket], ["loose"]])
    path = os.path.join(WORK, "tree.FCStd")
    document.saveAs(path)
    App.closeDocument(document.Name)
    App.openDocument(path)
    yield from settled()
    model_tree().expandAll()
    yield from tree_shows([sheet, ["Follower", *bracket], ["loose"]])


def tree_shows(wanted: list[list[str]]):
    """Waits until the tree shows labels below the parts, and has asked all objects for theirs.

    What is deleted and restored before FreeCAD has asked again, within 100 ms, is not shown.
    """
    yield from until(lambda: below() == wanted, f"the tree to show {wanted}")
    timers = model_tree().findChildren(QtCore.QTimer)
    yield from until(lambda: not any(timer.isActive() for timer in timers), "the tree to be calm")


def model_tree():
    """The tree of FreeCAD's model view."""
    trees = Gui.getMainWindow().findChildren(QtGui.QTreeWidget)
    trees = [tree for tree in trees if tree.metaObject().className() == "Gui::TreeWidget"]
    (tree,) = filter(QtGui.QWidget.isVisible, trees)
    return tree


def below() -> list[list[str]]:
    """What the tree shows below each part."""
    (morph,) = model_tree().findItems("Morph", QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
    children = [morph.child(k) for k in range(morph.childCount())]
    found = [[one.child(k).text(0) for k in range(one.childCount())] for one in children]
    return [labels for labels in found if labels]
