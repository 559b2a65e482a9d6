# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that leads through a morph: what is done, what is missing, what to press."""

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
    """Shows the steps; ``run(command name)`` and ``closed()`` are told to the guide behind it."""

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
        """Shows what the document says now; ``commands``: all of the workbench by name."""
        facts, faulty = guide_facts.read()
        owner = subject.assembly()
        say(self.form.morph, f"<b>{owner.Label}</b>" if owner else "")
        for step in guide.steps(facts):
            self._steps[step.key].show(step, commands)
        if faulty != self._faulty:
            self._faulty = faulty
            self._show_faulty()

    def getStandardButtons(self) -> int:
        """Close: what was done stays."""
        return number(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterSelection(self) -> bool:
        """Meshes are selected in the tree to become parts."""
        return True

    def isAllowedAlterDocument(self) -> bool:
        """Nothing is open in the document: undo and every command are welcome."""
        return True

    def accept(self) -> bool:
        """Return in the panel is no wish to close it."""
        return False

    def _show_faulty(self) -> None:
        """Selects the regions that a failure names, and lights up where they are."""
        self._highlight.clear()
        for obj in self._faulty:
            Gui.Selection.addSelection(obj)
            for part, vertices in seen.places_of(obj):
                shown = seen.triangles(part)
                self._highlight.paint(part.ViewObject, shown, colours.FAULT, vertices.tolist())
