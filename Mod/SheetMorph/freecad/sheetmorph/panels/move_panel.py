# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that moves handles: values change, the view follows, OK keeps, Cancel takes back."""

from dataclasses import asdict

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import progress
from freecad.sheetmorph.panels.base import Panel, say
from freecad.sheetmorph.panels.live_update import LiveUpdate
from freecad.sheetmorph.panels.motion_fields import MotionFields
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene.dragger import Dragger
from freecad.sheetmorph.tools.motion import CENTROID, Motion
from freecad.sheetmorph.tools.updating import PAUSE, Updating

PREFERENCES = "User parameter:BaseApp/Preferences/Mod/SheetMorph"


def open_panel(handle):
    """Opens the panel for a handle; returns the panel, None if the user cancels the set-up."""
    if not progress.prepare(model.assembly_of(handle)):
        return None
    panel = MovePanel(handle)
    panel.present()
    return panel


class MovePanel(Panel):
    """Moves the handles of one morph in one open transaction."""

    def __init__(self, handle):
        super().__init__("move", "MoveHandle", "Move Handle")
        self._document = handle.Document
        self._assembly = model.assembly_of(handle)
        self._handles = [r for r in model.regions(self._assembly) if r.Role == "handle"]
        self._handle = handle
        self._changed = []
        self._is_committing = False
        self._updating = Updating(App.ParamGet(PREFERENCES).GetInt("UpdateResults", 0))
        self._live = None
        self._dragger = None
        self._fields = MotionFields(self.form)
        self._frame = self._timer(0, self._show)
        self._pause = self._timer(round(1000 * PAUSE), self._on_pause)
        App.setActiveDocument(self._document.Name)
        self._document.openTransaction("Move Handle")
        self._prepare_widgets()
        self._start()
        self._show_arrows(self.form.arrows.isChecked())

    # -- the buttons of the task view

    def accept(self) -> bool:
        """OK: one undo step and one macro line a handle."""
        self._frame.stop()
        self._pause.stop()
        if self._fields.read().fault():
            self._show()
            return False
        self._end_drawing()
        if not self._changed:
            self._document.abortTransaction()
            return self.finish()
        lines = [
            call("set_motion", name(handle), **motion_of(handle).keywords())
            for handle in self._changed
        ]
        actions.record(*lines, "App.ActiveDocument.recompute()")
        self._document.commitTransaction()
        return self.finish()

    def reject(self) -> bool:
        """Cancel: everything is as it was when the panel opened."""
        self._frame.stop()
        self._pause.stop()
        self._end_drawing()
        self._document.abortTransaction()
        return self.finish()

    def finish(self) -> bool:
        """Closes the panel."""
        self._fields.release()
        return super().finish()

    # -- following the fields

    def _start(self) -> None:
        """Builds the session; if that fails the panel says why, and fields can still be set."""
        try:
            with actions.waiting():
                self._live = LiveUpdate(self._assembly, self._updating)
        except actions.FAULTS as error:
            say(self.form.message, str(error), True)

    def _on_change(self) -> None:
        """A field changed."""
        self._apply()
        self._place_arrows()

    def _on_drag(self, translation, axis, angle: float) -> None:
        """The arrows were dragged; without a rotation the axis of the fields stays."""
        present = self._fields.read()
        axis = axis if angle else present.axis
        motion = Motion(translation, axis, angle, present.pivot)
        self._fields.write(motion, tuple(api.pivot(self._handle)))
        self._apply()

    def _on_release(self) -> None:
        """The mouse was released: results follow now, unless they wait for OK."""
        if self._live is not None and self._updating.is_due_on_pause():
            self._pause.start(0)

    def _apply(self) -> None:
        """Sets the properties now, draws when the event loop is free."""
        motion = self._fields.read()
        say(self.form.axis_message, motion.fault(), True)
        if motion.fault():
            return
        if motion != motion_of(self._handle):
            api.set_motion(self._handle, **asdict(motion))
            if self._handle not in self._changed:
                self._changed.append(self._handle)
            self._fields.show_pivot(tuple(api.pivot(self._handle)))
            self._frame.start()

    def _show(self) -> None:
        """Draws the motion, commits it if that is quick."""
        if self._live is None:
            return
        try:
            self._live.show()
        except actions.FAULTS as error:
            say(self.form.message, str(error), True)
            return
        say(self.form.message, "")
        say(self.form.status, f"Shown in {self._live.milliseconds:.0f} ms")
        if self._updating.is_due_now():
            self._commit()
        elif self._updating.is_due_on_pause():
            self._pause.start(round(1000 * PAUSE))

    def _on_pause(self) -> None:
        self._commit()

    def _commit(self) -> None:
        """Recomputes; FreeCAD lets timers run meanwhile, which must not start another one."""
        if self._is_committing:
            self._pause.start(round(1000 * PAUSE))
            return
        self._is_committing = True
        fault = self._live.commit()
        self._is_committing = False
        if fault:
            say(self.form.message, fault, True)

    def _end_drawing(self) -> None:
        self._show_arrows(False)
        if self._live is not None:
            self._live.end()

    def _show_arrows(self, is_shown: bool) -> None:
        """Arrows and arcs in the view at the pivot of the handle, or none."""
        if self._dragger is not None:
            self._dragger.remove()
            self._dragger = None
        if is_shown:
            view = Gui.getDocument(self._document.Name).activeView()
            self._dragger = Dragger(view, self._on_drag, self._on_release)
            self._place_arrows()

    def _show_wires(self, is_shown: bool) -> None:
        """Control meshes in the view that move along, or none."""
        if self._live is not None:
            view = Gui.getDocument(self._document.Name).activeView()
            try:
                self._live.use_wires(view if is_shown else None)
            except actions.FAULTS as error:
                say(self.form.message, str(error), True)

    def _place_arrows(self) -> None:
        if self._dragger is not None:
            self._dragger.place(tuple(api.pivot(self._handle)), motion_of(self._handle))

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        form.handle.addItems([handle.Label for handle in self._handles])
        form.handle.setCurrentIndex(self._handles.index(self._handle))
        form.handle.currentIndexChanged.connect(self._choose_handle)
        form.results.setCurrentIndex(self._updating.preference)
        form.results.currentIndexChanged.connect(self._choose_update)
        form.reset.clicked.connect(self._reset)
        form.arrows.toggled.connect(self._show_arrows)
        form.control_meshes.toggled.connect(self._show_wires)
        self._fields.changed.connect(self._on_change)
        say(form.axis_message, "")
        say(form.message, "")
        say(form.status, "")
        self._fill()

    def _fill(self) -> None:
        """Shows the motion of the handle."""
        centre = tuple(api.pivot(self._handle))
        self._fields.write(motion_of(self._handle), centre)
        self._fields.lock({path.lstrip("."): text for path, text in self._handle.ExpressionEngine})

    def _choose_handle(self, index: int) -> None:
        self._handle = self._handles[index]
        self._fill()
        self._place_arrows()

    def _choose_update(self, preference: int) -> None:
        self._updating.preference = preference
        App.ParamGet(PREFERENCES).SetInt("UpdateResults", preference)

    def _reset(self) -> None:
        """Back to rest, still within the transaction."""
        self._fields.write(Motion(), tuple(api.pivot(self._handle)))
        self._on_change()
        self._fill()

    def _timer(self, milliseconds: int, action):
        timer = QtCore.QTimer(self.form)
        timer.setSingleShot(True)
        timer.setInterval(milliseconds)
        timer.timeout.connect(action)
        return timer


def motion_of(handle) -> Motion:
    """The motion the properties of a handle say."""
    shift = (handle.TranslationX, handle.TranslationY, handle.TranslationZ)
    pivot = CENTROID if handle.PivotAtCentroid else tuple(handle.Pivot)
    translation = tuple(float(value.Value) for value in shift)
    return Motion(translation, tuple(handle.Axis), float(handle.Angle.Value), pivot)
