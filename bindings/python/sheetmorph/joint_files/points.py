# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of welds and bolts says, and the same bytes with points that moved."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..arrays import Floats
from ..errors import FileError

_REAL = re.compile(rb"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?")
# Beyond it, squares of coordinates overflow.
_LARGEST = 1e100


@dataclass
class Joint:
    """A weld, a bolt, a line or a face of glue.

    name: its id or label; kind: what the file calls it; line: from 0; parts: what it joins, each by
    all the names that the file gives; points, directions: their rows.
    """

    name: str
    kind: str
    line: int
    parts: list[tuple[str, ...]] = field(default_factory=list)
    points: list[int] = field(default_factory=list)
    directions: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class Number:
    """A number in a file: its value, and where its bytes are."""

    value: float
    begin: int
    end: int


class JointFile:
    """A file of joints.

    path; data: its bytes; form: the name of the format; joints; points: (n, 3) mm; directions:
    (d, 3), of any length; notes: what a user should know.
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
        """A point of a joint, in the unit of the file."""
        joint.points.append(len(self._points))
        self._points.append(list(numbers))

    def add_direction(self, joint: Joint, numbers: Sequence[Number]) -> None:
        """A direction that turns with a joint."""
        joint.directions.append(len(self._directions))
        self._directions.append(list(numbers))

    @property
    def points(self) -> Floats:
        """(n, 3) mm."""
        return self.unit * _values(self._points)

    @property
    def directions(self) -> Floats:
        """(d, 3), of any length."""
        return _values(self._directions)

    def save(self, points: Floats, directions: Floats, out: BinaryIO) -> None:
        """Write the file with its points at (n, 3) mm and its directions (d, 3); the bytes of
        numbers that stay, and all others, are as they were."""
        edits = _edits(self._points, points, self.points, self.unit)
        edits += _edits(self._directions, directions, self.directions, 1.0)
        done = 0
        for number, value in sorted(edits, key=lambda edit: edit[0].begin):
            out.write(self.data[done : number.begin])
            out.write(repr(value).encode().replace(b".", self.comma))
            done = number.end
        out.write(self.data[done:])

    def error(self, line: int | None, what: str, todo: str = "correct the file") -> FileError:
        """A FileError at a line from 0."""
        return FileError(self.path, what, todo, None if line is None else line + 1)

    def number(self, begin: int, end: int, line: int, what: str) -> Number:
        """The number in some bytes, blanks around it left out. Raises FileError."""
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
