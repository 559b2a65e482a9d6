# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion of a region, one type from the mouse to the kernel."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad.sheetmorph.tools.local_axes import GLOBAL
from freecad.sheetmorph.tools.words import plain

Triple = tuple[float, float, float]
CENTROID = "centroid"
"""The value of `pivot` in scripts and saved poses for a turn about the centroid."""
UP = (0.0, 0.0, 1.0)
FIRST = "0123456789.,+-("
"""The characters that begin a value; any may follow, as in 100/4, 10 in, 2*(3+1)."""


class Turn(NamedTuple):
    """A rotation about an axis of any length."""

    axis: Triple
    radians: float


@dataclass(frozen=True)
class Motion:
    """A motion from rest, global: translation mm, axis, angle in degrees, pivot mm.

    A form feature that follows the sheet has the translation None; an axis None lets the sheet turn
    it. A pivot None is the centroid. A size (mm) None keeps the present size.
    """

    translation: Triple | None = (0.0, 0.0, 0.0)
    axis: Triple | None = UP
    angle: float = 0.0
    pivot: Triple | None = None
    size: float | None = None
    target = None  # only points have a target, and no object of a document has one

    @property
    def rotation(self) -> Turn | None:
        """The rotation for the kernel, None if the motion prescribes none."""
        if self.axis is None or (self.angle == 0.0 and self.translation is not None):
            return None
        return Turn(self.axis if self.angle else UP, math.radians(self.angle))

    def entry(self) -> dict:
        """Return the motion as an entry of a recipe."""
        told: dict = {}
        if self.translation is not None:
            told["translation"] = list(self.translation)
        if self.rotation is not None:
            told["rotation"] = {"axis": list(self.rotation.axis), "degrees": self.angle}
        if self.pivot is not None:
            told["pivot"] = list(self.pivot)
        return told if self.size is None else {**told, "size": self.size}

    def fault(self) -> str:
        """Return the fault of the motion as a sentence, empty if it has none."""
        if self.axis is not None and not any(self.axis):
            return "The axis is zero: give it a direction."
        return ""

    def is_rest(self) -> bool:
        """Return whether the motion moves nothing."""
        return not any(self.translation) and self.angle == 0.0

    def arguments(self) -> dict:
        """Return the arguments of `api.set_motion`."""
        pivot = CENTROID if self.pivot is None else self.pivot
        turn = {"axis": self.axis, "angle": self.angle}
        return {"translation": self.translation, **turn, "pivot": pivot}

    def keywords(self) -> dict[str, str]:
        """Return the arguments as source text that evaluates to the same numbers."""
        return {name: repr(value) for name, value in self.arguments().items()}

    def place(self, pivot: Triple) -> Triple:
        """Return where a pivot at rest, (3,) mm, moves."""
        x, y, z = map(sum, zip(pivot, self.translation))
        return x, y, z

    def shifted(self, shift) -> Motion:
        """Return the motion with a further shift (3,) mm."""
        moved = np.asarray(self.translation) + np.asarray(shift)
        return replace(self, translation=rounded(moved))

    def turned(self, translation, axis, angle: float) -> Motion:
        """Return a motion with another translation and rotation about the same pivot.

        Axis and whole turns stay if the rotation is equal to the present one.
        """
        other = replace(self, translation=translation)
        if not angle and not self.angle:
            return other
        if angle:
            other = replace(other, axis=axis, angle=angle)
        else:
            other = replace(other, angle=0.0)
        is_same = np.allclose(other.matrix(), self.matrix(), atol=1e-5)
        return replace(self, translation=translation) if is_same else other

    def about(self, pivot, place) -> Motion:
        """Return the same motion about another pivot, whose moved position is `place` (3,) mm.

        `pivot` (3,) mm is the position of the present pivot at rest.
        """
        turn, start = self.matrix(), np.asarray(pivot, float)
        moved = np.asarray(place, float) - start - np.asarray(self.translation)
        found = start + turn.T @ moved
        shift = np.asarray(place, float) - found
        return replace(self, translation=tuple(shift.tolist()), pivot=tuple(found.tolist()))

    def matrix(self) -> np.ndarray:
        """Return the rotation as a matrix (3, 3)."""
        x, y, z = np.asarray(self.axis, float) / np.linalg.norm(self.axis)
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        turn = np.radians(self.angle)
        return np.eye(3) + np.sin(turn) * cross + (1.0 - np.cos(turn)) * (cross @ cross)


class Moving:
    """The motion of the chosen handle: mouse and fields set it, widgets and scene observe it.

    An observer is called with this object and the motion before, None after another choice.
    """

    def __init__(self, centroid: Callable[[str], Triple]):
        """Start without a handle; `centroid(name)` returns the centroid of one, (3,) mm."""
        self.name, self.motion, self._is_free = "", Motion(), False
        self.axes = GLOBAL
        self._centroid = centroid
        self._observers: list[Callable] = []

    def observe(self, observer: Callable) -> None:
        """Call `observer(moving, before)` after every change."""
        self._observers = [*self._observers, observer]

    def leave(self, observer: Callable) -> None:
        """Call an observer no longer."""
        self._observers = [one for one in self._observers if one != observer]

    def stop(self) -> None:
        """Call no observer any more."""
        self._observers = []

    def choose(
        self, name: str, motion: Motion, is_free: bool = False, axes: np.ndarray = GLOBAL
    ) -> None:
        """Observe another handle; with `is_free` the sheet determines its rotation.

        `axes` are the directions of its arrows before the rotation, as columns (3, 3).
        """
        self.name, self.motion, self._is_free, self.axes = name, motion, is_free, axes
        self._notify(None)

    def set(self, motion: Motion) -> None:
        """Move the handle; an equal motion changes nothing."""
        before, self.motion = self.motion, motion
        if motion != before:
            self._notify(before)

    @property
    def is_global(self) -> bool:
        """Whether the fields and arrows are along the axes of the document."""
        return self.axes is GLOBAL

    @property
    def pivot(self) -> Triple:
        """The pivot at rest, (3,) mm."""
        return self.motion.pivot or self._centroid(self.name)

    @property
    def place(self) -> Triple:
        """The moved pivot, (3,) mm."""
        return self.motion.place(self.pivot)

    @property
    def prescribed(self) -> Motion:
        """The motion for the kernel."""
        return replace(self.motion, angle=0.0) if self._is_free else self.motion

    def _notify(self, before: Motion | None) -> None:
        for observer in self._observers:
            observer(self, before)


class Pull:
    """A drag from one motion to another, along a direction or about an axis."""

    def __init__(self, start: Motion):
        self._start = self._now = start
        self.text = ""

    def moved(self, now: Motion) -> bool:
        """Set the present motion of the mouse; return False if a typed value replaces it."""
        if not self.text:
            self._now = now
        return not self.text

    @property
    def is_turn(self) -> bool:
        """Whether the drag turns and does not shift."""
        return not self._shift().any() and self._angle() != 0.0

    def described(self) -> str:
        """Return the length or angle of the drag, or the typed text."""
        if self.text:
            return f"{self.text}▏"
        if self.is_turn:
            return f"{plain(self._angle(), 4)}°"
        return f"{plain(float(np.linalg.norm(self._shift())), 4)} mm"

    def type(self, key: str) -> bool:
        """Add a typed character, or delete one if `key` is empty; return False if refused."""
        if key and not (key.isprintable() and (self.text or key in FIRST)):
            return False
        if not self._shift().any() and self._angle() == 0.0:
            return False  # the drag has no direction yet
        self.text = self.text + key if key else self.text[:-1]
        return True

    def with_value(self, value: float) -> Motion:
        """Return the motion of the drag with another length in mm, or angle in degrees."""
        if self.is_turn:
            sign = 1.0 if self._angle() > 0.0 else -1.0
            return replace(self._now, angle=self._start.angle + sign * value)
        way = self._shift() / np.linalg.norm(self._shift())
        translation = np.asarray(self._start.translation) + value * way
        return replace(self._now, translation=rounded(translation))

    def _shift(self) -> np.ndarray:
        return np.asarray(self._now.translation) - np.asarray(self._start.translation)

    def _angle(self) -> float:
        same = self._start.angle == 0.0 or np.allclose(self._start.axis, self._now.axis)
        return self._now.angle - self._start.angle if same else self._now.angle


def motion_from(entry: dict) -> Motion:
    """Return the motion of a handle or form feature from a recipe's pose entry."""
    turn = entry.get("rotation") or {"degrees": 0.0}
    shift = tuple(map(float, entry.get("translation", (0.0, 0.0, 0.0))))
    axis = tuple(map(float, turn["axis"])) if turn["degrees"] else UP
    pivot = tuple(map(float, entry["pivot"])) if "pivot" in entry else None
    return Motion(shift, axis, float(turn["degrees"]), pivot)


def rounded(values) -> Triple:
    """Return values rounded to 0.0001, since a mouse is less exact."""
    x, y, z = (round(float(value), 4) + 0.0 for value in values)
    return x, y, z
