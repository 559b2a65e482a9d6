# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comma-separated fields and blank-separated words of many lines at once."""

from __future__ import annotations

import numpy as np

from ..base.arrays import Bools, Codes, Floats, Ints
from ..base.blocks import chunks
from .model import FREE, Block, Raw
from .numbers import parse_integers, parse_reals
from .text import DeckText

# Longer fields are not numbers.
_LONGEST = 64


def comma_places(text: DeckText, rows: Ints, count: int) -> tuple[Ints, Ints]:
    """Return begins and ends (n, count) of the first fields of ascending lines.

    A missing field begins after the end of its line.
    """
    commas = _commas(text, rows).astype(np.int64)
    first = np.searchsorted(commas, text.begins[rows])
    stops = text.ends[rows].astype(np.int64)
    limit = np.append(commas, np.iinfo(np.int64).max)
    begins = np.empty((len(rows), count), dtype=np.int64)
    ends = np.empty_like(begins)
    begin = text.begins[rows].astype(np.int64)
    for k in range(count):
        comma = limit[np.minimum(first + k, len(commas))]
        begins[:, k] = begin
        ends[:, k] = np.minimum(comma, stops)
        begin = np.where(comma < stops, comma + 1, stops + 1)
    return begins, np.maximum(ends, np.minimum(begins, stops[:, None]))


def _commas(text: DeckText, rows: Ints) -> Ints:
    low, high = int(text.begins[rows[0]]), int(text.ends[rows[-1]])
    size = 1 << 20
    found = [
        (np.flatnonzero(text.codes[at : min(at + size, high)] == ord(",")) + at).astype(
            text.begins.dtype
        )
        for at in range(low, high, size)
    ]
    return np.concatenate(found) if found else np.empty(0, dtype=np.int64)


def integers(text: DeckText, begins: Ints, ends: Ints) -> tuple[Ints, Bools]:
    """Return integers (n,) between offsets, 0 where blank, and which are valid."""
    codes = _codes(text, begins, ends)
    return parse_integers(codes)


def reals(text: DeckText, begins: Ints, ends: Ints) -> Floats:
    """Return numbers (n,) between offsets, 0 where blank, NaN where invalid."""
    return parse_reals(_codes(text, begins, ends))


def _codes(text: DeckText, begins: Ints, ends: Ints) -> Codes:
    width = int(np.clip((ends - begins).max(initial=1), 1, _LONGEST))
    codes = text.columns(begins, ends, width)
    codes[codes == 9] = 32
    too_long = np.flatnonzero(ends - begins > width)
    codes[too_long] = ord("?")
    return codes


def comma_nodes(raw: Raw, file: int, rows: Ints, room: int) -> Block:
    """Return nodes: an id and three coordinates with commas; missing coordinates are 0."""
    text = raw.texts[file]
    leads: dict[tuple[int, int], int] = {}
    count = len(rows)
    ids, values = np.empty(count, dtype=np.int64), np.empty((count, 3))
    begins = np.empty((count, 3), dtype=text.begins.dtype)
    widths = np.empty((count, 3), dtype=np.uint8)
    for part in chunks(count):
        found = _comma_nodes(raw, file, rows[part], (part.start, leads))
        ids[part], values[part], begins[part], widths[part] = found
    lines = rows.astype(np.int32, copy=False)
    return Block(file, lines, ids, values, begins, widths, room, FREE, None, leads)


def _comma_nodes(
    raw: Raw, file: int, rows: Ints, told: tuple[int, dict[tuple[int, int], int]]
) -> tuple[Ints, Floats, Ints, Ints]:
    text = raw.texts[file]
    first, leads = told
    begins, ends = comma_places(text, rows, 4)
    ids, sound = integers(text, begins[:, 0], ends[:, 0])
    sound &= ids > 0
    if not sound.all():
        line = int(rows[np.flatnonzero(~sound)[0]])
        shown = text.line(line).split(",")[0].strip()[:20]
        raise raw.error((file, line), f'*NODE: "{shown}" is not the number of a node')
    values = np.stack([reals(text, begins[:, k], ends[:, k]) for k in (1, 2, 3)], axis=1)
    stops = text.ends[rows].astype(np.int64)[:, None]
    places, lengths = begins[:, 1:], ends[:, 1:]
    missing = places > stops
    for row, axis in np.argwhere(missing).tolist():
        leads[first + row, axis] = 1
    places, lengths = np.minimum(places, stops), np.minimum(lengths, stops)
    places, lengths = _trimmed(text, places, lengths)
    return ids, values, places, np.minimum(lengths - places, 255).astype(np.uint8)


def _trimmed(text: DeckText, begins: Ints, ends: Ints) -> tuple[Ints, Ints]:
    """Return the places without blanks at both ends."""
    shape = begins.shape
    one, two = begins.reshape(-1), ends.reshape(-1)
    codes = _codes(text, one, two)
    there = codes != 32
    filled = there.any(axis=1)
    left = np.where(filled, there.argmax(axis=1), 0)
    right = np.where(filled, there.shape[1] - there[:, ::-1].argmax(axis=1), 0)
    return (one + left).reshape(shape), (one + np.where(filled, right, 0)).reshape(shape)


def words(text: DeckText, begin: int, end: int) -> tuple[Ints, Ints]:
    """Return begins and ends of the words between two offsets."""
    size = 1 << 20
    kind = text.begins.dtype
    edges = []
    before = True
    for at in range(begin, end, size):
        blank = text.codes[at : min(at + size, end)] <= 32
        change = np.flatnonzero(blank != np.concatenate([[before], blank[:-1]])) + at
        edges.append(change.astype(kind))
        before = bool(blank[-1])
    if not before:
        edges.append(np.array([end], dtype=kind))
    found = np.empty(sum(map(len, edges)), dtype=kind)
    place = len(found)
    while edges:  # In reverse order, so that each piece can be freed.
        last = edges.pop()
        place -= len(last)
        found[place : place + len(last)] = last
    return found[::2], found[1::2]
