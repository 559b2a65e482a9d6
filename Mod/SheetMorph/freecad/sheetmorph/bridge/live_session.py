# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session for dragging: the pose changes, meshes and regions do not.

`ask` reads the document and `answer` does not, so that a separate thread can compute frames, one at
a time. A recompute in the pose of an exact answer reuses that answer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import kernel, recipes
from freecad.sheetmorph.bridge.faults import as_morph_errors, named
from freecad.sheetmorph.bridge.rest import RestPart
from freecad.sheetmorph.bridge.solving import (
    ControlMesh,
    Morph,
    SessionCache,
    cache_of,
    read_morph,
    shown_control_mesh,
    unsettled_words,
)
from freecad.sheetmorph.reporting import Progress
from freecad.sheetmorph.tools.motion import Moving
from freecad.sheetmorph.tools.poses import Pose, share_of


TURN, HALF_TURN = 3, 180.0
"""Index of the angle in a motion, and the largest angle to try, degrees."""


@dataclass(frozen=True)
class Question:
    """A request: pose by recipe name, names of the dragged entries, and accuracy.

    A share below 1 shows the pose on its way from rest, which is a view only: the document never
    follows it.
    """

    pose: Pose
    moved: tuple[str, ...] = ()
    is_exact: bool = False
    share: float = 1.0

    @property
    def shown_pose(self) -> Pose:
        """The pose to compute."""
        return self.pose if self.share == 1.0 else share_of(self.pose, self.share)


@dataclass(frozen=True, eq=False)
class Frame:
    """All parts in one pose, by document object name: (n, 3), mm, global.

    `result` is the sheetmorph.Result, None at rest. The positions never change while they are
    referenced.
    """

    question: Question
    positions: dict[str, np.ndarray]
    result: Any = None

    @property
    def is_preview(self) -> bool:
        """Whether an exact answer refines the shape further, so that it may differ."""
        return self.result is not None and bool(self.result.previews)

    @property
    def unsettled(self) -> str:
        """Sentences on solves that did not converge, or an empty text."""
        return "" if self.result is None else unsettled_words(self.result)


@dataclass(frozen=True)
class ReachQuestion:
    """A request for the admissible range of one number of a handle in a pose.

    `handle` is its recipe name. `number` is 0 to 2 for a translation, mm, and 3 for the angle,
    degrees. `criteria` are those of a study.
    """

    pose: Pose
    moved: tuple[str, ...]
    handle: str
    number: int
    criteria: dict


@dataclass(frozen=True)
class Reached:
    """The admissible range of the number, and what fails beyond each end, if anything.

    Both are empty if even 0 is not admissible.
    """

    question: ReachQuestion
    ends: tuple[float, ...] = ()
    whys: tuple[str, ...] = ()


class LiveSession:
    """The computation of the positions of an assembly's parts for given poses."""

    def __init__(self, assembly, morph: Morph | None = None, cache: SessionCache | None = None):
        """Build or find the session of `assembly`. Raises MorphError with one sentence.

        With both `morph` and `cache`, the document is not read.
        """
        self._assembly = assembly
        self._shown: Frame | None = None
        self._cache = cache or cache_of(assembly)
        with as_morph_errors():
            self._morph: Morph = morph or read_morph(assembly)
            held = self._morph.is_held()
            self._session = self._cache.session(self._morph) if held else None
            self._live = self._session and kernel.load().LiveFrames(self._session)
            self._pose: Pose = self._morph.pose

    @property
    def parts(self) -> dict[str, RestPart]:
        """The parts at rest by document object name."""
        return self._morph.rests

    @property
    def names(self) -> dict[str, str]:
        """Recipe name by document object name."""
        return self._morph.names

    def ask(self, moved: Iterable[str] = (), exact: bool = False) -> Question:
        """Return the request for the document's pose; `moved` has document object names."""
        self._pose = recipes.pose_of(self._assembly, self.names)
        return Question(self._pose, tuple(self.names[name] for name in moved), exact)

    def follow(self, moving: Moving) -> Question:
        """Return the request for the last pose read, with another motion of one handle."""
        name = self.names[moving.name]
        self._pose = {**self._pose, name: moving.prescribed}
        return Question(self._pose, (name,))

    def ask_share(self, share: float) -> Question:
        """Return the request for a share of the last pose read, for a view without a commit."""
        return Question(self._pose, tuple(self._pose), share=share)

    def posed(self, pose: Pose) -> Morph:
        """Return the morph of this session in a pose."""
        return replace(self._morph, pose=pose)

    @property
    def learning_failure(self) -> str:
        """Error of the background work of the current drag, or an empty text."""
        return "" if self._session is None else self._live.failure

    def answer(self, question: Question, goes_on: Progress | None = None) -> Frame:
        """Return all parts in a pose; without exact the accuracy is 1e-6 of the size.

        `goes_on(fraction, task)` is called during an exact answer; False switches to a live frame.
        Raises MorphError.
        """
        rests = self.parts
        if self._session is None:
            found, positions = None, {name: rest.points for name, rest in rests.items()}
        else:
            with as_morph_errors(), named(self._morph.objects):
                found, question = self._solve(question, goes_on)
            positions = {name: found.positions[self.names[name]] for name in rests}
            if question.is_exact:
                self._cache.remember(self._morph, question.pose, found)
        self._shown = Frame(question, positions, found)
        return self._shown

    def ask_reach(self, handle, number: int, criteria: dict) -> ReachQuestion:
        """Return the range request for the document's pose; `handle` is a document object."""
        asked, name = self.ask([handle.Name]), self.names[handle.Name]
        return ReachQuestion(asked.pose, asked.moved, name, number, criteria)

    def reach(self, asked: ReachQuestion, goes_on: Callable[[], bool]) -> Reached | None:
        """Return the admissible range of a number; None as soon as nobody waits."""
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
        """Return all parts at rest with the sizes of a frame, (n, 3) mm, by object name.

        The same sizes return the same arrays. `goes_on` is as for `answer`.
        """
        if frame.result is None:
            return {name: rest.points for name, rest in self.parts.items()}
        sizes, is_exact = frame.result.sizes, frame.question.is_exact
        try:
            found = self._session.rest_shape(sizes, is_exact, goes_on if is_exact else None)
        except kernel.core().Cancelled:
            found = self._session.rest_shape(sizes, False)
        return {name: found.positions[self.names[name]] for name in self.parts}

    def control_mesh(self, contact=None) -> ControlMesh | None:
        """Return the control mesh of a contact object in the last pose, global, or None.

        Without a contact it is the single control mesh around all parts.
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
        return self._live.deform(question.shown_pose, question.moved), question


def posed(asked: ReachQuestion, value: float) -> Pose:
    """Return the pose of a request with another value of its number."""
    motion = asked.pose[asked.handle]
    if asked.number == TURN:
        motion = replace(motion, angle=value)
    else:
        shift = list(motion.translation)
        shift[asked.number] = value
        motion = replace(motion, translation=tuple(shift))
    return {**asked.pose, asked.handle: motion}
