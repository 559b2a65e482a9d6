# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that blends two poses with a slider and shows their distance."""

from functools import partial

import FreeCADGui as Gui

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.api.poses import restore, snapshot
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.panels import keeping, progress
from freecad.sheetmorph.panels.base import Panel, say
from freecad.sheetmorph.panels.fault_bar import FaultBar
from freecad.sheetmorph.interaction.live_update import LiveUpdate
from freecad.sheetmorph.qt import QtCore, connect, translate
from freecad.sheetmorph.tools import words
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.updating import ON_OK, PAUSE, Updating

REST = QT_TRANSLATE_NOOP("SheetMorph_panels", "At rest")


def open_panel(assembly, pose):
    """Open the panel from rest to a pose; return it.

    Returns None if another panel is open or the user cancels the preparation.
    """
    if Gui.Control.activeDialog() or not progress.prepare(assembly):
        return None
    session = EditingSession(assembly.Document, [assembly, *assembly.Group])
    return PosePanel.opened(session, assembly, pose)


class PosePanel(Panel):
    """The panel that blends two poses; OK stores the displayed one."""

    def __init__(self, session, assembly, pose):
        super().__init__(session, "pose", "BlendPoses", "Blend Poses")
        self._assembly, self._document = assembly, assembly.Document
        read, write = partial(snapshot, assembly), partial(restore, assembly)
        self._pending = session.edit("Blend Poses", read, write)
        self._poses = [None, *api.poses(assembly)]
        self._shares = []  # (snapshot, fields) of every blend that was shown for a while
        self._live = None
        self._pause = QtCore.QTimer(self.form, singleShot=True, interval=round(1000 * PAUSE))
        connect(self._pause, "timeout()", lambda: session.when_free(self._settle))
        self._faults = FaultBar(self.form, session, assembly, paints=True)
        self._faults.mended.connect(self._follow_later)
        self._prepare_widgets(pose)
        session.at_end(self._end_live)
        session.at_end(self._pause.stop)
        session.ending.connect(self._hush)
        session.changed.connect(self._follow)
        self._start()
        self._choose()

    def keep(self) -> bool:
        """Store the displayed pose in one undo step, with one macro line."""
        line = self._line()
        self._pending.gather()
        is_new = bool(self._pending.is_open and line)
        if is_new:
            fault = keeping.present_fault(self._assembly, self._live)
            if fault:
                self._faults.say(fault)
                return False
            actions.note(line, f"{actions.DOCUMENT}.recompute()")
        self._pending.keep()
        if is_new and self._live is not None:
            self._live.finish()
        return True

    def _prepare_widgets(self, pose) -> None:
        form = self.form
        labels = [
            translate("SheetMorph_panels", REST) if each is None else each.Label
            for each in self._poses
        ]
        for field in (form.first, form.second):
            field.addItems(labels)
        form.second.setCurrentIndex(self._poses.index(pose))
        form.slider.setValue(100)
        form.percent.setValue(100)
        form.percent.leaves_undo = True
        connect(form.first, "currentIndexChanged(int)", self._choose)
        connect(form.second, "currentIndexChanged(int)", self._choose)
        connect(form.slider, "valueChanged(int)", form.percent.setValue)
        connect(form.percent, "valueChanged(double)", self._on_percent)

    def _start(self) -> None:
        try:
            self._live = LiveUpdate(self._assembly, Updating(ON_OK), self.session)
        except actions.FAULTS as error:
            self._faults.say(error)
            return
        self._live.failed.connect(self._faults.say)

    def _end_live(self) -> None:
        if self._live is not None:
            self._live.remove()
        self._live = None

    def _hush(self) -> None:
        self._pause.stop()
        if self._live is not None:
            self._live.hush()

    def _settle(self) -> None:
        """Make the present pose a step to which an undo returns."""
        self._pending.settle()
        self._shares.append((snapshot(self._assembly), self._given()))

    def _follow_later(self) -> None:
        self.session.later(self._follow)

    def _follow(self) -> None:
        """Show the pose after an undo, a redo or another command."""
        now = snapshot(self._assembly)
        given = next((fields for kept, fields in reversed(self._shares) if kept == now), None)
        if given is not None:
            self._show_given(given)
        text = translate(
            "SheetMorph_panels", "Back in the previous shape. Move the slider to blend again."
        )
        self._faults.say("")
        say(self.form.message, "" if given is not None else text)
        self._end_live()
        self._start()
        if self._live is not None:
            self._live.ask()

    def _given(self) -> tuple:
        form = self.form
        return form.first.currentIndex(), form.second.currentIndex(), form.percent.value()

    def _show_given(self, given: tuple) -> None:
        form = self.form
        setters = (form.first.setCurrentIndex, form.second.setCurrentIndex, form.percent.setValue)
        for field, put, value in zip((form.first, form.second, form.percent), setters, given):
            field.blockSignals(True)
            put(value)
            field.blockSignals(False)
        self._show_slider()

    def _pair(self):
        form = self.form
        return self._poses[form.first.currentIndex()], self._poses[form.second.currentIndex()]

    def _choose(self, *_) -> None:
        """Show the distance between the two poses, and the pose of the slider."""
        pair = self._pair()
        if pair == (None, None):
            say(self.form.apart, translate("SheetMorph_panels", "Choose a pose."))
            return
        try:
            apart = api.compare_poses(*pair)
        except actions.FAULTS as error:
            self._faults.say(error)
            return
        say(self.form.apart, described(self._document, apart))
        self._on_percent()

    def _on_percent(self, *_) -> None:
        self._show_slider()
        if self._pair() == (None, None) or self.session.is_ending:
            return
        self._pending.change()
        api.blend_poses(*self._pair(), self.form.percent.value() / 100.0)
        self._faults.say("")
        self._pause.start()
        if self._live is not None:
            self._live.ask()

    def _show_slider(self) -> None:
        self.form.slider.blockSignals(True)
        self.form.slider.setValue(round(self.form.percent.value()))
        self.form.slider.blockSignals(False)

    def _line(self) -> str:
        """Return the API call for the displayed pose, empty without a choice."""
        if self._pair() == (None, None):
            return ""
        ends = ["None" if pose is None else name(pose) for pose in self._pair()]
        return call("blend_poses", *ends, repr(self.form.percent.value() / 100.0))


def described(document, apart: dict) -> str:
    """Return the distance between two poses as text, the part with the largest first."""
    ordered = sorted(apart, key=lambda part: -apart[part][0])
    lines = [translate("SheetMorph_panels", "Largest and mean distance, mm")]
    for part in ordered[:5]:
        largest, mean = apart[part]
        lines.append(
            f"{document.getObject(part).Label}: {words.plain(largest)}, {words.plain(mean)}"
        )
    if len(ordered) > 5:
        lines.append(translate("SheetMorph_panels", "and {0} more parts").format(len(ordered) - 5))
    return "\n".join(lines)
