# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radioss starter files: nodes, elements, and rigid bodies of node groups."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from ...base.arrays import Bools, Ints
from ...base.words import counted
from ..cut import Cut, small
from ..deck import Deck
from ..includes import Included
from ..model import Elements, Opener, Place, Raw
from ..numbers import parse_integer, parse_real
from ..placing import note_placing
from .groups import Groups
from .submodels import Shift, Submodels, shifted
from .table import ALIASES, BLOCKS, ELEMENTS, Field, field, texts

SUFFIXES = (".rad",)
_STALE = {
    "INIBRI": "an initial state of the undeformed shape",
    "INISHE": "an initial state of the undeformed shape",
    "INISH3": "an initial state of the undeformed shape",
    "REFSTA": "a reference state of the undeformed shape",
    "XREF": "a reference geometry of the undeformed shape",
    "EREF": "a reference geometry of the undeformed shape",
    "SKEW/FIX": "a system by coordinates stays where it is",
    "FRAME/FIX": "a system by coordinates stays where it is",
    "BOX": "a box by coordinates stays where it is",
    "RWALL": "a rigid wall stays where it is",
    "SECT": "a section by coordinates stays where it is",
}
_OLDEST = 51


def read_radioss(path: Path, opener: Opener) -> Deck:
    """Read a starter deck with its includes. Raises FileError."""
    reader = _Reader(Raw("Radioss"), path, opener)
    return reader.read()


class _Reader:
    """The state of the reader."""

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self.raw = raw
        self._path = path
        self._included = Included(raw, path, opener)
        self._groups = Groups(raw)
        self._part_property: dict[int, int] = {}
        self._thickness: dict[int, float] = {}
        self._parameters: dict[str, float] = {}
        self._shift = Shift()
        self._is_whole = False

    def read(self) -> Deck:
        self._file(self._included.first(self._path))
        if not self._is_whole:
            self.raw.miss(0, "there is no /END: the end of the file may be missing")
        self._groups.finish()
        for part, number in self._part_property.items():
            if self._thickness.get(number):
                self.raw.thickness[part] = self._thickness[number]
        return Deck(self.raw)

    def _file(self, file: int) -> None:
        """Read all blocks; an include is read at its position, even inside a block."""
        text = self.raw.texts[file]
        self._included.enter(file)
        first = np.zeros(len(text), np.uint8)
        filled = text.ends > text.begins
        first[filled] = text.codes[text.begins[filled]]
        outer = self._shift
        submodels = Submodels(self.raw, file, outer)
        is_include = self._includes(file, submodels)
        heads = np.flatnonzero(first == ord("/"))
        # Lines with // are comments, except those around a submodel.
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
        """Reject an include that continues a block of the including file."""
        text = self.raw.texts[file]
        for line in np.flatnonzero((first[:end] != ord("#")) & (first[:end] != 0)).tolist():
            if text.line(line).strip() and not text.line(line).startswith("//"):
                what = "this include continues a block that begins outside it"
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
        """Read one block, and return whether it ends the file."""
        line, rows = at
        name = words[0]
        # The number of a block may be followed by that of its units.
        number = next((n for n in map(parse_integer, words[1:]) if n is not None), 0)
        if name == "END":
            self._is_whole = self._is_whole or file == 0
            return True
        if name == "BEGIN":
            self._version(file, rows)
        elif name == "NODE":
            self._nodes(file, at)
        elif name in ELEMENTS and len(words) > 1:
            self._elements(file, name, (number, rows))
        elif note_placing(self.raw, "/".join(words), (file, line)):
            pass
        elif name == "RBODY":
            self._body(file, words, (line, rows))
        elif name == "GRNOD" and len(words) > 2:
            members = self._numbers(file, rows[field("GRNOD", "members").line :])
            self._groups.add(words[1], number, members, self._shift)
        elif name == "PART":
            self._part(file, number + self._shift.part, rows)
        elif name == "PROP" and len(words) > 2:
            block = f"PROP/{ALIASES.get(words[1], words[1])}"
            if block in BLOCKS:
                shown = self._field(file, rows, field(block, "thickness"))
                self._thickness[number + self._shift.property] = parse_real(shown) or 0.0
        for key, reason in _STALE.items():
            if "/".join(words).startswith(key):
                self.raw.stale.append(Place(f"/{'/'.join(words)}", number, file, line, reason))
        return False

    def _version(self, file: int, rows: Ints) -> None:
        place = field("BEGIN", "version")
        version = parse_integer(self._field(file, rows, place))
        if version is not None and version < _OLDEST:
            what = f"version {version} of the format writes nodes in other columns"
            line = int(rows[place.line])
            raise self.raw.error((file, line), what, "write the deck in version 51 or later")

    def _part(self, file: int, number: int, rows: Ints) -> None:
        shown = self._field(file, rows, field("PART", "property"))
        self._part_property[number] = (parse_integer(shown) or 0) + self._shift.property
        self.raw.names[number] = (
            self.raw.texts[file].line(int(rows[0])).strip() if len(rows) else ""
        )
        thickness = parse_real(self._field(file, rows, field("PART", "thickness")))
        if thickness:
            self.raw.thickness[number] = thickness

    def _field(self, file: int, rows: Ints, place: Field) -> str:
        """Return the text of a field of a block, "" if the block ends before its line."""
        if place.line >= len(rows):
            return ""
        return texts(self.raw.texts[file].line(int(rows[place.line])), place)[0]

    def _numbers(self, file: int, rows: Ints) -> list[int]:
        """Return all integers in the lines of a group."""
        text, place = self.raw.texts[file], field("GRNOD", "members")
        found = (
            parse_integer(shown) for row in rows.tolist() for shown in texts(text.line(row), place)
        )
        return [number for number in found if number is not None]

    def _nodes(self, file: int, at: tuple[int, Ints]) -> None:
        line, rows = at
        if not len(rows):
            return
        self._require_no_parameters(file, rows, "/NODE")
        text = self.raw.texts[file]
        cut = Cut(self.raw, file, rows, text.ends, "/NODE")
        block = cut.nodes(field("NODE", "id").width, field("NODE", "point").width)
        self.raw.blocks.append(replace(block, ids=shifted(block.ids, self._shift.node)))

    def _require_no_parameters(self, file: int, rows: Ints, card: str) -> None:
        text = self.raw.texts[file]
        odd = text.first_per_line(ord("&"))[rows] < text.ends[rows]
        if odd.any():
            what = f"{card}: parameters (&) replace numbers"
            line = int(rows[np.flatnonzero(odd)[0]])
            raise self.raw.error((file, line), what, "write the numbers")

    def _elements(self, file: int, name: str, given: tuple[int, Ints]) -> None:
        part, rows = given
        if not len(rows):
            return
        text, layout = self.raw.texts[file], BLOCKS[name]
        card = f"/{name}/{part}"
        places = [*layout["id"], *layout.get("nodes", ()), *layout.get("group", ())]
        each = 1 + max(place.line for place in places)
        if len(rows) % each:
            what = f"{card}: an element needs {each} lines, but the last one has "
            what += counted(len(rows) % each, "line", "lines")
            raise self.raw.error((file, int(rows[-1])), what, "complete the element")

        def numbers(place: Field) -> Ints:
            cut = Cut(self.raw, file, rows[place.line :: each], text.ends, card)
            return cut.table(place.begin, place.width, place.count)

        heads, of_id = rows[::each], layout["id"][0]
        cut = Cut(self.raw, file, heads, text.ends, card)
        ids = shifted(small(cut.integers(of_id.begin, of_id.width)), self._shift.element)
        if "group" in layout:
            groups = numbers(layout["group"][0])[:, 0].tolist()
            for number, group, line in zip(ids.tolist(), groups, heads.tolist()):
                self._groups.add_line(number, (part, group), self._shift, (file, line))
            return
        nodes = np.concatenate([numbers(place) for place in layout["nodes"]], axis=1)
        parts = np.full(len(ids), part + self._shift.part, ids.dtype)
        nodes = shifted(np.maximum(nodes, 0), self._shift.node)
        self.raw.elements.append(
            Elements(f"/{name}", ELEMENTS[name], ids, parts, nodes, file, heads.astype(np.int32))
        )

    def _body(self, file: int, words: list[str], at: tuple[int, Ints]) -> None:
        line, rows = at
        if len(words) > 1 and parse_integer(words[1]) is None:
            what = f"/{'/'.join(words)} is not read: its nodes are not checked as a rigid body"
            self.raw.notes.append(f"{self.raw.texts[file].name}, line {line + 1}: {what}")
            return
        number = parse_integer(words[1]) or 0 if len(words) > 1 else 0
        main, group = (
            parse_integer(self._field(file, rows, field("RBODY", name))) or 0
            for name in ("main", "group")
        )
        self._groups.add_body((number, main, group), self._shift, (file, line))


def _is_head(shown: str) -> bool:
    return not shown.startswith("//") or shown[2:].upper().startswith(("SUBMODEL", "ENDSUB"))
