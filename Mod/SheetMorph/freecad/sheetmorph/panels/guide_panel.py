# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that leads through a morph: steps, missing objects and buttons."""

import FreeCADGui as Gui

from freecad.sheetmorph import subject
from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.editing.session import Session
from freecad.sheetmorph.panels import guide_facts
from freecad.sheetmorph.panels.base import Panel, say
from freecad.sheetmorph.panels.guide_step import StepView
from freecad.sheetmorph.qt import QtWidgets, number
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import Highlight
from freecad.sheetmorph.tools import guide

COMMANDS = {
    guide.PARTS: ("CreateMorph", "ImportPart", "AddPart"),
    guide.FIXED: ("MarkFixed",),
    guide.FEATURES: ("FindFeatures", "MarkFeature"),
    guide.CONTACTS: ("FindContacts", "MarkContact", "Propagation"),
    guide.HANDLE: ("MarkHandle",),
    guide.DRAG: ("MoveHandle", "ResetMotion", "SavePose", "Study", "ExportParts"),
}


class GuidePanel(Panel):
    """The steps of a morph, with callbacks `run(command name)` and `closed()`."""

    width = 380

    def __init__(self, run, closed):
        super().__init__(Session(), "guide", "Guide", "Guide")
        self._faulty = []
        self._highlight = self.session.show(Highlight())
        self.session.over.connect(closed)
        self._steps = {key: StepView(self.form, key, COMMANDS[key]) for key in guide.STEPS}
        for step in self._steps.values():
            step.connect(run)

    def refresh(self, commands) -> None:
        """Show the state of the document; `commands` maps names to all commands."""
        facts, faulty = guide_facts.read()
        owner = subject.assembly()
        say(self.form.morph, f"<b>{owner.Label}</b>" if owner else "")
        for step in guide.steps(facts):
            self._steps[step.key].show(step, commands)
        if faulty != self._faulty:
            self._faulty = faulty
            self._show_faulty()

    def getStandardButtons(self) -> int:
        """Return Close, since there are no changes to cancel."""
        return number(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterSelection(self) -> bool:
        """Return True, since meshes are selected in the tree to become parts."""
        return True

    def isAllowedAlterDocument(self) -> bool:
        """Return True, since the panel has no open transaction."""
        return True

    def accept(self) -> bool:
        """Return False, since the Return key must not close the panel."""
        return False

    def _show_faulty(self) -> None:
        """Select the regions that a failure names, and highlight their vertices."""
        self._highlight.clear()
        for obj in self._faulty:
            Gui.Selection.addSelection(obj)
            for part, vertices in seen.places_of(obj):
                shown = seen.triangles(part)
                self._highlight.paint(part.ViewObject, shown, colours.FAULT, vertices.tolist())
