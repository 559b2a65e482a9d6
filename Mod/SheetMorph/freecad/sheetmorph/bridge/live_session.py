# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session for dragging: the pose changes, meshes and regions do not.

`ask` reads the document; `answer` does not touch it, so that a thread of its own may compute
frames, one at a time. A recompute in the pose of an exact answer finds that answer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import kernel, recipes
from freecad.sheetmorph.bridge.faults import fault_of, named
from freecad.sheetmorph.bridge.rest import RestPart
from freecad.sheetmorph.bridge.solving import (
    FAILURES,
    ControlMesh,
    Morph,
    SessionCache,
    cache_of,
    read_morph,
    shown_control_mesh,
    unsettled_words,
)
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.reporting import Progress
from freecad.sheetmorph.tools.poses import Pose


TURN, HALF_TURN = 3, 180.0
"""Which number of a motion is its angle, and how far that is tried, degrees."""


@dataclass(frozen=True)
class Question:
    """A pose by name in the recipe, the names of what is dragged, and how exact to be."""

    pose: Pose
    moved: tuple[str, ...] = ()
    is_exact: bool = False


@dataclass(frozen=True, eq=False)
class Frame:
    """All parts in one pose, by document object name: (n, 3) mm, global.

    `result`: the sheetmorph.Result, None at rest. Positions stay as they are while they are held.
    """

    question: Question
    positions: dict[str, np.ndarray]
    result: Any = None

    @property
    def is_preview(self) -> bool:
        """Whether the exact shape is refined besides, so that it may differ."""
        return self.result is not None and bool(self.result.previews)

    @property
    def unsettled(self) -> str:
        """What was not solved to its end, in sentences; empty if everything was."""
        return "" if self.result is None else unsettled_words(self.result)


@dataclass(frozen=True)
class ReachQuestion:
    """How far one number of a handle may go while the rest of a pose stays.

    `handle`: its name in the recipe; `number`: 0 to 2 a translation, mm, 3 the angle, degrees;
    `criteria`: as a study has them.
    """

    pose: Pose
    moved: tuple[str, ...]
    handle: str
    number: int
    criteria: dict


@dataclass(frozen=True)
class Reached:
    """From where to where that number may go, and what breaks beyond, empty if nothing does; both
    are empty if it may not be anywhere near 0."""

    question: ReachQuestion
    ends: tuple[float, ...] = ()
    whys: tuple[str, ...] = ()


class LiveSession:
    """Answers poses of one assembly with the positions of its parts."""

    def __init__(self, assembly, morph: Morph | None = None, cache: SessionCache | None = None):
        """Build or find the session of `assembly`; raises MorphError, one sentence.

        `morph`, `cache`: with both, the document is not read.
        """
        self._assembly = assembly
        self._shown: Frame | None = None
        self._cache = cache or cache_of(assembly)
        try:
            self._morph: Morph = morph or read_morph(assembly)
            held = self._morph.is_held()
            self._session = self._cache.session(self._morph) if held else None
            self._live = self._session and kernel.load().LiveFrames(self._session)
        except FAILURES as error:
            raise MorphError(fault_of(error)) from error

    @property
    def parts(self) -> dict[str, RestPart]:
        """The parts at rest by document object name."""
        return self._morph.rests

    @property
    def names(self) -> dict[str, str]:
        """Name in the recipe by document object name."""
        return self._morph.names

    def ask(self, moved: Iterable[str] = (), exact: bool = False) -> Question:
        """Return the question for the pose of the document; `moved`: document object names."""
        pose = recipes.pose_of(self._assembly, self.names)
        return Question(pose, tuple(self.names[name] for name in moved), exact)

    def posed(self, pose: Pose) -> Morph:
        """Return the morph of this session in a pose."""
        return replace(self._morph, pose=pose)

    @property
    def learning_failure(self) -> str:
        """What the learning of the present drag failed with, empty if it has not."""
        return "" if self._session is None else self._live.failure

    def answer(self, question: Question, goes_on: Progress | None = None) -> Frame:
        """Return all parts in a pose; not exact is 1e-6 of the size. Raises MorphError.

        `goes_on(fraction, task)` is asked while an exact answer takes long: as soon as it says no,
        the frame is a live one.
        """
        rests = self.parts
        if self._session is None:
            found, positions = None, {name: rest.points for name, rest in rests.items()}
        else:
            try:
                with named(self._morph.objects):
                    found, question = self._solve(question, goes_on)
            except FAILURES as error:
                raise MorphError(fault_of(error)) from error
            positions = {name: found.positions[self.names[name]] for name in rests}
            if question.is_exact:
                self._cache.remember(self._morph, question.pose, found)
        self._shown = Frame(question, positions, found)
        return self._shown

    def ask_reach(self, handle, number: int, criteria: dict) -> ReachQuestion:
        """Return the question for the pose of the document; `handle`: a document object."""
        asked, name = self.ask([handle.Name]), self.names[handle.Name]
        return ReachQuestion(asked.pose, asked.moved, name, number, criteria)

    def reach(self, asked: ReachQuestion, goes_on: Callable[[], bool]) -> Reached | None:
        """Return how far a number may go; None as soon as nobody waits."""
        if self._session is None:
            return Reached(asked)
        farthest = HALF_TURN if asked.number == TURN else float(self._session.size)
        ends = (-farthest, farthest)

        def answered(value: float):
            return self._live.deform(posed(asked, value), asked.moved)

        found = kernel.studies().Reach(answered, asked.criteria, goes_on).limits(ends)
        if found is None:
            return None
        reached = tuple(limit.share * end for limit, end in zip(found, ends))
        return Reached(asked, reached, tuple(limit.why for limit in found))

    def rest_of(self, frame: Frame, goes_on: Progress | None = None) -> dict[str, np.ndarray]:
        """Return all parts at rest with the sizes of a frame, (n, 3) mm, by document object name.

        The arrays stay the same ones while the sizes do. `goes_on`: as for `answer`.
        """
        if frame.result is None:
            return {name: rest.points for name, rest in self.parts.items()}
        sizes, is_exact = frame.result.sizes, frame.question.is_exact
        try:
            found = self._session.rest_shape(sizes, is_exact, goes_on if is_exact else None)
        except kernel.core().Cancelled:
            found = self._session.rest_shape(sizes, False)
        return {name: found.positions[self.names[name]] for name in self.parts}

    def deform(self, moved: Pose | None = None, exact: bool = False) -> dict[str, np.ndarray]:
        """Return local positions (n, 3) mm of every part, by document object name.

        The pose is the document's but for regions that are `moved`, by document object name. Not
        `exact` is 1e-6 of the size. Raises MorphError.
        """
        asked = self.ask(moved or (), exact)
        changed = {self.names[name]: motion for name, motion in (moved or {}).items()}
        frame = self.answer(Question({**asked.pose, **changed}, asked.moved, exact))
        return {n: rest.frame.to_local(frame.positions[n]) for n, rest in self.parts.items()}

    def control_mesh(self, contact=None) -> ControlMesh | None:
        """Return the control mesh of a contact object in the pose of the last answer, global.

        Without contact: the single one around everything. None: there is no such control mesh.
        """
        if self._session is None:
            return None
        shown = self._shown or self.answer(self.ask())
        return shown_control_mesh(shown.result, self._morph, contact and contact.Name)

    def _solve(self, question: Question, goes_on: Progress | None):
        if question.is_exact:
            try:
                return self._session.deform(question.pose, progress=goes_on), question
            except kernel.core().Cancelled:
                question = replace(question, is_exact=False)
        return self._live.deform(question.pose, question.moved), question


def posed(asked: ReachQuestion, value: float) -> Pose:
    """Return the pose of a question with another value of its number."""
    motion = asked.pose[asked.handle]
    if asked.number == TURN:
        motion = replace(motion, angle=value)
    else:
        shift = list(motion.translation)
        shift[asked.number] = value
        motion = replace(motion, translation=tuple(shift))
    return {**asked.pose, asked.handle: motion}


def live(assembly) -> LiveSession:
    """Return a session for dragging handles of `assembly`.

    To commit, set the handles' properties in a transaction and recompute: that solves exactly,
    with the session built here.
    """
    return LiveSession(assembly)
