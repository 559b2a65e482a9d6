# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh meshes, versions 2 and 4, text and binary."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...base.arrays import Array, Floats, Ints
from ...base.errors import FileError
from ...base.blocks import CHUNK, chunks
from ..commas import integers, reals, words
from ..cut import small
from ..deck import Deck
from ..includes import Included
from ..model import BINARY, WORD, Block, Elements, Opener, Place, Raw
from ..numbers import LARGEST
from .names import PhysicalGroups

SUFFIXES = (".msh",)
_ROOM = 24
# Element types: kind and number of nodes.
_TYPES = {
    1: ("line", 2), 2: ("shell", 3), 3: ("shell", 4), 4: ("solid", 4), 5: ("solid", 8),
    6: ("solid", 6), 7: ("solid", 5), 8: ("line", 3), 9: ("shell", 6), 10: ("shell", 9),
    11: ("solid", 10), 12: ("solid", 27), 13: ("solid", 18), 14: ("solid", 14), 15: ("mass", 1),
    16: ("shell", 8), 17: ("solid", 20), 18: ("solid", 15), 19: ("solid", 13),
}  # fmt: skip
_MOST = 10**9


def read_gmsh(path: Path, opener: Opener) -> Deck:
    """Read a mesh. Raises FileError."""
    raw = Raw("Gmsh", mark="E")
    Included(raw, path, opener).first(path)
    reader = _Binary(raw) if _is_binary(raw) else _Text(raw)
    reader.read()
    raw.sets += reader.groups.sets(raw, section_of(raw, "PhysicalNames"))
    for mark in raw.texts[0].matches(rb'^[ \t]*2[ \t]+(\d+)[ \t]+"([^"\r\n]*)"'):
        raw.names[int(mark.group(1)[:18])] = mark.group(2).decode("latin-1")
    return Deck(raw)


def section_of(raw: Raw, name: str) -> bytes:
    """Return the text between $NAME and $EndNAME, empty if they are missing."""
    found = raw.texts[0].matches(rb"^\$(End)?" + name.encode() + rb"\b")
    return raw.texts[0].data[found[0].end() : found[1].start()] if len(found) > 1 else b""


@dataclass(frozen=True)
class _Format:
    version: float
    binary: bool
    order: str
    end: int


def _format(raw: Raw) -> _Format:
    text = raw.texts[0]
    found = text.matches(rb"^\$MeshFormat\s+(\d+(?:\.\d+)?)\s+([01])\s+(\d+)[^\n]*\n")
    if not found:
        raise raw.error((0, 0), "there is no $MeshFormat", "export it as Gmsh 2.2 or 4.1")
    mark = found[0]
    line = text.line_of(mark.start())
    version = float(mark.group(1))
    if version not in (2.0, 2.1, 2.2, 4.0, 4.1) or mark.group(3) != b"8":
        what = f"version {version:g} of the format is not read"
        raise raw.error((0, line), what, "export it as Gmsh 2.2 or 4.1")
    order = "<"
    if mark.group(2) == b"1":
        one = text.data[mark.end() : mark.end() + 4]
        order = "<" if one == b"\1\0\0\0" else ">"
        if one not in (b"\1\0\0\0", b"\0\0\0\1"):
            what = "the byte order is missing"
            raise raw.error((0, line), what, "export it again")
        if order == ">" or version == 4.0:
            what = "binary files of this kind are not read"
            raise raw.error((0, line), what, "export it as text")
    return _Format(version, mark.group(2) == b"1", order, mark.end())


def _is_binary(raw: Raw) -> bool:
    return _format(raw).binary


class _Text:
    """A text mesh."""

    def __init__(self, raw: Raw):
        self.raw = raw
        self.groups = PhysicalGroups()
        self._text = raw.texts[0]
        self._version = _format(raw).version

    def read(self) -> None:
        if self._version >= 4.0:
            self.groups.read_entities(section_of(self.raw, "Entities"), self._version)
        for name in ("Nodes", "Elements"):
            for begin, end in self._sections(name):
                if name == "Elements" and self._version < 4.0:
                    self._old_elements(begin, end)
                    continue
                self._words = words(self._text, begin, end)
                self._at = 0
                if name == "Nodes":
                    self._nodes()
                else:
                    self._elements()
                del self._words  # the next section has its own words
        for mark in self._text.matches(rb"^\$(NodeData|ElementData|ElementNodeData|Periodic)\b"):
            line = self._text.line_of(mark.start())
            card = f"${mark.group(1).decode()}"
            self.raw.stale.append(Place(card, 0, 0, line, "values of the undeformed shape"))

    def _sections(self, name: str) -> list[tuple[int, int]]:
        text, found = self._text, []
        ends = text.matches(rb"^\$End" + name.encode() + rb"\b")
        for mark in text.matches(rb"^\$" + name.encode() + rb"\s*$"):
            end = next((stop.start() for stop in ends if stop.start() > mark.end()), None)
            if end is None:
                line = text.line_of(mark.start())
                raise self.raw.error((0, line), f"${name} is not closed", "export it again")
            found.append((mark.end(), end))
        return found

    def _cut(self) -> Exception:
        begins = self._words[0]
        at = int(begins[min(self._at, len(begins) - 1)]) if len(begins) else 0
        return self.raw.error((0, self._text.line_of(at)), "numbers are missing", "export it again")

    def _integers(self, count: int) -> Ints:
        """Return the next integers."""
        begins, ends = self._words
        if count < 0 or self._at + count > len(begins):
            raise self._cut()
        found = np.empty(count, dtype=np.int64)
        for at in range(0, count, CHUNK):
            here = slice(self._at + at, min(self._at + at + CHUNK, self._at + count))
            values, sound = integers(self._text, begins[here], ends[here])
            if not sound.all():
                bad = int(begins[here][np.flatnonzero(~sound)[0]])
                shown = self._text.data[bad : bad + 20].split()[0].decode("latin-1")
                what = f'"{shown}" is not a whole number'
                raise self.raw.error((0, self._text.line_of(bad)), what, "export it again")
            found[at : at + CHUNK] = values
        self._at += count
        return found

    def _reals(self, count: int, each: int) -> tuple[Floats, Ints, Ints]:
        """Return values, begins, widths (count, 3) of the next points with `each` numbers."""
        begins, ends = self._words
        if count < 0 or self._at + count * each > len(begins):
            raise self._cut()
        here = slice(self._at, self._at + count * each)
        self._at += count * each
        one, two = (some[here].reshape(count, each)[:, :3] for some in (begins, ends))
        return self._points(one, two)

    def _points(self, one: Ints, two: Ints) -> tuple[Floats, Ints, Ints]:
        """Return values, begins, widths (n, 3) of numbers between offsets (n, 3)."""
        values, widths = np.empty(one.shape), np.empty(one.shape, dtype=np.uint8)
        for part in chunks(len(one)):
            for axis in range(3):
                values[part, axis] = reals(self._text, one[part, axis], two[part, axis])
            widths[part] = np.minimum(two[part] - one[part], 255)
        return values, one.astype(self._text.begins.dtype), widths

    def _add(self, ids: Ints, found: tuple[Floats, Ints, Ints]) -> None:
        values, begins, widths = found
        if len(ids):
            lines = np.empty(len(ids), dtype=np.int32)
            for part in chunks(len(ids)):
                at = np.searchsorted(self._text.begins, begins[part, 0], side="right")
                lines[part] = at - 1
            block = Block(0, lines, small(ids), values, begins, widths, _ROOM, WORD)
            self.raw.blocks.append(block)

    def _nodes(self) -> None:
        if self._version < 4.0:
            self._interleaved(int(self._integers(1)[0]), 0)
            return
        if self._version == 4.0:
            blocks = int(self._integers(2)[0])
        else:
            blocks = int(self._integers(4)[0])
        for _ in range(self._sound(blocks)):
            one, two, parametric, count = self._integers(4).tolist()
            dim = two if self._version == 4.0 else one
            more = dim if parametric and 0 < dim <= 3 else 0
            if self._version == 4.0:
                self._interleaved(count, more)
            else:
                ids = self._integers(self._sound(count))
                self._add(ids, self._reals(count, 3 + more))

    def _sound(self, count: int) -> int:
        if not 0 <= count <= min(_MOST, len(self._words[0])):
            raise self._cut()
        return count

    def _interleaved(self, count: int, more: int) -> None:
        """Read lines with an id and a point."""
        begins, ends = self._words
        each = 4 + more
        if not 0 <= count * each <= len(begins) - self._at:
            raise self._cut()
        here, whole = slice(self._at, self._at + count * each), self._words
        one, two = (some[here].reshape(count, each) for some in whole)
        self._words, self._at = (one[:, 0], two[:, 0]), 0
        ids = self._integers(count)
        self._add(ids, self._points(one[:, 1:4], two[:, 1:4]))
        self._words, self._at = whole, here.stop

    def _elements(self) -> None:
        blocks = int(self._integers(2 if self._version == 4.0 else 4)[0])
        for _ in range(self._sound(blocks)):
            one, two, kind, count = self._integers(4).tolist()
            tag = one if self._version == 4.0 else two
            if kind not in _TYPES:
                raise self._unknown(kind)
            width = _TYPES[kind][1] + 1
            begin = int(self._words[0][min(self._at, len(self._words[0]) - 1)])
            table = self._integers(self._sound(count) * width).reshape(count, width)
            first = self._text.line_of(begin)
            self._put(kind, table, np.full(count, tag), first + np.arange(count))

    def _unknown(self, kind: int) -> Exception:
        at = int(self._words[0][min(self._at, len(self._words[0]) - 1)])
        what = f"elements of type {kind} are not read"
        return self.raw.error((0, self._text.line_of(at)), what, "export elements up to order 2")

    def _put(self, kind: int, table: Ints, tags: Ints, lines: Ints) -> None:
        """Add elements from rows with an id and nodes."""
        name, count = _TYPES[kind]
        if len(table):
            nodes = small(table[:, 1 : count + 1])
            np.maximum(nodes, 0, out=nodes)
            self.raw.elements.append(
                Elements(
                    f"type {kind}", name, small(table[:, 0]), small(tags),
                    nodes, 0, lines.astype(np.int32, copy=False),
                )
            )  # fmt: skip

    def _old_elements(self, begin: int, end: int) -> None:
        """Read lines with an id, a type, tags and nodes."""
        text = self._text
        first, last = text.line_of(begin) + 1, text.line_of(end)
        self._words = words(text, begin, int(text.ends[min(first, len(text) - 1)]))
        self._at = 0
        count = int(self._integers(1)[0])
        found: dict[int, list[tuple[Ints, Ints, Ints]]] = {}
        total = 0
        for part in chunks(last - first - 1):
            rows = slice(first + 1 + part.start, first + 1 + part.stop)
            ends = text.ends[rows]
            self._words = words(text, int(text.begins[rows][0]), int(ends[-1]))
            self._at = 0
            total += self._some_elements(found)
        if total != count:
            raise self._cut()
        for kind in list(found):
            table, tags, lines = (np.concatenate(some) for some in zip(*found.pop(kind)))
            self._put(kind, table, tags, lines)

    def _some_elements(self, found: dict[int, list[tuple[Ints, Ints, Ints]]]) -> int:
        """Sort the elements of some lines by type, and return their number."""
        begins = self._words[0]
        if not len(begins):
            return 0
        numbers = self._integers(len(begins))
        lines = np.searchsorted(self._text.begins, begins, side="right") - 1
        heads = np.flatnonzero(np.diff(lines, prepend=-1) != 0)
        sizes = np.diff(np.append(heads, len(begins)))
        self._at = 0
        if (sizes < 4).any():
            raise self._cut()
        types, tags = numbers[heads + 1], numbers[heads + 2]
        for kind in np.unique(types).tolist():
            if kind not in _TYPES:
                raise self._unknown(kind)
            rows = np.flatnonzero(types == kind)
            if (tags[rows] < 0).any() or (sizes[rows] != 3 + tags[rows] + _TYPES[kind][1]).any():
                raise self._cut()
            nodes = (heads[rows] + 3 + tags[rows])[:, None] + np.arange(_TYPES[kind][1])
            table = np.concatenate([numbers[heads[rows]][:, None], numbers[nodes]], axis=1)
            # The second tag is the geometric entity, as in version 4.
            first = numbers[np.minimum(heads[rows] + 4, len(numbers) - 1)]
            tag = np.where(tags[rows] > 1, first, 0)
            self.groups.add(_TYPES[kind][0], tag, numbers[heads[rows] + 3])
            piece = small(table), small(tag), lines[heads[rows]].astype(np.int32)
            found.setdefault(kind, []).append(piece)
        return len(heads)


class _Binary(_Text):
    """A binary mesh of version 2 or 4.1 from a little-endian machine."""

    def read(self) -> None:
        self._cursor = _format(self.raw).end
        for name, work in (("Nodes", self._nodes), ("Elements", self._elements)):
            mark = self._text.data.find(f"${name}\n".encode(), self._cursor)
            if mark < 0:
                continue
            self._cursor = mark + len(name) + 2
            try:
                work()
            except FileError:
                raise
            except (struct.error, ValueError):
                what = f"${name} is cut short"
                raise self.raw.error((0, 0), what, "export it again") from None

    def _take(self, layout: str) -> tuple[int, ...]:
        found = struct.unpack_from("<" + layout, self._text.data, self._cursor)
        self._cursor += struct.calcsize("<" + layout)
        return found

    def _array(self, kind: np.dtype[Any], count: int) -> Array:
        size = count * kind.itemsize
        if count < 0 or self._cursor + size > len(self._text.data):
            raise struct.error("cut")
        found = np.frombuffer(self._text.data, kind, count, self._cursor)
        self._cursor += size
        return found

    def _line_number(self) -> int:
        line = self._text.data.index(b"\n", self._cursor)
        number = int(self._text.data[self._cursor : line])
        self._cursor = line + 1
        return number

    def _put_points(self, ids: Ints, values: Floats, begins: Ints) -> None:
        places = begins[:, None] + 8 * np.arange(3)
        widths = np.full((len(ids), 3), 8, np.uint8)
        lines = np.zeros(len(ids), np.int32)
        values = np.where(np.abs(values) <= LARGEST, values, np.nan)
        self.raw.blocks.append(
            Block(0, lines, ids.astype(np.int64), values, places, widths, 24, BINARY)
        )

    def _nodes(self) -> None:
        if self._version < 4.0:
            count = self._line_number()
            start = self._cursor
            rows = self._array(np.dtype([("id", "<i4"), ("at", "<f8", 3)]), count)
            self._put_points(rows["id"], rows["at"], start + 28 * np.arange(count) + 4)
            return
        blocks = self._take("4Q")[0]
        for _ in range(blocks):
            dim, _tag, parametric = self._take("3i")
            (count,) = self._take("Q")
            ids = self._array(np.dtype("<u8"), count)
            each = 3 + (dim if parametric and 0 < dim <= 3 else 0)
            start = self._cursor
            values = self._array(np.dtype("<f8"), count * each).reshape(count, each)
            self._put_points(ids, values[:, :3], start + 8 * each * np.arange(count))

    def _elements(self) -> None:
        if self._version < 4.0:
            count, done = self._line_number(), 0
            while done < count:
                kind, some, tags = self._take("3i")
                if kind not in _TYPES or some <= 0 or tags < 0:
                    raise struct.error("cut")
                width = 1 + tags + _TYPES[kind][1]
                table = self._array(np.dtype("<i4"), some * width).reshape(some, width)
                tag = table[:, 2] if tags > 1 else np.zeros(some, np.int64)
                if tags > 1:
                    self.groups.add(_TYPES[kind][0], tag, table[:, 1])
                rows = np.delete(table, np.arange(1, 1 + tags), axis=1)
                self._put(kind, rows.astype(np.int64), tag, np.zeros(some, np.int32))
                done += some
            return
        for _ in range(self._take("4Q")[0]):
            _dim, entity, kind = self._take("3i")
            (count,) = self._take("Q")
            if kind not in _TYPES:
                raise struct.error("cut")
            width = 1 + _TYPES[kind][1]
            table = self._array(np.dtype("<u8"), count * width).reshape(count, width)
            self._put(
                kind, table.astype(np.int64), np.full(count, entity), np.zeros(count, np.int32)
            )
