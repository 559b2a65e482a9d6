# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length of a drag as text, and a typed value in its place; needs no FreeCAD."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad.sheetmorph.tools.motion import Motion, rounded
from freecad.sheetmorph.tools.words import plain

FIRST = "0123456789.,+-("
"""The characters that begin a value; any may follow, as in 100/4, 10 in, 2*(3+1)."""


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
