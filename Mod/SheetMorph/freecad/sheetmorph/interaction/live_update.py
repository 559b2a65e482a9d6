# SPDX-License-Identifier: LGPL-2.1-or-later
"""Updates of the 3D view and of the result objects during a motion."""

import time
from dataclasses import dataclass

import FreeCAD as App
import numpy as np

from freecad.sheetmorph.bridge import kernel, live_session
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import FLIPPED
from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.interaction.live_scene import LiveScene
from freecad.sheetmorph.qt import QtCore, translate
from freecad.sheetmorph.tools import grabbing, live_values, words

SHOWN = object()  # the question for the displayed frame in other colours


@dataclass(frozen=True, eq=False)
class Flips:
    """The triangles (k,) that flip in a frame, by part; empty arrays ask for those of the parts."""

    frame: live_session.Frame
    triangles: dict


class LiveUpdate(QtCore.QObject):
    """Previews of all parts of a morph, and commits of its document, until `remove`.

    A thread computes the frames. `drawn` is sent when a frame is in the view. `failed` has the
    fault of a failed frame or recompute. `settling` has the present task on the way to an exact
    shape. `reached` has the live_session.Reached of a number.
    """

    drawn = QtCore.Signal()
    failed = QtCore.Signal(object)
    settling = QtCore.Signal(str)
    reached = QtCore.Signal(object)

    def __init__(self, assembly, updating, session):
        """Start previews in an EditingSession.

        Raises MorphError if the morph cannot be computed.
        """
        super().__init__()
        self._assembly = assembly
        self._updating = updating
        self._live = live_session.LiveSession(assembly)
        self._frame = self._full = self._valuer = self._left = None
        self._warned = self.fault = ""
        finishing().drop_scene(assembly)
        self.scene = LiveScene(assembly, self._live, session.view)
        self._pending = session.pending
        self.legend = None
        regions = model.regions(assembly)
        self._has_expressions = any(region.ExpressionEngine for region in regions)
        self.kernel_ms = self.draw_ms = 0.0
        self.count = 0
        self._worker = FrameWorker(self._compute, self)  # last, because it must be stopped

    def ask(self, moved=(), exact: bool = False) -> None:
        """Request a frame of the present motions; `moved` are the handles that change.

        An exact answer becomes that of the result objects too.
        """
        self._recompute_regions()
        self._worker.ask(self._live.ask([handle.Name for handle in moved], exact))

    def follow(self, moving, before) -> None:
        """Request a frame of a motion.Moving; another choice needs none."""
        if before is None:
            return
        if self._has_expressions:
            self.ask([self._assembly.Document.getObject(moving.name)])
        else:
            self._worker.ask(self._live.follow(moving))

    def ask_share(self, share: float) -> None:
        """Request a view of a share of the present motions, from 0 (rest) to 1."""
        self._worker.ask(self._live.ask_share(share))

    def ask_reach(self, handle, number: int, criteria: dict) -> bool:
        """Request the possible range of a handle's number, unless the worker is busy.

        Any other question ends this one. Returns whether the request was made.
        """
        if self._worker.is_idle:
            self._worker.ask(self._live.ask_reach(handle, number, criteria))
            return True
        return False

    def grab(self, ray):
        """Return the grabbing.Grabbed vertex that a ray meets first on the displayed parts."""
        return grabbing.grab(kernel.core(), self.meshes(), ray)

    def meshes(self) -> dict:
        """Return the meshes in the present pose, (points (n, 3) mm, triangles (m, 3)) by part."""
        return self._meshes_in(self._full)

    def displayed(self) -> dict:
        """Return the displayed meshes in the same form, which may be on the way from rest."""
        return self._meshes_in(self._frame)

    def at_rest(self) -> dict:
        """Return the meshes at rest in the same form."""
        return self._meshes_in(None)

    def _meshes_in(self, frame) -> dict:
        parts = {} if self._live is None else self._live.parts
        seen = {} if frame is None else frame.positions
        return {n: (seen.get(n, rest.points), rest.triangles) for n, rest in parts.items()}

    def refresh(self) -> None:
        """Update the details of the scene, unless the worker will draw a new frame."""
        if self._worker.is_idle:
            self.scene.refresh(self._frame)

    def use_colours(self, kind: int) -> None:
        """Set the meaning of colours: NONE, DISPLACEMENT or another of live_scene."""
        self._valuer, self.legend = self.scene.valuer(kind), None
        if self._frame is None:
            self.ask()
        elif self._worker.is_free:
            self._worker.ask(SHOWN)

    def hush(self) -> None:
        """Draw and commit nothing more; the display stays until `remove`."""
        self._worker.hush()

    def finish(self) -> None:
        """Compute the final shape of the stored pose in the background.

        If the pose stays, the display stays until then.
        """
        self._left = self._live.ask().pose
        finishing().finish(self._assembly).expect(self._live.posed(self._left))

    def remove(self) -> None:
        """Show the meshes of the document and release the solution, without waiting."""
        self._worker.stop()
        if self._is_left():
            self.scene.show_shape_alone()
            finishing().finish(self._assembly).take(self.scene)
        else:
            self.scene.remove()
        self._live = self._frame = self._full = self._valuer = self.legend = None

    def _is_left(self) -> bool:
        """Return whether the final shape of the present pose is being computed."""
        if self._left is None or self._frame is None or self.shown.share < 1.0:
            return False
        try:
            is_due = finishing().is_due(self._assembly)
            return is_due and self._live.ask().pose == self._left
        except (ReferenceError, RuntimeError):
            return False  # the document is closed

    # -- called by the worker

    def on_answer(self, answer) -> None:
        """Draw a frame; result objects follow an exact one, or any if that is fast."""
        if answer is None or isinstance(answer, live_session.Reached):
            self.reached.emit(answer)
            return
        if isinstance(answer, Flips):
            if answer.frame is self._frame:
                self.scene.mark_flips(answer.triangles)
                self.drawn.emit()  # the panel shows the warning, which is newer than the frame
            return
        is_new = answer[0] is not self._frame
        self._frame, values, self.legend, milliseconds = answer
        self.fault = ""
        if is_new:
            self.scene.mark_flips({})
        self.kernel_ms = milliseconds if is_new else self.kernel_ms
        start = time.perf_counter()
        self.scene.show(self._frame, values, self.legend)
        self.draw_ms = 1000.0 * (time.perf_counter() - start)
        self.count += 1
        self.drawn.emit()
        self._warn_of_learning()
        question = self._frame.question
        if question.share < 1.0:
            return
        self._full = self._frame
        if question.is_exact and is_new:
            self._commit()
        elif is_new and self._worker.is_free and self._updating.is_due_now():
            self._worker.ask(live_session.Question(question.pose, question.moved, True))

    @property
    def unit(self) -> str:
        """The unit of the colours, empty without one."""
        return "" if self._valuer is None else self._valuer.unit

    @property
    def worst(self) -> str:
        """The legend as text, empty without colours."""
        if self.legend is None or self._valuer is None:
            return ""
        if not self.legend.part:
            return translate("SheetMorph_panels", "No values: no contact is in use.")
        part = self._assembly.Document.getObject(self.legend.part).Label
        extreme = words.plain(self.legend.extreme)
        value = f"{extreme} {self._valuer.unit}".strip()
        worst = translate("SheetMorph_panels", self._valuer.worst)
        text = translate("SheetMorph_panels", "{0} {1} on {2}").format(worst, value, part)
        near = self.legend.near
        return translate("SheetMorph_panels", "{0}, near {1}").format(text, near) if near else text

    @property
    def is_preview(self) -> bool:
        """Whether the displayed frame is refined on release and may change visibly."""
        is_full = self._frame is not None and self.shown.share == 1.0
        return is_full and self._frame.is_preview

    @property
    def shown(self) -> live_session.Question:
        """The request that the displayed frame answers."""
        return self._frame.question

    @property
    def unsettled(self) -> str:
        """Sentences about the parts of the displayed shape that did not converge."""
        return "" if self._frame is None else self._frame.unsettled

    def on_fault(self, text: str) -> None:
        """Report an error."""
        self.fault = text
        self.failed.emit(text)

    def on_progress(self, task: str) -> None:
        """Report the progress of an exact answer."""
        self.settling.emit(task)

    def _goes_on(self, _fraction: float, task: str) -> bool:
        """Return whether an exact answer is still wanted; runs in the worker thread."""
        self._worker.tell(task)
        return self._worker.is_free

    def _compute(self, question):
        """Return a frame, its values, their legend and the milliseconds, in the worker thread.

        For a question about a range, it returns the range, or None if a newer question came.
        """
        if isinstance(question, live_session.ReachQuestion):
            return self._live.reach(question, lambda: self._worker.is_free)
        if isinstance(question, Flips):
            return self._flips(question)
        start, valuer = time.perf_counter(), self._valuer
        is_shown = question is SHOWN
        frame = self._frame if is_shown else self._live.answer(question, self._goes_on)
        if isinstance(valuer, live_values.Stretch):
            valuer.start_from(self._live.rest_of(frame, self._goes_on))
        values = None if valuer is None else valuer(frame.positions)
        legend = None
        if valuer is not None:
            legend = live_values.legend_of(valuer, frame.positions, values)
        return frame, values, legend, 1000.0 * (time.perf_counter() - start)

    def _warn_of_learning(self) -> None:
        """Warn once if the reduced model failed, which leaves frames slow."""
        text = self._live.learning_failure
        if text and text != self._warned:
            App.Console.PrintWarning(f"SheetMorph: frames stay slow during this drag: {text}\n")
        self._warned = text

    def _commit(self) -> None:
        """Recompute the document, which finds the solution of the thread."""
        if not self._pending.is_open:
            return  # an undo came before the answer
        start = time.perf_counter()
        self._assembly.Document.recompute()
        self._updating.took(time.perf_counter() - start + self.kernel_ms / 1000.0)
        fault = model.failure_of(self._assembly)
        if fault:
            self.failed.emit(fault)
        warned = [w for w in model.warnings_of(self._assembly) if w.code == FLIPPED]
        if warned and self._worker.is_free:
            names = [name for warning in warned for name in warning.objects]
            self._worker.ask(Flips(self._frame, dict.fromkeys(names, np.zeros(0, int))))

    def _flips(self, asked: Flips) -> Flips:
        """Find the triangles that flip in the parts of a question, in the worker thread."""
        parts, seen, found = self._live.parts, asked.frame.positions, {}
        for name in asked.triangles:
            rest = parts[name]
            change = kernel.core().compare_quality(rest.points, seen[name], rest.triangles)
            found[name] = np.asarray(change.flipped_triangles)
        return Flips(asked.frame, found)

    def _recompute_regions(self) -> None:
        """Evaluate expressions between handles, which is cheap without the parts."""
        regions = model.regions(self._assembly)
        self._has_expressions = any(region.ExpressionEngine for region in regions)
        if self._has_expressions:
            self._assembly.Document.recompute(regions)
