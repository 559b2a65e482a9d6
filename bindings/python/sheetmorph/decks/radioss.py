# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radioss starter files: /NODE and the elements, in columns of 10 and 20."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from ..arrays import Bools, Ints
from .cut import Cut, small
from .deck import Deck
from .includes import Included
from .model import Elements, NamedSet, Opener, Place, Raw
from .numbers import parse_integer, parse_real
from .placing import note_placing
from .radioss_submodels import Shift, Submodels, shifted

SUFFIXES = (".rad",)
# Elements: what they are, in which column of 10 their first node stands, how many there are.
_ELEMENTS = {
    "SHELL": ("shell", 4), "SH3N": ("shell", 3), "QUAD": ("solid", 4), "TRIA": ("solid", 3),
    "BRICK": ("solid", 8), "TETRA4": ("solid", 4), "PENTA6": ("solid", 6), "SPRING": ("line", 3),
    "BEAM": ("line", 3), "TRUSS": ("line", 2), "XELEM": ("line", 2), "SHEL16": ("solid", 16),
    "TETRA10": ("solid", 10), "BRIC20": ("solid", 20),
}  # fmt: skip
_ON_MORE_LINES = {"TETRA10": (1, 10), "BRIC20": (3, 8), "SHEL16": (2, 8)}
_STALE = {
    "INIBRI": "an initial state of the shape before",
    "INISHE": "an initial state of the shape before",
    "INISH3": "an initial state of the shape before",
    "REFSTA": "a reference state of the shape before",
    "XREF": "a reference geometry of the shape before",
    "EREF": "a reference geometry of the shape before",
    "SKEW/FIX": "a system by coordinates stays where it is",
    "FRAME/FIX": "a system by coordinates stays where it is",
    "BOX": "a box by coordinates stays where it is",
    "RWALL": "a rigid wall stays where it is",
    "SECT": "a section by coordinates stays where it is",
}
_OLDEST = 51


def read_radioss(path: Path, opener: Opener) -> Deck:
    """A starter deck with its includes. Raises FileError."""
    reader = _Reader(Raw("Radioss"), path, opener)
    return reader.read()


class _Reader:
    """The state while a deck is read."""

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self.raw = raw
        self._path = path
        self._included = Included(raw, path, opener)
        self._groups: dict[int, list[int]] = {}
        self._bodies: list[tuple[int, int, int, int, int]] = []
        self._part_property: dict[int, int] = {}
        self._thickness: dict[int, float] = {}
        self._parameters: dict[str, float] = {}
        self._shift = Shift()

    def read(self) -> Deck:
        self._file(self._included.first(self._path))
        for number, lead, group, file, line in self._bodies:
            nodes = [lead, *self._groups.get(group, [])]
            self.raw.elements.append(
                Elements(
                    "/RBODY", "rigid", np.array([number]), np.zeros(1, np.int64),
                    np.array([nodes]), file, np.array([line], np.int32),
                )
            )  # fmt: skip
        for number, nodes in self._groups.items():
            self.raw.sets.append(NamedSet(f"GRNOD {number}", "nodes", nodes))
        for part, number in self._part_property.items():
            if self._thickness.get(number):
                self.raw.thickness[part] = self._thickness[number]
        return Deck(self.raw)

    def _file(self, file: int) -> None:
        """Take all blocks; an include goes on where it stands, inside of a block too."""
        text = self.raw.texts[file]
        self._included.enter(file)
        first = np.zeros(len(text), np.uint8)
        filled = text.ends > text.begins
        first[filled] = text.codes[text.begins[filled]]
        outer = self._shift
        submodels = Submodels(self.raw, file, outer)
        is_include = self._includes(file, submodels)
        heads = np.flatnonzero(first == ord("/"))
        # Lines with // are comments, but for those around a submodel.
        heads = heads[[_is_head(text.line(k)) for k in heads.tolist()]]
        if file:
            self._require_whole(file, first, int(heads[0]) if len(heads) else len(text))
        is_card = (first != ord("#")) & (first != ord("/")) & (first != 0) & ~is_include
        for line, end in zip(heads.tolist(), [*heads[1:].tolist(), len(text)]):
            words = text.line(line).strip().lstrip("/").split("/")
            rows = np.flatnonzero(is_card[line + 1 : end]) + line + 1
            self._shift = submodels.at(line)
            if self._block(file, [word.strip().upper() for word in words], (line, rows)):
                break
        self._shift = outer
        self._included.leave()

    def _require_whole(self, file: int, first: Ints, end: int) -> None:
        """An include that goes on with a block begun outside of it is not read."""
        text = self.raw.texts[file]
        for line in np.flatnonzero((first[:end] != ord("#")) & (first[:end] != 0)).tolist():
            if text.line(line).strip() and not text.line(line).startswith("//"):
                what = "this include goes on with a block that begins outside of it"
                raise self.raw.error((file, line), what, "put whole blocks into the include")

    def _includes(self, file: int, submodels: Submodels) -> Bools:
        text = self.raw.texts[file]
        found = np.zeros(len(text), dtype=bool)
        for mark in text.matches(rb"^#include[ \t]+([^\r\n]+)"):
            line = text.line_of(mark.start())
            found[line] = True
            name = mark.group(1).decode("latin-1").strip()
            self._shift = submodels.at(line)
            self._file(self._included.add(name, (file, line)))
        return found

    def _block(self, file: int, words: list[str], at: tuple[int, Ints]) -> bool:
        """Take one block; whether the file ends with it."""
        line, rows = at
        name = words[0]
        number = (parse_integer(words[-1]) or 0) if len(words) > 1 else 0
        if name == "END":
            return True
        if name == "BEGIN" and len(rows) > 1:
            self._version(file, int(rows[1]))
        elif name == "NODE":
            self._nodes(file, at)
        elif name in _ELEMENTS and len(words) > 1:
            self._elements(file, name, (number, rows))
        elif note_placing(self.raw, "/".join(words), (file, line)):
            pass
        elif name == "RBODY" and len(rows) > 1:
            self._body(file, words, (line, rows))
        elif name == "GRNOD" and words[1:2] == ["NODE"]:
            nodes = np.array(self._numbers(file, rows[1:]), dtype=np.int64)
            self._groups[number + self._shift.other] = shifted(nodes, self._shift.node).tolist()
        elif name == "PART" and len(rows) > 1:
            number += self._shift.part
            self._part_property[number] = self._numbers(file, rows[1:2])[0] + self._shift.property
            self.raw.names[number] = self.raw.texts[file].line(int(rows[0])).strip()
        elif name == "PROP" and words[1:2] in (["SHELL"], ["TYPE1"]) and len(rows) > 3:
            fields = self._fields(file, int(rows[3]), (10, 10, 20))
            self._thickness[number + self._shift.property] = parse_real(fields[2]) or 0.0
        for key, reason in _STALE.items():
            if "/".join(words).startswith(key):
                self.raw.stale.append(Place(f"/{'/'.join(words)}", number, file, line, reason))
        return False

    def _version(self, file: int, line: int) -> None:
        version = parse_integer(self._fields(file, line, (10,))[0]) or 0
        if version < _OLDEST:
            what = f"version {version} of the format writes nodes in other columns"
            raise self.raw.error((file, line), what, "write the deck in version 51 or later")

    def _fields(self, file: int, line: int, widths: tuple[int, ...]) -> list[str]:
        shown, at, found = self.raw.texts[file].line(line), 0, []
        for width in widths:
            found.append(shown[at : at + width])
            at += width
        return found

    def _numbers(self, file: int, rows: Ints) -> list[int]:
        found = []
        for line in rows.tolist():
            for text in self._fields(file, line, (10,) * 10):
                number = parse_integer(text)
                found += [number] if number is not None else []
        return found or [0]

    def _nodes(self, file: int, at: tuple[int, Ints]) -> None:
        line, rows = at
        if not len(rows):
            return
        self._require_no_parameters(file, rows, "/NODE")
        text = self.raw.texts[file]
        cut = Cut(self.raw, file, rows, text.ends, "/NODE")
        block = cut.nodes(10, 20)
        self.raw.blocks.append(replace(block, ids=shifted(block.ids, self._shift.node)))

    def _require_no_parameters(self, file: int, rows: Ints, card: str) -> None:
        text = self.raw.texts[file]
        odd = text.first_per_line(ord("&"))[rows] < text.ends[rows]
        if odd.any():
            what = f"{card}: parameters (&) stand for numbers"
            line = int(rows[np.flatnonzero(odd)[0]])
            raise self.raw.error((file, line), what, "write the numbers")

    def _elements(self, file: int, name: str, given: tuple[int, Ints]) -> None:
        part, rows = given
        if not len(rows):
            return
        kind, count = _ELEMENTS[name]
        text = self.raw.texts[file]
        card = f"/{name}/{part}"
        if name in _ON_MORE_LINES:
            more, each = _ON_MORE_LINES[name]
            if len(rows) % (more + 1):
                what = f"{card}: the cards are no whole number of elements"
                raise self.raw.error((file, int(rows[0])), what)
            heads = rows[:: more + 1]
            tables = [
                Cut(self.raw, file, rows[1 + k :: more + 1], text.ends, card).table(0, 10, each)
                for k in range(more)
            ]
            nodes = np.concatenate(tables, axis=1)[:, :count]
        else:
            heads = rows
            nodes = Cut(self.raw, file, rows, text.ends, card).table(10, 10, count)
        ids = small(Cut(self.raw, file, heads, text.ends, card).integers(0, 10))
        ids = shifted(ids, self._shift.element)
        parts = np.full(len(ids), part + self._shift.part, ids.dtype)
        nodes = shifted(np.maximum(nodes, 0), self._shift.node)
        self.raw.elements.append(
            Elements(f"/{name}", kind, ids, parts, nodes, file, heads.astype(np.int32))
        )

    def _body(self, file: int, words: list[str], at: tuple[int, Ints]) -> None:
        line, rows = at
        fields = self._fields(file, int(rows[1]), (10,) * 5)
        number = parse_integer(words[1]) or 0 if len(words) > 1 else 0
        lead, group = parse_integer(fields[0]) or 0, parse_integer(fields[4]) or 0
        shift = self._shift
        lead += shift.node if lead else 0
        self._bodies.append((number + shift.other, lead, group + shift.other, file, line))


def _is_head(shown: str) -> bool:
    return not shown.startswith("//") or shown[2:].upper().startswith(("SUBMODEL", "ENDSUB"))
