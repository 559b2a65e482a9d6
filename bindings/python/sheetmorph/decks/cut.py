# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of many lines at once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats, Ints
from ..blocks import chunks
from .model import FIXED, Block, Raw
from .numbers import parse_integers, parse_reals


@dataclass(frozen=True)
class Cut:
    """Some lines of a file.

    file: index of its text; rows: (n,) lines from 0; stops: (l,) where the text of every line of
    the file ends; card: what they are, for messages.
    """

    raw: Raw
    file: int
    rows: Ints
    stops: Ints
    card: str

    def integers(self, column: int, width: int, blank: int | None = None) -> Ints:
        """(n,) whole numbers in some columns; what blank ones are, if they may be. FileError."""
        text = self.raw.texts[self.file]
        found = np.empty(len(self.rows), dtype=np.int64)
        for part in chunks(len(self.rows)):
            at = self.rows[part]
            codes = text.columns(text.begins[at] + column, self.stops[at], width)
            found[part], sound = parse_integers(codes)
            empty = (codes == 32).all(axis=1)
            if blank is None:
                sound &= ~empty
            else:
                found[part][empty] = blank
            if not sound.all():
                self._refuse(int(np.flatnonzero(~sound)[0] + part.start), column, width)
        return found

    def _refuse(self, row: int, column: int, width: int) -> None:
        line = int(self.rows[row])
        shown = self.raw.texts[self.file].line(line)[column : column + width].strip()
        what = f'{self.card}: "{shown}" in columns {column + 1} to {column + width} is not a whole'
        raise self.raw.error((self.file, line), f"{what} number")

    def reals(self, column: int, width: int) -> Floats:
        """(n,) numbers in some columns; 0 where blank, NaN where there is no number."""
        text = self.raw.texts[self.file]
        found = np.empty(len(self.rows))
        for part in chunks(len(self.rows)):
            at = self.rows[part]
            found[part] = parse_reals(text.columns(text.begins[at] + column, self.stops[at], width))
        return found

    def table(self, column: int, width: int, count: int) -> Ints:
        """(n, count) whole numbers in columns one after another, blank ones 0."""
        some = (self.integers(column + k * width, width, 0) for k in range(count))
        return side_by_side(some, (len(self.rows), count))

    def nodes(self, id_width: int, width: int) -> Block:
        """Nodes: an id and three coordinates one behind the other."""
        text = self.raw.texts[self.file]
        ids = self.integers(0, id_width)
        values = np.empty((len(ids), 3))
        for k in range(3):
            values[:, k] = self.reals(id_width + k * width, width)
        columns = id_width + width * np.arange(3)
        starts, stops = text.begins[self.rows], self.stops[self.rows]
        begins = starts[:, None] + columns
        leads = {}
        short = np.flatnonzero(stops < begins[:, 2] + width)
        widths = np.full((len(ids), 3), width, np.uint8)
        room = stops[short, None] - begins[short]
        widths[short] = np.clip(room, 0, width)
        begins[short] = np.minimum(begins[short], stops[short, None])
        for k, gaps in zip(short.tolist(), room.tolist()):
            first = next((axis for axis in range(3) if gaps[axis] <= 0), None)
            if first is not None and gaps[first] < 0 and (first == 0 or gaps[first - 1] <= 0):
                leads[k, first] = -gaps[first]
        begins = begins.astype(text.begins.dtype)
        return Block(
            self.file, self.rows.astype(np.int32), ids, values, begins, widths, width, FIXED,
            None, leads,
        )  # fmt: skip


def small(values: Ints) -> Ints:
    """A copy of whole numbers, in half the memory where they fit."""
    return values.astype(np.int32 if _fit(values) else values.dtype)


def _fit(values: Ints) -> bool:
    return not values.size or bool(-(2**31) < values.min() and values.max() < 2**31)


def side_by_side(columns: Iterable[Ints], shape: tuple[int, int]) -> Ints:
    """Columns of whole numbers as one array of a shape, small() if they fit."""
    whole: Ints = np.empty(shape, dtype=np.int32)
    for k, column in enumerate(columns):
        if whole.dtype == np.int32 and not _fit(column):
            whole = whole.astype(np.int64)
        whole[:, k] = column
    return whole
