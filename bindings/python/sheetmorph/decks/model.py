# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common data model of all deck formats: nodes, their locations in the file, elements."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ..base.arrays import Array, Floats, Ints
from ..base.errors import FileError
from .materials import Materials
from .text import DeckText

# How a number is written back: in its columns, between commas, in place of a word, as eight bytes,
# or in its full columns whatever part of them existed (tabs).
FIXED, FREE, WORD, BINARY, PADDED = range(5)
Opener = Callable[[Path], bytes]


@dataclass(frozen=True)
class Elements:
    """Elements of one kind of card.

    kind is "shell", "solid", "line", "rigid", "constraint" (equations between nodes, not a rigid
    body), "mass", "weld" or "frame". ids and properties are (m,). nodes (m, k) has node ids, 0
    where there is none. file is the index of the text, and lines (m,) count from 0.
    """

    name: str
    kind: str
    ids: Ints
    properties: Ints
    nodes: Ints
    file: int
    lines: Ints


@dataclass(frozen=True)
class Block:
    """Nodes of one file with their locations.

    Attributes
    ----------
    file : int
        Index of the text.
    lines, ids : array (n,)
        Lines from 0, and node ids.
    values : array (n, 3)
        Numbers as written.
    begins, widths : array (n, 3)
        Offsets of the fields, and their existing widths.
    room : int
        Largest number of characters.
    kind : int
        FIXED, FREE, WORD, BINARY or PADDED.
    systems : array (n,) or None
        Number of the coordinate system, 0 for the basic one.
    leads : dict
        Row and axis to the number of blanks (FIXED) or commas (FREE) before a field that the line
        is too short for, if all fields before it are written in full.
    """

    file: int
    lines: Ints
    ids: Ints
    values: Floats
    begins: Ints
    widths: Ints
    room: int
    kind: int = FIXED
    systems: Ints | None = None
    leads: dict[tuple[int, int], int] = field(default_factory=dict)


@dataclass(frozen=True)
class Place:
    """A card for messages: its name, id (0 if it has none), file, and line from 0."""

    card: str
    number: int
    file: int
    line: int
    what: str = ""


@dataclass(frozen=True)
class NamedSet:
    """A set of nodes, elements or properties.

    kind is "nodes", "elements", "properties", or "" if the deck does not say. blocks limits element
    ids to some of Raw.elements; empty means all.
    """

    name: str
    kind: str
    ids: Sequence[int] | Ints
    blocks: tuple[int, ...] = ()


@dataclass
class Raw:
    """The data that a reader collects.

    Attributes
    ----------
    mark : str
        Text before exponents.
    wins : str
        "last" if the last definition of a node counts, "same" if all must be equal.
    locked : dict
        Nodes that must not move, with the reason.
    thickness, names : dict
        Thickness, mm, and display name by property.
    materials : Materials
        Materials of the properties.
    placing : list of Place
        Cards that change node positions after they are read.
    cut : list of str
        Sentences on missing data, as in a truncated file.
    """

    form: str
    mark: str = "E"
    wins: str = "same"
    texts: list[DeckText] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    elements: list[Elements] = field(default_factory=list)
    stale: list[Place] = field(default_factory=list)
    placing: list[Place] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    cut: list[str] = field(default_factory=list)
    locked: dict[int, str] = field(default_factory=dict)
    thickness: dict[int, float] = field(default_factory=dict)
    names: dict[int, str] = field(default_factory=dict)
    materials: Materials = field(default_factory=Materials)
    sets: list[NamedSet] = field(default_factory=list)

    def miss(self, file: int, what: str, line: int | None = None) -> None:
        """Record that something is missing in a file, or at one of its lines from 0."""
        place = self.texts[file].name + ("" if line is None else f", line {line + 1}")
        self.cut.append(f"{place}: {what}")

    def error(self, place: tuple[int, int], what: str, todo: str = "correct the card") -> FileError:
        """Return a FileError at (file, line)."""
        return self.texts[place[0]].error(place[1], what, todo)


@dataclass(frozen=True)
class Table:
    """The unique nodes of a deck.

    ids, systems, files and lines are (n,), and values (n, 3) as written. rows has for each block
    the node (k,) of each of its lines, -1 where another definition counts.
    """

    ids: Ints
    values: Floats
    systems: Ints
    files: Ints
    lines: Ints
    rows: list[Ints]


def table_of(raw: Raw) -> Table:
    """Return the nodes of a deck.

    Raises FileError for invalid numbers and conflicting definitions.
    """
    for block in raw.blocks:
        _check(raw, block)
    if not raw.blocks:
        empty = np.zeros(0, dtype=np.int32)
        return Table(empty.astype(np.int64), np.zeros((0, 3)), empty, empty, empty, [])
    blocks = raw.blocks
    found: tuple[Array, ...] = (
        _whole([block.ids for block in blocks]),
        _whole([block.values for block in blocks]),
        _whole([_systems(block) for block in blocks]),
        _whole([np.broadcast_to(np.int32(b.file), len(b.ids)) for b in blocks]),
        _whole([block.lines.astype(np.int32, copy=False) for block in blocks]),
    )
    ids: Ints = found[0]
    row: Ints = np.arange(len(found[0]), dtype=np.int32)
    if (np.diff(ids) <= 0).any():
        by_place = (found[4], found[3], ids)
        order = np.lexsort(by_place) if raw.wins == "same" else np.argsort(ids, kind="stable")
        ordered = ids[order]
        if (ordered[1:] == ordered[:-1]).any():
            keep, row = _without_doubles(raw, found, order)
            found = tuple(some[keep] for some in found)
    order = np.lexsort((found[4], found[3])) if len(blocks) > 1 else np.arange(0)
    if (np.diff(order) != 1).any():
        # In the order of the file, independent of the form of each card.
        found = tuple(some[order] for some in found)
        back = np.empty(len(order) + 1, dtype=np.int32)
        back[order], back[-1] = np.arange(len(order)), -1
        row = back[row]
    ends = np.cumsum([len(block.ids) for block in blocks])
    ids, values, systems, files, lines = found
    return Table(ids, values, systems, files, lines, np.split(row, ends[:-1]))


def _whole(parts: list[Array]) -> Array:
    return parts[0] if len(parts) == 1 else np.concatenate(parts)


def _systems(block: Block) -> Ints:
    none = np.broadcast_to(np.int32(0), len(block.ids))
    return none if block.systems is None else block.systems.astype(np.int32, copy=False)


def _check(raw: Raw, block: Block) -> None:
    bad = np.flatnonzero(~np.isfinite(block.values).all(axis=1))
    if not len(bad):
        return
    row = int(bad[0])
    axis = int(np.flatnonzero(~np.isfinite(block.values[row]))[0])
    begin, width = int(block.begins[row, axis]), int(block.widths[row, axis])
    text = raw.texts[block.file]
    shown = text.data[begin : begin + width].decode("latin-1").strip()[:20]
    what = f'node {block.ids[row]}: "{shown}" is not a number'
    line = text.line_of(begin) if block.kind != BINARY else int(block.lines[row])
    raise raw.error((block.file, line), what)


def _without_doubles(raw: Raw, found: tuple[Array, ...], order: Ints) -> tuple[Ints, Ints]:
    """Return the rows that count, and for every row the number of its counting row.

    It is -1 if another definition replaces the row.
    """
    ids, values, systems, files, lines = found
    starts = np.flatnonzero(np.diff(ids[order], prepend=ids[order][0] - 1) != 0)
    group = np.zeros(len(ids), dtype=np.int64)
    group[starts[1:]] = 1
    group = np.cumsum(group)
    if raw.wins == "last":
        chosen = order[np.append(starts[1:], len(ids)) - 1]
    else:
        chosen = order[starts]
        first = chosen[group]
        same = (values[order] == values[first]).all(axis=1) & (systems[order] == systems[first])
        if not same.all():
            bad = int(order[np.flatnonzero(~same)[0]])
            other = int(first[np.flatnonzero(~same)[0]])
            name = raw.texts[files[other]].name
            what = f"node {ids[bad]} is defined twice, differently"
            what += f" (first in {name}, line {lines[other] + 1})"
            raise raw.error((int(files[bad]), int(lines[bad])), what, "remove one of the cards")
    keep = np.sort(chosen)
    row = np.full(len(ids), -1, dtype=np.int32)
    row[order] = np.searchsorted(keep, chosen[group])
    if raw.wins == "last":
        away = np.ones(len(ids), dtype=bool)
        away[keep] = False
        row[away] = -1
    return keep, row
