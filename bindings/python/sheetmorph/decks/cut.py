# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixed columns of many lines at once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.blocks import chunks
from .model import FIXED, Block, Raw
from .numbers import parse_integers, parse_reals


@dataclass(frozen=True)
class Cut:
    """Lines of a file.

    file is the index of its text and rows (n,) are lines from 0. stops (l,) has the end of the text
    in every line of the file. card names the lines in messages.
    """

    raw: Raw
    file: int
    rows: Ints
    stops: Ints
    card: str

    def integers(self, column: int, width: int, blank: int | None = None) -> Ints:
        """Return integers (n,) in a column range; blank is the value of empty fields, if allowed.

        Raises FileError.
        """
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
        """Return numbers (n,) in a column range; 0 where blank, NaN where invalid."""
        text = self.raw.texts[self.file]
        found = np.empty(len(self.rows))
        for part in chunks(len(self.rows)):
            at = self.rows[part]
            found[part] = parse_reals(text.columns(text.begins[at] + column, self.stops[at], width))
        return found

    def table(self, column: int, width: int, count: int) -> Ints:
        """Return integers (n, count) in adjacent columns; blank ones are 0."""
        some = (self.integers(column + k * width, width, 0) for k in range(count))
        return side_by_side(some, (len(self.rows), count))

    def nodes(self, id_width: int, width: int) -> Block:
        """Return nodes: an id and three coordinates in adjacent columns."""
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
    """Return a copy of integers with half the memory if they fit."""
    return values.astype(np.int32 if _fit(values) else values.dtype)


def _fit(values: Ints) -> bool:
    return not values.size or bool(-(2**31) < values.min() and values.max() < 2**31)


def side_by_side(columns: Iterable[Ints], shape: tuple[int, int]) -> Ints:
    """Return columns of integers as one array, with half the memory if they fit."""
    whole: Ints = np.empty(shape, dtype=np.int32)
    for k, column in enumerate(columns):
        if whole.dtype == np.int32 and not _fit(column):
            whole = whole.astype(np.int64)
        whole[:, k] = column
    return whole
