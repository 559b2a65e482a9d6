# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that moves handles: values change, the view follows, OK keeps, Cancel takes back."""

from dataclasses import asdict

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, preferences
from freecad.sheetmorph.api.poses import motion_of
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import progress
from freecad.sheetmorph.panels.base import Panel, legend, say
from freecad.sheetmorph.panels.folding import Folds
from freecad.sheetmorph.panels.handle_drag import HandleDrag
from freecad.sheetmorph.panels.live_update import LiveUpdate
from freecad.sheetmorph.panels.mouse_fields import MouseFields
from freecad.sheetmorph.panels.motion_fields import MotionFields
from freecad.sheetmorph.panels.moved_handles import MovedHandles
from freecad.sheetmorph.panels.show_fields import ShowFields
from freecad.sheetmorph.qt import QtCore, QtWidgets, translate
from freecad.sheetmorph.scene.legend import ViewLegend
from freecad.sheetmorph.tools.motion import Motion
from freecad.sheetmorph.tools.updating import PAUSE, Updating


def open_panel(handle):
    """Opens the panel for a handle; returns the panel, None if the user cancels the set-up."""
    if not progress.prepare(model.assembly_of(handle)):
        return None
    panel = MovePanel(handle)
    panel.present()
    return panel


class MovePanel(Panel):
    """Moves the handles of one morph in one open transaction."""

    width = 400  # for three buttons, in any language

    def __init__(self, handle):
        super().__init__("move", "MoveHandle", "Move Handle")
        self._document = handle.Document
        self._handles = MovedHandles(model.assembly_of(handle))
        self._handle = handle
        self._updating = Updating(preferences.get("UpdateResults"))
        self._live = None
        self._fields = MotionFields(self.form)
        self._legend = ViewLegend(self._view())
        self._legend.show_roles(legend(""))
        self._shown = ShowFields(self.form, self._legend)
        form = self.form
        self._folds = Folds(
            {form.pivot: "OpenPivot", form.mouse: "OpenMouse", form.showing: "OpenShow"}
        )
        self._frame = self._timer(0, self._show)
        self._pause = self._timer(round(1000 * PAUSE), self.settle)
        App.setActiveDocument(self._document.Name)
        self._document.openTransaction("Move Handle")
        self._prepare_widgets()
        self._drag = HandleDrag(self._view(), self)
        self._mouse = MouseFields(self.form, self._drag)
        self._start()

    # -- the buttons of the task view

    def getStandardButtons(self) -> int:
        """OK, Apply and Cancel."""
        return super().getStandardButtons() | int(QtWidgets.QDialogButtonBox.Apply)

    def clicked(self, button) -> None:
        """Apply: as OK, and the panel stays."""
        if int(button) == int(QtWidgets.QDialogButtonBox.Apply) and self._is_in_order():
            self._keep()
            self._document.openTransaction("Move Handle")
            self._renew()

    def accept(self) -> bool:
        """OK: one undo step and one macro line a handle."""
        if not self._is_in_order():
            return False
        self._end_drawing()
        self._keep()
        return self.finish()

    def reject(self) -> bool:
        """Cancel: everything is as it was when the panel opened, or at the last Apply."""
        self._end_drawing()
        self._document.abortTransaction()
        return self.finish()

    def finish(self) -> bool:
        """Closes the panel."""
        self._fields.release()
        self._mouse.release()
        self._shown.release()
        self._folds.release()
        self._legend.remove()
        return super().finish()

    def _is_in_order(self) -> bool:
        self._frame.stop()
        self._pause.stop()
        fault = self._fields.read().fault()
        say(self.form.axis_message, fault, True)
        return not fault

    def _keep(self) -> None:
        """Does what was done once more, as the lines of a macro: what is recorded is what is."""
        lines = self._handles.lines()
        self._document.abortTransaction()
        if lines:
            actions.attempt("Move Handle", *lines, document=self._document)
        self._handles.forget()

    # -- following fields and mouse; the next five are what HandleDrag asks for

    def motion(self) -> Motion:
        """The motion of the chosen handle."""
        return motion_of(self._handle)

    def pivot(self) -> tuple:
        """Where the pivot of the chosen handle is at rest, (3,) mm."""
        return self._handles.pivot(self._handle)

    def put(self, motion: Motion) -> None:
        """The mouse changed the motion."""
        self._fields.write(motion, self.pivot())
        self._apply()

    def settle(self) -> None:
        """The mouse was released, or nothing changed for a while: now exactly."""
        if self._live is None or not self._updating.is_due_on_pause():
            return
        self._pause.stop()
        self._live.ask([self._handle], exact=True)

    def grab(self, ray):
        """Chooses the handle under the mouse, made where there is none; returns its point."""
        if self._live is None:
            return None
        found = self._live.grab(ray)
        if found is None:
            return None
        handle = self._handles.at(found)
        if handle is None:
            handle = self._make_handle(found)
        if handle is None:
            return None
        self._choose(handle)
        return found.point

    def _make_handle(self, found):
        """A handle of one vertex; without a solution there is none, and the panel says why."""
        handle = self._handles.make(found)
        self._live.end()
        try:
            self._live = self._new_live()
        except actions.FAULTS as error:
            self._handles.unmake(handle)
            self._live = self._new_live()
            say(self.form.message, str(error), True)
            return None
        self.form.handle.addItem(handle.Label)
        return handle

    def _start(self) -> None:
        """Builds the session; if that fails the panel says why, and fields can still be set."""
        try:
            with actions.waiting():
                self._live = self._new_live()
        except actions.FAULTS as error:
            say(self.form.message, str(error), True)

    def _new_live(self) -> LiveUpdate:
        live = LiveUpdate(self._handles.assembly, self._updating, self._view())
        live.drawn.connect(self._on_drawn)
        live.failed.connect(self._on_fault)
        self._shown.connect(live)
        return live

    def _renew(self) -> None:
        """Goes on with the objects that Apply has made of those there were."""
        labels = [self.form.handle.itemText(k) for k in range(self.form.handle.count())]
        index = self.form.handle.currentIndex()
        if self._live is not None:
            self._live.end()
        self._start()
        found = [handle.Label for handle in self._handles.all]
        self._handle = self._handles.all[
            found.index(labels[index]) if labels[index] in found else 0
        ]
        self.form.handle.clear()
        self.form.handle.addItems(found)
        self._choose(self._handle)
        self._fill()
        self._drag.place()

    def _on_change(self) -> None:
        """A field changed."""
        self._apply()
        self._drag.place()

    def _apply(self) -> None:
        """Sets the properties now, draws when the event loop is free."""
        motion = self._fields.read()
        say(self.form.axis_message, motion.fault(), True)
        if motion.fault():
            return
        if motion != motion_of(self._handle):
            self._handles.move(self._handle, asdict(motion))
            self._fields.show_pivot(self.pivot())
            self._frame.start()

    def _show(self) -> None:
        """Asks for the present motion, for the result objects as well when the user pauses."""
        if self._live is not None:
            self._live.ask([self._handle])
            if self._updating.is_due_on_pause():
                self._pause.start()

    def _on_drawn(self) -> None:
        say(self.form.message, self._live.unsettled, True)
        computed, drawn = self._live.kernel_ms, self._live.draw_ms
        text = translate("panels", "Computed in {0:.1f} ms, drawn in {1:.1f} ms")
        if self._live.is_preview:
            text = translate("panels", "Preview: refined on release. {0}").format(text)
        say(self.form.status, text.format(computed, drawn))
        self._shown.tell()

    def _on_fault(self, text: str) -> None:
        say(self.form.message, text, True)

    def _end_drawing(self) -> None:
        self._frame.stop()
        self._pause.stop()
        self._drag.release()
        if self._live is not None:
            self._live.end()

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        form.handle.addItems([handle.Label for handle in self._handles.all])
        form.handle.setCurrentIndex(self._handles.all.index(self._handle))
        form.handle.currentIndexChanged.connect(self._on_choice)
        form.results.setCurrentIndex(self._updating.preference)
        form.results.currentIndexChanged.connect(self._choose_update)
        form.reset.clicked.connect(self._reset)
        self._fields.changed.connect(self._on_change)
        for label in (form.axis_message, form.message):
            say(label, "")
        # A line from the start: a panel that grows while one clicks takes the click elsewhere.
        say(form.status, translate("panels", "Nothing has moved yet."))
        self._fill()

    def _fill(self) -> None:
        """Shows the motion of the handle."""
        self._fields.write(self.motion(), self.pivot())
        self._fields.lock({path.lstrip("."): text for path, text in self._handle.ExpressionEngine})
        self.form.rotation.setEnabled(not self._handle.FreeRotation)

    def _choose(self, handle) -> None:
        self.form.handle.setCurrentIndex(self._handles.all.index(handle))

    def _on_choice(self, index: int) -> None:
        if index < 0:  # while the list is written anew
            return
        self._handle = self._handles.all[index]
        self._fill()
        self._drag.place()

    def _choose_update(self, preference: int) -> None:
        self._updating.preference = preference
        preferences.put("UpdateResults", preference)

    def _reset(self) -> None:
        """Back to rest, still within the transaction."""
        self._fields.write(Motion(), self.pivot())
        self._on_change()
        self._fill()

    def _view(self):
        return Gui.getDocument(self._document.Name).activeView()

    def _timer(self, milliseconds: int, action):
        timer = QtCore.QTimer(self.form)
        timer.setSingleShot(True)
        timer.setInterval(milliseconds)
        timer.timeout.connect(action)
        return timer
