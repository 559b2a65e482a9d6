# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel may have left behind: nodes, widgets, a dead selection, open steps."""

import gc
import glob

import FreeCAD as App
import FreeCADGui as Gui
from desk import WORK, report_view
from freecad.sheetmorph import generations
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import motion_of
from pivy import coin
from PySide import QtGui
from scenes import regions


class Traces:
    """What there is in the scene and over the view, so that it can be compared later."""

    def __init__(self):
        found = Gui.activeDocument().mdiViewsOfType("Gui::View3DInventor")
        self.widgets = {str(v): overlays(v) for v in found}
        self.roots = {node_of(child) for v in found for child in children(v.getSceneGraph())}
        self.nodes = {
            obj.Name: count(obj.ViewObject.RootNode)
            for obj in App.ActiveDocument.Objects
            if model.kind(obj) == model.PART
        }

    def compare(self) -> list[str]:
        """What was not there before, in words."""
        faults = []
        providers = {node_of(o.ViewObject.RootNode) for o in App.ActiveDocument.Objects}
        for one in Gui.activeDocument().mdiViewsOfType("Gui::View3DInventor"):
            for child in children(one.getSceneGraph()):
                known = node_of(child) in self.roots or node_of(child) in providers
                if not known and child.getName().getString().startswith("SheetMorph"):
                    faults.append(f"{child.getName()} stays in the view")
                elif not known and child.isOfType(coin.SoAnnotation.getClassTypeId()):
                    faults.append("an annotation stays in the view")
            if overlays(one) != self.widgets.get(str(one), overlays(one)):
                faults.append(f"over the view: {overlays(one)}")
            if not is_selecting(one):
                faults.append("the view selects nothing any more")
        for name, nodes in self.nodes.items():
            obj = App.ActiveDocument.getObject(name)
            if obj is not None and count(obj.ViewObject.RootNode) != nodes:
                faults.append(f"{count(obj.ViewObject.RootNode)} nodes in {name}, not {nodes}")
            if obj is not None and obj.ViewObject.SwitchNode.whichChild.getValue() < 0:
                faults.append(f"{name} is not drawn any more")
        return faults


def is_selecting(one) -> bool:
    """Whether a view selects what is clicked on."""
    fields = map(one.getSceneGraph().getField, generations.SELECTION_SWITCHES)
    switch = next(field for field in fields if field is not None)
    return switch.get().getString() == "TRUE"


def node_of(node) -> int:
    return int(node.this)


def children(group) -> list:
    return [group.getChild(k) for k in range(group.getNumChildren())]


def overlays(one) -> list[str]:
    """The widgets that lie over a view."""
    found = one.graphicsView().viewport().findChildren(QtGui.QWidget)
    return sorted(widget.objectName() or type(widget).__name__ for widget in found)


def count(root) -> int:
    """All nodes under a root, those of switches that are off too."""
    search = coin.SoSearchAction()
    search.setType(coin.SoNode.getClassTypeId())
    search.setSearchingAll(True)
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(root)
    return search.getPaths().getLength()


def child_processes() -> list[str]:
    """The studies that FreeCAD has started and that are alive, one line each."""
    found = []
    for folder in glob.glob("/proc/[0-9]*"):
        try:
            with open(f"{folder}/cmdline", encoding="utf-8") as file:
                words = file.read().split("\0")
            with open(f"{folder}/environ", "rb") as file:
                environment = file.read().split(b"\0")
        except OSError:
            continue  # it has just ended, or is another user's
        is_ours = f"SHEETMORPH_GUI_WORK={WORK}".encode() in environment
        if is_ours and "study" in words and any("sheetmorph" in word for word in words):
            found.append(" ".join(words))
    return found


def motions() -> dict:
    return {r.Name: motion_of(r) for r in regions("handle")}


def surprises() -> bool:
    """Whether an error was met by nobody."""
    return "Traceback" in report_view()


def open_steps() -> list[str]:
    """The undo steps that are open, of the program and of documents, in words.

    FreeCAD itself leaves one open, called Delete, when a script removes an object.
    """
    opened = App.getActiveTransaction()
    faults = [] if opened is None else [f"an open step: {opened}"]
    documents = [one for one in App.listDocuments().values() if one.HasPendingTransaction]
    titles = [(one.Name, one.UndoNames[0]) for one in documents]
    return faults + [f"{name} has an open step: {t}" for name, t in titles if t != "Delete"]


def left(traces, before) -> list[str]:
    """What is wrong after a panel has ended."""
    faults = []
    if surprises() or ("Error" in report_view() and "Traceback" not in report_view()):
        faults.append(report_view())
    if Gui.Control.activeDialog():
        faults.append("the panel is still there")
        Gui.Control.closeDialog()
    faults += open_steps()
    App.closeActiveTransaction(True)
    faults += [f"a process is left: {line}" for line in child_processes()]
    if not gc.isenabled():
        faults.append("garbage is not collected any more")
    if App.ActiveDocument is None:
        return faults
    for obj, motion in motions().items():
        if motion != before.get(obj, motion):
            faults.append(f"{obj} moved: {motion}")
    return faults + traces.compare()
