# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet as steel, as the guide says it: the energy chosen, dragged, stretch seen, laid flat."""

import FreeCAD as App
import FreeCADGui as Gui
from checks_flow import select
from checks_moving import open_panel
from checks_tutorial import menu
from desk import child, choose_below, enter, picture, press, settled, show_docks, until, xdotool
from freecad.sheetmorph import api
from PySide import QtCore, QtGui
from scenes import assembly, drawn, largest, new_morph, part, regions, stored

__all__ = ["test_a_sheet_as_steel_is_dragged_and_laid_flat_as_the_guide_says"]

Qt = QtCore.Qt


def row_called(model, name: str, parent):
    """The index of a property in FreeCAD's property editor, None if it is not listed."""
    for row in range(model.rowCount(parent)):
        index = model.index(row, 0, parent)
        if model.data(index, Qt.DisplayRole) == name:
            return index
        found = row_called(model, name, index)
        if found is not None:
            return found
    return None


def property_editors() -> list:
    """The tree of properties that is seen, in a list."""
    views = Gui.getMainWindow().findChildren(QtGui.QTreeView)
    kinds = [(view, view.metaObject().className()) for view in views]
    return [view for view, kind in kinds if "PropertyEditor" in kind and view.isVisible()]


def choose_property(obj, name: str, steps: int):
    """Selects an object and moves a list of its in the property editor so many entries down."""
    show_docks()
    select(obj)
    yield from until(lambda: len(property_editors()) == 1, "the property editor")
    (editor,) = property_editors()
    yield from until(lambda: row_called(editor.model(), name, QtCore.QModelIndex()), name)
    index = row_called(editor.model(), name, QtCore.QModelIndex())
    value = editor.model().index(index.row(), 1, index.parent())
    editor.scrollTo(value)
    yield from settled()
    place = editor.viewport().mapToGlobal(editor.visualRect(value).center())
    yield from xdotool("mousemove", place.x(), place.y(), "click", 1)
    yield from until(lambda: editor.findChildren(QtGui.QComboBox), "its list")
    yield from settled()
    (combo,) = editor.findChildren(QtGui.QComboBox)
    yield from choose_below(combo, steps)
    yield from xdotool("key", "Return")
    yield from settled()


def test_a_sheet_as_steel_is_dragged_and_laid_flat_as_the_guide_says():
    yield from new_morph()
    yield from choose_property(assembly(), "Energy", 3)
    assert assembly().Energy == "steel"
    select(regions("handle")[0])
    yield from open_panel()
    yield from enter(child("translation_z"), "18")
    yield from until(lambda: "Final steel shape" in child("status").text(), "the steel")
    yield from choose_below(child("colours"), 4)
    yield from until(lambda: "stretch" in child("scale_text").text(), "the stretch")
    picture("steel-stretch")
    yield from press("OK")
    assert largest(drawn() - stored()) == 0.0
    before = {entry.Name for entry in App.ActiveDocument.Objects}
    select(part())
    yield from menu("SheetMorph", "Flatten")
    labels = [part().Label + end for end in (" blank", " bend lines", " at rest blank")]
    labels.append(part().Label + " at rest bend lines")

    def made() -> list:
        return [o for o in App.ActiveDocument.Objects if o.Name not in before]

    yield from until(lambda: len(made()) == 4, "the blanks")
    assert sorted(o.Label for o in made()) == sorted(labels)
    boxes = sorted((o.Shape.BoundBox for o in made() if "blank" in o.Label), key=lambda b: b.XMin)
    assert part().Mesh.BoundBox.XMax < boxes[0].XMin and boxes[0].XMax < boxes[1].XMin
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()
    picture("steel-blanks")
    yield from menu("Edit", "Std_Undo")
    yield from until(lambda: not made(), "the undo")
    assert api.rest_mesh(part())[0].shape == stored().shape
