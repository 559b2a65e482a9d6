# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that moves handles: the view follows the values, OK stores them."""

from functools import partial

from freecad.sheetmorph import actions, preferences
from freecad.sheetmorph.api.poses import restore, snapshot
from freecad.sheetmorph.api.shapes import update_shapes
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import OPEN_CONTACT, UNREACHED
from freecad.sheetmorph.objects.region import motion_of
from freecad.sheetmorph.panels import keeping, progress, propagation_tree
from freecad.sheetmorph.panels.axes_field import AxesField
from freecad.sheetmorph.panels.base import Panel, listed, say
from freecad.sheetmorph.panels.fault_bar import FaultBar
from freecad.sheetmorph.panels.folding import Folds
from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.interaction.handle_drag import HandleDrag
from freecad.sheetmorph.interaction.live_update import LiveUpdate
from freecad.sheetmorph.panels.mouse_fields import MouseFields
from freecad.sheetmorph.panels.motion_fields import MotionFields
from freecad.sheetmorph.panels.reach_marks import ReachMarks, criteria_of
from freecad.sheetmorph.interaction.moved_handles import MovedHandles
from freecad.sheetmorph.panels.show_fields import ShowFields
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, number, translate
from freecad.sheetmorph.scene.handle_marks import HandleMarks
from freecad.sheetmorph.tools.motion import Motion, Moving
from freecad.sheetmorph.tools.updating import PAUSE, Updating

# The panel has room for these; the morph's property Warnings has all.
MOST_WARNINGS = 3


def open_panel(handle):
    """Open the panel for a handle; return it, or None if the user cancels the preparation."""
    assembly = model.assembly_of(handle)
    if not progress.prepare(assembly):
        return None
    session = EditingSession(assembly.Document, [assembly, *assembly.Group])
    return MovePanel.opened(session, handle)


class MovePanel(Panel):
    """The panel that moves the handles of one morph; its session has the pending changes."""

    width = 400  # for three buttons, in any language
    lines = 4

    def __init__(self, session, handle):
        super().__init__(session, "move", "MoveHandle", "Move Handle")
        assembly = model.assembly_of(handle)
        read, write = partial(snapshot, assembly), partial(restore, assembly)
        self._pending = session.edit("Move Handle", read, write)
        self._handles = MovedHandles(assembly, self._pending)
        self._moving = Moving(self._handles.centroid)
        session.ending.connect(self._moving.stop)
        self._updating = Updating(preferences.get("UpdateResults"))
        self._live = None
        self._fields = MotionFields(self.form, self._moving)
        self._axes = AxesField(self.form, lambda: self._choose(self._handle))
        self._moving.observe(self._on_motion)  # before a LiveUpdate, which may read the document
        self._shown = ShowFields(self.form, session, bool(model.decks(assembly)))
        self._faults = FaultBar(self.form, session, assembly, paints=True)
        self._faults.mended.connect(self._follow_later)
        form = self.form
        Folds({form.pivot: "OpenPivot", form.mouse: "OpenMouse", form.showing: "OpenShow"})
        self._reach = ReachMarks(form, criteria_of(assembly), self._ask_reach)
        self._moving.observe(self._reach.follow)
        self._pause = self._timer(round(1000 * PAUSE), self.settle)
        self._prepare_widgets()
        session.at_end(self._end_live)
        self._drag = session.show(HandleDrag(session.view, self._moving, self))
        self._marks = session.show(HandleMarks(session.view, self._choose_marked))
        self._moving.observe(self._marks.follow)
        session.at_end(self._stop_timers)
        self._choose(handle)
        self._mouse = MouseFields(self.form, self._drag)
        session.ending.connect(self._hush)
        session.changed.connect(self._follow)
        self._start()

    # -- the buttons of the task view

    def getStandardButtons(self) -> int:
        """Return OK, Apply and Cancel."""
        return super().getStandardButtons() | number(QtWidgets.QDialogButtonBox.Apply)

    def clicked(self, button) -> None:
        """Handle Apply: store the pose as OK does, but keep the panel open."""
        if number(button) == number(QtWidgets.QDialogButtonBox.Apply) and self.keep():
            if self._handle is None:  # a point that was clicked but not moved
                self._follow()

    def keep(self) -> bool:
        """Store the pose in one undo step, with one macro line per handle."""
        self._stop_timers()
        if not self._fields.is_valid:
            return False
        self._pending.gather()
        self._handles.unmake_unmoved()
        lines = self._handles.lines()
        if lines:
            fault = keeping.present_fault(self._handles.assembly, self._live)
            if fault:
                self._faults.say(fault)
                return False
            actions.note(*lines, f"{actions.DOCUMENT}.recompute()")
            self._let_shapes_follow()
        self._pending.keep()
        if lines and self._live is not None:
            self._live.finish()
        self._handles.begin()
        return True

    def _let_shapes_follow(self) -> None:
        """Update deformed shapes in the same step, and report one that fails.

        They need the final shape, so this waits for it.
        """
        owner = self._handles.assembly
        if not any(part.DeformedShape for part in model.parts(owner)):
            return
        try:
            with actions.waiting():
                self.session.document.recompute()
                update_shapes(owner)
        except actions.FAULTS as error:
            actions.tell("Deformed Shape", error)
            return
        actions.note(actions.call("update_shapes", actions.name(owner)))

    # -- following the motion; HandleDrag calls settle, grab and meshes

    @property
    def _handle(self):
        """The chosen handle, None if it was deleted."""
        return self.session.document.getObject(self._moving.name)

    def _on_motion(self, moving, before) -> None:
        """Set the properties of the handle now, and the result objects after a pause."""
        if before is not None:
            self._handles.move(self._handle, moving.motion)
            self._pause.start()

    def settle(self) -> None:
        """Compute exactly after the mouse was released or a pause."""
        self._pause.stop()
        if self._drag.is_dragging or self._handle is None:
            return
        if motion_of(self._handle) != self._moving.motion:
            self._choose(self._handle)  # an expression drives it; this changes no property
        self._mark_others()
        self._pending.settle()
        if self._live is not None and self._updating.is_due_on_pause():
            self._live.ask([self._handle], exact=True)

    def grab(self, ray):
        """Choose or create the handle under the mouse; return the position of its vertex."""
        if self._live is None or self._shown.leave_share():
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

    def meshes(self) -> dict:
        """Return the meshes in the present pose, (points (n, 3) mm, triangles (m, 3)) by part."""
        return {} if self._live is None else self._live.meshes()

    def _make_handle(self, found):
        """Create a handle of one vertex; without a solution show why and return None."""
        handle = self._handles.make(found)
        self._end_live()
        try:
            self._live = self._new_live()
        except actions.FAULTS as error:
            self._handles.unmake(handle)
            self._live = self._new_live()
            self._faults.say(error)
            return None
        return handle

    def _start(self) -> None:
        """Start the previews; on failure show why, while the fields still work."""
        try:
            with actions.waiting():
                self._live = self._new_live()
        except actions.FAULTS as error:
            self._faults.say(error)
            return
        if finishing().is_due(self._handles.assembly):
            self._show()  # the parts still have an earlier shape

    def _new_live(self) -> LiveUpdate:
        live = LiveUpdate(self._handles.assembly, self._updating, self.session)
        self._moving.observe(live.follow)
        live.drawn.connect(self._on_drawn)
        live.failed.connect(self._faults.say)
        live.settling.connect(self._on_settling)
        live.reached.connect(self._reach.on_reached)
        self._shown.connect(live)
        return live

    def _ask_reach(self, number: int, criteria: dict) -> bool:
        """Request the range of a number; return False if that has to wait."""
        if self._live is None or self._handle is None:
            return True
        return self._live.ask_reach(self._handle, number, criteria)

    def _follow_later(self) -> None:
        self.session.later(self._follow)

    def _follow(self) -> None:
        """Show the pose after an undo, a redo or another command."""
        self._stop_timers()
        self._handles.look_again()
        handles = self._handles.all
        if not handles:
            self.session.end()
            return
        self._choose(self._handle if self._handle in handles else handles[0])
        self._end_live()
        self._start()
        self._show()

    def _mark_others(self) -> None:
        """Mark the handles without arrows at their present positions."""
        self._marks.show([self._handles.place(handle) for handle in self._others])

    @property
    def _others(self) -> list:
        return [handle for handle in self._handles.all if handle != self._handle]

    def _choose_marked(self, number: int) -> None:
        self._choose(self._others[number])

    def _show(self) -> None:
        """Draw the present motion, and update the result objects after a pause."""
        if self._live is not None:
            self._live.ask([self._handle])
        self._pause.start()

    def _on_drawn(self) -> None:
        self._faults.say(self._live.unsettled)
        computed, drawn = self._live.kernel_ms, self._live.draw_ms
        text = translate("SheetMorph_panels", "Computed in {0:.1f} ms, drawn in {1:.1f} ms")
        text = text.format(computed, drawn)
        is_steel = self._handles.assembly.Energy == "steel"
        if self._live.shown.share < 1.0:
            sentence = translate("SheetMorph_panels", "Shown at {0:.0f} % of the motion. {1}")
            text = sentence.format(100.0 * self._live.shown.share, text)
        elif self._live.is_preview and is_steel:
            sentence = translate(
                "SheetMorph_panels", "Linear preview; the steel shape is computed on a pause. {0}"
            )
            text = sentence.format(text)
        elif self._live.is_preview:
            text = translate("SheetMorph_panels", "Preview: refined on release. {0}").format(text)
        elif is_steel:
            text = translate("SheetMorph_panels", "Final steel shape. {0}").format(text)
        say(self.form.status, text)
        self._tell_who_stays()
        self._shown.tell()
        if self._live.is_preview:
            self._pause.start()  # the exact shape must follow a preview

    def _on_settling(self, task: str) -> None:
        if self._live is not None and self._live.is_preview:
            step = task.rpartition(" ")[2]
            text = translate("SheetMorph_panels", "Computing the exact shape")
            if step.isdigit():
                text = translate("SheetMorph_panels", "Computing steel shape (step {0})")
            say(self.form.status, text.format(step))

    def _hush(self) -> None:
        self._stop_timers()
        if self._live is not None:
            self._live.hush()

    def _stop_timers(self) -> None:
        self._reach.stop()
        self._pause.stop()

    def _end_live(self) -> None:
        if self._live is not None:
            self._moving.leave(self._live.follow)
            self._live.remove()
        self._live = None

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        connect(form.handle, "currentIndexChanged(int)", self._on_choice)
        form.results.setCurrentIndex(self._updating.preference)
        connect(form.results, "currentIndexChanged(int)", self._choose_update)
        connect(form.reset, "clicked()", self._reset)
        # Text from the start: a panel that grows during a click would move the target.
        say(form.status, translate("SheetMorph_panels", "Nothing has moved yet."))

    def _tell_who_stays(self) -> None:
        """Show the parts that will not follow, and other warnings."""
        assembly = self._handles.assembly
        names, opened = assembly.Unreached, propagation_tree.opened(assembly)
        text = translate(
            "SheetMorph_panels", "These parts will not follow, because no contact reaches them: {0}"
        )
        texts = [text.format(", ".join(names))] if names else []
        if len(opened) > 1:
            text = translate(
                "SheetMorph_panels",
                "{0} contacts open or close too far (see Propagation). The first:",
            )
            texts.append(text.format(len(opened)))
        texts += [contact.Warning for contact in opened[:1]]
        others = [
            text
            for text in model.warnings_of(assembly)
            if text.code not in (UNREACHED, OPEN_CONTACT)
        ]
        texts += others[:MOST_WARNINGS] + ["…"] * (len(others) > MOST_WARNINGS)
        say(self.form.staying, listed(texts), bool(texts))

    def _choose(self, handle) -> None:
        """Show the present handles and the motion of one of them."""
        combo, handles = self.form.handle, self._handles.all
        labels = [one.Label for one in handles]
        combo.blockSignals(True)
        if [combo.itemText(k) for k in range(combo.count())] != labels:
            combo.clear()
            combo.addItems(labels)
        combo.setCurrentIndex(handles.index(handle))
        combo.blockSignals(False)
        free, axes = handle.FreeRotation, self._axes.of(handle)
        self._moving.choose(handle.Name, motion_of(handle), free, axes)
        self._fields.lock({path.lstrip("."): text for path, text in handle.ExpressionEngine})
        self.form.rotation.setEnabled(not free)
        self._mark_others()
        self._tell_who_stays()

    def _on_choice(self, index: int) -> None:
        self._choose(self._handles.all[index])

    def _choose_update(self, preference: int) -> None:
        self._updating.preference = preference
        preferences.put("UpdateResults", preference)

    def _reset(self) -> None:
        """Return the handle to rest within the transaction."""
        self._moving.set(Motion())
        self._choose(self._handle)

    def _timer(self, milliseconds: int, action):
        timer = QtCore.QTimer(self.form)
        timer.setSingleShot(True)
        timer.setInterval(milliseconds)
        connect(timer, "timeout()", lambda: self.session.when_free(action))
        return timer
