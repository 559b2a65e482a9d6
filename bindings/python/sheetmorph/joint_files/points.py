# SPDX-License-Identifier: LGPL-2.1-or-later
"""The content of a joint file, and its bytes with moved points."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..base.arrays import Floats
from ..base.errors import FileError

_REAL = re.compile(rb"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?")
# The squares of larger coordinates can overflow.
_LARGEST = 1e100


@dataclass
class Joint:
    """A weld, a bolt, or a line or face of adhesive.

    name is its id or label, kind is the type in the file, and line counts from 0. parts lists the
    joined parts, each with all its names. points and directions are rows.
    """

    name: str
    kind: str
    line: int
    parts: list[tuple[str, ...]] = field(default_factory=list)
    points: list[int] = field(default_factory=list)
    directions: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class Number:
    """A number in a file: its value and byte range."""

    value: float
    begin: int
    end: int


class JointFile:
    """A joint file.

    data has its bytes and form the name of its format. points is (n, 3), mm, and directions (d, 3)
    of any length. notes are remarks for the user.
    """

    def __init__(self, path: Path, data: bytes, form: str):
        self.path, self.data, self.form = path, data, form
        self.joints: list[Joint] = []
        self.notes: list[str] = []
        self.unit = 1.0
        self.comma = b"."
        self._points: list[list[Number]] = []
        self._directions: list[list[Number]] = []

    def add_point(self, joint: Joint, numbers: Sequence[Number]) -> None:
        """Add a point of a joint, in the unit of the file."""
        joint.points.append(len(self._points))
        self._points.append(list(numbers))

    def add_direction(self, joint: Joint, numbers: Sequence[Number]) -> None:
        """Add a direction that rotates with a joint."""
        joint.directions.append(len(self._directions))
        self._directions.append(list(numbers))

    @property
    def points(self) -> Floats:
        """Points (n, 3), mm."""
        return self.unit * _values(self._points)

    @property
    def directions(self) -> Floats:
        """Directions (d, 3) of any length."""
        return _values(self._directions)

    def save(self, points: Floats, directions: Floats, out: BinaryIO) -> None:
        """Write the file with points (n, 3), mm, and directions (d, 3).

        The bytes of unchanged numbers and of everything else stay the same.
        """
        edits = _edits(self._points, points, self.points, self.unit)
        edits += _edits(self._directions, directions, self.directions, 1.0)
        done = 0
        for number, value in sorted(edits, key=lambda edit: edit[0].begin):
            out.write(self.data[done : number.begin])
            out.write(repr(value).encode().replace(b".", self.comma))
            done = number.end
        out.write(self.data[done:])

    def error(self, line: int | None, what: str, todo: str = "correct the file") -> FileError:
        """Return a FileError at a line, counted from 0."""
        return FileError(self.path, what, todo, None if line is None else line + 1)

    def number(self, begin: int, end: int, line: int, what: str) -> Number:
        """Parse the number in a byte range, without blanks around it. Raises FileError."""
        raw = self.data[begin:end]
        shown = raw.strip()
        begin += len(raw) - len(raw.lstrip())
        plain = shown.replace(self.comma, b".") if self.comma != b"." else shown
        if _REAL.fullmatch(plain):
            value = float(plain.lower().replace(b"d", b"e"))
            if abs(value) <= _LARGEST:
                return Number(value, begin, begin + len(shown))
        text = shown.decode("latin-1")[:20]
        raise self.error(line, f'{what}: "{text}" is not a number')


def _values(rows: list[list[Number]]) -> Floats:
    return np.array([[one.value for one in row] for row in rows], dtype=float).reshape(-1, 3)


def _edits(
    rows: list[list[Number]], wanted: Floats, own: Floats, unit: float
) -> list[tuple[Number, float]]:
    changed = np.argwhere(wanted != own)
    return [(rows[k][axis], float(wanted[k, axis] / unit)) for k, axis in changed.tolist()]
