# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that blends two poses with a slider and says how far they are apart."""

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.panels import progress
from freecad.sheetmorph.panels.base import Panel, say
from freecad.sheetmorph.panels.live_update import LiveUpdate
from freecad.sheetmorph.qt import translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.updating import ON_OK, Updating

REST = QT_TRANSLATE_NOOP("panels", "At rest")


def open_panel(assembly, pose):
    """Opens the panel from rest to a pose; returns it, None if the user cancels the set-up."""
    if Gui.Control.activeDialog() or not progress.prepare(assembly):
        return None
    panel = PosePanel(assembly, pose)
    panel.present()
    return panel


class PosePanel(Panel):
    """Blends in an open transaction; OK keeps what is seen, Cancel takes it back."""

    def __init__(self, assembly, pose):
        super().__init__("pose", "BlendPoses", "Blend Poses")
        self._assembly, self._document = assembly, assembly.Document
        self._poses = [None, *api.poses(assembly)]
        self._live = None
        App.setActiveDocument(self._document.Name)
        self._document.openTransaction("Blend Poses")
        self._prepare_widgets(pose)
        self._start()
        self._choose()

    def accept(self) -> bool:
        """OK: one undo step, one macro line."""
        line = self._line()
        self._end()
        if line:
            actions.attempt("Blend Poses", line, document=self._document)
        return self.finish()

    def reject(self) -> bool:
        """Cancel: everything is as it was."""
        self._end()
        return self.finish()

    def _prepare_widgets(self, pose) -> None:
        form = self.form
        labels = [translate("panels", REST) if each is None else each.Label for each in self._poses]
        for field in (form.first, form.second):
            field.addItems(labels)
        form.second.setCurrentIndex(self._poses.index(pose))
        form.slider.setValue(100)
        form.percent.setValue(100)
        form.first.currentIndexChanged.connect(self._choose)
        form.second.currentIndexChanged.connect(self._choose)
        form.slider.valueChanged.connect(form.percent.setValue)
        form.percent.valueChanged.connect(self._on_percent)
        say(form.message, "")

    def _start(self) -> None:
        view = Gui.getDocument(self._document.Name).activeView()
        try:
            self._live = LiveUpdate(self._assembly, Updating(ON_OK), view)
        except actions.FAULTS as error:
            say(self.form.message, str(error), True)
            return
        self._live.failed.connect(self._on_fault)

    def _end(self) -> None:
        if self._live is not None:
            self._live.end()
        self._document.abortTransaction()

    def _pair(self):
        form = self.form
        return self._poses[form.first.currentIndex()], self._poses[form.second.currentIndex()]

    def _choose(self, *_) -> None:
        """Says how far the two are apart, and shows where the slider is."""
        pair = self._pair()
        if pair == (None, None):
            say(self.form.apart, translate("panels", "Choose a pose."))
            return
        try:
            apart = api.compare_poses(*pair)
        except actions.FAULTS as error:
            self._on_fault(str(error))
            return
        say(self.form.apart, described(self._document, apart))
        self._on_percent()

    def _on_percent(self, *_) -> None:
        percent = self.form.percent.value()
        self.form.slider.blockSignals(True)
        self.form.slider.setValue(round(percent))
        self.form.slider.blockSignals(False)
        if self._pair() == (None, None):
            return
        api.blend_poses(*self._pair(), percent / 100.0)
        if self._live is not None:
            self._live.ask()

    def _on_fault(self, text: str) -> None:
        say(self.form.message, text, True)

    def _line(self) -> str:
        """The call of the API that does what is seen; empty if nothing is chosen."""
        if self._pair() == (None, None):
            return ""
        ends = ["None" if pose is None else name(pose) for pose in self._pair()]
        return call("blend_poses", *ends, repr(self.form.percent.value() / 100.0))


def described(document, apart: dict) -> str:
    """How far two poses are apart, the part with the largest distance first."""
    ordered = sorted(apart, key=lambda part: -apart[part][0])
    lines = [translate("panels", "Largest and mean distance, mm")]
    for part in ordered[:5]:
        largest, mean = apart[part]
        lines.append(f"{document.getObject(part).Label}: {largest:.3g}, {mean:.3g}")
    if len(ordered) > 5:
        lines.append(translate("panels", "and {0} more parts").format(len(ordered) - 5))
    return "\n".join(lines)
