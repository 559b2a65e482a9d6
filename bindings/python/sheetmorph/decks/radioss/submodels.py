# SPDX-License-Identifier: LGPL-2.1-or-later
"""Submodels of Radioss: offsets of the ids between //SUBMODEL and //ENDSUB."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...base.arrays import Ints
from ..model import Raw
from ..numbers import parse_integer
from ..placing import remember_placing
from ..text import DeckText
from .table import field, texts

_OLDEST = 51


@dataclass(frozen=True)
class Shift:
    """Offsets of the ids of nodes, elements, parts, properties, and all others."""

    other: int = 0
    node: int = 0
    element: int = 0
    part: int = 0
    property: int = 0


class Submodels:
    """The submodels that begin in one file; outer is the offset at its include."""

    def __init__(self, raw: Raw, file: int, outer: Shift):
        self._raw, self._file, self._outer = raw, file, outer
        text = raw.texts[file]
        marks = text.matches(rb"^//(SUBMODEL|ENDSUB)\b[^\r\n]*")
        self._begins = np.array([text.line_of(mark.start()) for mark in marks], dtype=np.int64)
        is_begin = [mark.group(1).upper() == b"SUBMODEL" for mark in marks]
        self._shifts = [
            self._shift(int(line)) if begin else outer
            for line, begin in zip(self._begins, is_begin)
        ]

    def at(self, line: int) -> Shift:
        """Return the offset in a line."""
        place = int(np.searchsorted(self._begins, line, side="right")) - 1
        return self._shifts[place] if place >= 0 else self._outer

    def _shift(self, line: int) -> Shift:
        text = self._raw.texts[self._file]
        words = [word.strip() for word in text.line(line).strip("/ ").split("/")]
        if len(words) > 2 and parse_integer(words[2]):
            name, reason = f"/{text.line(line).strip().lstrip('/')}", "has units of its own"
            remember_placing(self._raw, name, (self._file, line), reason)
        version = parse_integer(words[3].upper().lstrip("V")) if len(words) > 3 else None
        if version is not None and 0 < version < _OLDEST:
            what = f"version {version} of the format writes nodes in other columns"
            todo = "write the submodel in version 51 or later"
            raise self._raw.error((self._file, line), what, todo)
        other, node, element, part, _, kind = _numbers(text, line)
        return Shift(other, *(one or other for one in (node, element, part, kind)))


def _numbers(text: DeckText, line: int) -> list[int]:
    """Return the offsets in general, and of nodes, elements, parts, materials and properties.

    They follow the title.
    """
    cards = []
    for number in range(line + 1, min(line + 40, len(text))):
        shown = text.line(number)
        if shown.startswith("/"):
            break
        cards += [] if shown.startswith("#") else [shown]
    place = field("//SUBMODEL", "offsets")
    row = cards[place.line] if len(cards) > place.line else ""
    return [parse_integer(shown) or 0 for shown in texts(row, place)]


def shifted(numbers: Ints, shift: int) -> Ints:
    """Add an offset to all positive integers."""
    if not shift:
        return numbers
    return np.where(numbers > 0, numbers.astype(np.int64) + shift, 0)
