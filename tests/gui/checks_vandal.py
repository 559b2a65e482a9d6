# SPDX-License-Identifier: LGPL-2.1-or-later
"""A vandal who does anything in any order, with a seed, and what must hold after every act.

No traceback; without a panel no open step, no drawing of ours in a view, a selection that works.
Cancel gives back what was before the panel; undoing everything and redoing it changes nothing, nor
does computing again, nor saving and opening.
"""

import gc
import math
import os
import random

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import vandal_acts
from desk import POLL, WORK, clear_report_view, report_view, settled, until, view
from freecad.sheetmorph.objects import model
from hostile_panels import prepared
from hostile_traces import children, child_processes, is_selecting, open_steps, overlays
from hostile_traces import surprises
from PySide import QtGui
from scenes import assembly, largest, stored_of_all

__all__ = ["test_a_vandal_finds_nothing"]
SEED = int(os.environ.get("SHEETMORPH_VANDAL_SEED", 1))
ACTS = int(os.environ.get("SHEETMORPH_VANDAL_ACTS", 60))
IN_A_HURRY = 0.3  # how often the next act comes before all is over that the last one has begun
TOLD = 40  # acts before a fault
CLOSE = 1e-3  # mm: stored meshes are in single precision
UNSAID = ("Proxy", "ExpressionEngine", "Visibility", "Label2")  # properties that are no data


def test_a_vandal_finds_nothing():
    yield from Vandal(SEED).go_on_for(ACTS)


class Vandal:
    """Acts by chance until something does not hold."""

    def __init__(self, seed: int):
        self._seed, self._chance = seed, random.Random(seed)
        self._done: list[str] = []
        self._before = None  # document and its state when the panel was opened
        self._clean: list[str] = []  # what lies over a view in which nothing is going on

    def go_on_for(self, count: int):
        answers = vandal_acts.Answers(random.Random(self._seed))
        try:
            for number in range(count):
                if not vandal_acts.model_in(App.ActiveDocument):
                    yield from self._begin()
                yield from self._act(number)
        except Exception as error:
            told = " ".join(self._done[-TOLD:])
            raise AssertionError(f"seed {self._seed}, after {told}:\n{error}") from error
        finally:
            answers.deleteLater()

    def _begin(self):
        """Closes everything and makes the document again."""
        Gui.Control.closeDialog()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        yield POLL
        yield from prepared()
        self._clean = overlays(view())
        App.ActiveDocument.saveAs(os.path.join(WORK, "vandal.FCStd"))
        self._before = None

    def _act(self, number: int):
        act = self._next()
        self._done.append(act.__name__)
        print(f"vandal {self._seed}, act {number}: {act.__name__}", flush=True)
        was_open, before = bool(Gui.Control.activeDialog()), self._before
        if not was_open:
            before = (App.ActiveDocument, state(App.ActiveDocument))
        yield from act(self._chance)
        yield from until(is_calm, "the program to be calm")
        assert not surprises(), report_view()
        self._before = before if act in vandal_acts.WITHIN or not was_open else None
        if self._chance.random() < IN_A_HURRY:
            return
        yield from settled()
        if not Gui.Control.activeDialog():
            assert not left(self._clean), "\n".join(left(self._clean))
            self._before = None
        if act is cancel and before and not Gui.Control.activeDialog():
            assert_alike(before[1], state(before[0]), "Cancel")
        clear_report_view()

    def _next(self):
        if Gui.Control.activeDialog():
            acts = vandal_acts.IN_PANEL | {cancel: 4}
        else:
            acts = vandal_acts.OUTSIDE | {there_and_back: 1, compute_again: 1, open_again: 1}
        acts = acts | vandal_acts.ANYWHERE
        return self._chance.choices(list(acts), list(acts.values()))[0]


# -- what must change nothing


def cancel(chance):
    if chance.random() < 0.3:
        Gui.Control.closeDialog()
        yield POLL
    else:
        yield from vandal_acts.press_button(chance, ("Cancel", "Close"))


def there_and_back(_chance):
    """All steps undone and done again."""
    document = App.ActiveDocument
    count, before = document.UndoCount, state(document)
    for _ in range(count):
        document.undo()
        yield POLL
    for _ in range(count):
        document.redo()
        yield POLL
    assert_alike(before, state(document), "undo and redo")


def compute_again(_chance):
    """The result is that of the properties, not of how they came to be."""
    document = App.ActiveDocument
    document.recompute()
    yield POLL
    if model.failure_of(assembly()):
        return
    before = stored_of_all()
    for part in model.parts(assembly()):
        part.Deformation.touch()
    document.recompute()
    yield POLL
    after = stored_of_all()
    assert before.shape == after.shape and largest(after - before) < CLOSE, "computed otherwise"


def open_again(_chance):
    """Saved, closed and opened."""
    path = os.path.join(WORK, "vandal-again.FCStd")
    App.ActiveDocument.recompute()
    yield POLL
    before = state(App.ActiveDocument)
    App.ActiveDocument.saveAs(path)
    App.closeDocument(App.ActiveDocument.Name)
    yield POLL
    document = App.openDocument(path)
    yield POLL
    assert_alike(before, state(document), "saving and opening")


# -- what must hold


def is_calm() -> bool:
    documents = App.listDocuments().values()
    is_busy = any(one.Recomputing or one.Restoring or one.Transacting for one in documents)
    return not is_busy and QtGui.QApplication.activeModalWidget() is None


def left(clean: list[str]) -> list[str]:
    """What is wrong while no panel is open."""
    faults = []
    if surprises():
        faults.append(report_view())
    faults += open_steps()
    if not gc.isenabled():
        faults.append("garbage is not collected any more")
    if QtGui.QApplication.overrideCursor() is not None:
        faults.append("the cursor of waiting stays")
    faults += [f"a process is left: {line}" for line in child_processes()]
    for name in App.listDocuments():
        faults += left_in_views(Gui.getDocument(name), clean)
        faults += [
            f"{obj.Name} is not drawn any more"
            for obj in App.getDocument(name).Objects
            if model.kind(obj) == model.PART
            and obj.ViewObject.Visibility
            and obj.ViewObject.SwitchNode.whichChild.getValue() < 0
        ]
    return faults


def left_in_views(document, clean: list[str]) -> list[str]:
    faults = []
    for one in document.mdiViewsOfType("Gui::View3DInventor"):
        names = [child.getName().getString() for child in children(one.getSceneGraph())]
        faults += [f"{name} stays in the view" for name in names if name.startswith("SheetMorph")]
        faults += [f"{name} stays over the view" for name in overlays(one) if name not in clean]
        if not is_selecting(one):
            faults.append("the view selects nothing any more")
    return faults


def state(document) -> dict:
    """All data of a document: by object and property, as text, meshes as their points."""
    return {
        obj.Name: {
            name: said(getattr(obj, name)) for name in obj.PropertiesList if name not in UNSAID
        }
        for obj in document.Objects
    }


def said(value):
    if hasattr(value, "CountPoints"):
        return np.array([tuple(point.Vector) for point in value.Points])
    if hasattr(value, "Name") and hasattr(value, "Document"):
        return value.Name
    if isinstance(value, (list, tuple)):
        return [said(each) for each in value]
    if hasattr(value, "exportBrepToString"):
        return f"{len(value.Faces)} faces, {len(value.Edges)} edges"
    value = getattr(value, "Value", value)
    return value if isinstance(value, float) else repr(value)


def assert_alike(before: dict, after: dict, what: str) -> None:
    assert before.keys() == after.keys(), f"{what} changed objects: {before.keys() ^ after.keys()}"
    for obj, properties in before.items():
        for name, value in properties.items():
            other = after[obj].get(name)
            text = "" if isinstance(value, np.ndarray) else f": {value} was, {other} is"
            assert is_alike(value, other), f"{what} changed {obj}.{name}{text}"


def is_alike(one, other) -> bool:
    """A document keeps sixteen digits of a number, of a mesh seven."""
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-9, abs_tol=1e-12)
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.shape == other.shape and (not len(one) or largest(one - other) < CLOSE)
    return one == other
