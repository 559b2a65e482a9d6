# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data: GRID cards and attached elements, in every layout."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...base.arrays import Bools, Ints
from ...base.blocks import chunks
from ..cut import side_by_side, small
from ..deck import Deck
from ..frames import Frame
from ..includes import Included
from ..model import FIXED, Block, Elements, Opener, Raw
from ..numbers import parse_integer, parse_integers, parse_real, parse_reals
from ..placing import NASTRAN as PLACING
from ..placing import note_placing
from ..text import DeckText
from .cards import Card, Lines, cards, sorted_lines
from .elements import add_weld_points, elements_of
from .points import Points
from .sets import card_sets, comment_names, control_sets
from .stale import STALE, stale_of
from .table import CARDS, ELEMENTS, GRID, place_of

SUFFIXES = (".nas", ".bdf", ".dat", ".fem", ".blk", ".bulk", ".pch")
# Shells on one line, with their number of nodes.
PLAIN_SHELLS = {name: len(ELEMENTS[name][1]) for name in ("CTRIA3", "CTRIAR", "CQUAD4", "CQUADR")}
_LAST = 72  # column, from 0, of the field that names the continuation
_FRAMES = frozenset(f"CORD{k}{kind}" for k in "12" for kind in "RCS")
_KNOWN = frozenset({"GRID", "GRDSET", "MAT1", "PSHELL", "SET1", "SET3", *PLAIN_SHELLS, *_FRAMES})
_OTHER = frozenset({*_KNOWN, *ELEMENTS, *STALE, *PLACING})


def read_nastran(path: Path, opener: Opener) -> Deck:
    """Read a bulk data deck with its includes. Raises FileError."""
    reader = _Reader(Raw("Nastran", mark=""), path, opener)
    reader.read()
    return reader.deck()


class _Reader:
    """The state of the reader: the position of BEGIN BULK, and the data read so far."""

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self.raw = raw
        self._path = path
        self._included = Included(raw, path, opener)
        self._in_bulk = False
        self._ended = False
        self._default_system = 0
        self._frames: dict[int, Frame] = {}
        self._generated: list[tuple[int, int]] = []

    def read(self) -> None:
        """Read all files."""
        first = self._included.first(self._path)
        begins = self.raw.texts[first].matches(rb"^[ \t]*BEGIN\b")
        self._in_bulk = not begins
        self._file(first)
        if not self._ended:
            what = "there is no ENDDATA: unless another deck includes this file, its end is missing"
            self.raw.miss(0, what)
        for file, text in enumerate(self.raw.texts):
            self._check_last_card(file, text)

    def _check_last_card(self, file: int, text: DeckText) -> None:
        """Record a last line whose tenth field names a missing continuation."""
        for line in range(len(text) - 1, max(len(text) - 20, -1), -1):
            body = text.line(line).split("$", 1)[0].rstrip()
            if not body:
                continue
            last = (
                body.split(",")[-1] if "," in body[:10] else body.expandtabs(8)[_LAST : _LAST + 8]
            )
            if last.strip()[:1] in ("+", "*") and (last.strip() or "," in body[:10]):
                self.raw.miss(file, "the last card has a continuation line that is missing", line)
            return

    def deck(self) -> Deck:
        """Return the deck after all files are read."""
        for k, block in enumerate(self.raw.blocks):
            self.raw.blocks[k] = _with_systems(block, self._default_system)
        if self._generated:
            count = len(self._generated)
            self.raw.notes.append(
                f"{count} lines replicate cards (=): the nodes of those stay unchanged"
            )
        return Deck(self.raw, self._frames)

    def _file(self, file: int) -> None:
        text = self.raw.texts[file]
        self.raw.names |= comment_names(text)
        self._included.enter(file)
        at = 0
        for mark in text.matches(rb"^[ \t]*(BEGIN\b|ENDDATA\b|INCLUDE\b)[^\r\n]*"):
            if self._ended:
                break
            line = text.line_of(mark.start(1))
            if line < at:
                continue  # inside a file name that spans several lines
            if self._in_bulk:
                self._cards(file, at, line)
            at = self._marked(file, line, mark.group(1).upper())
        if self._in_bulk and not self._ended:
            self._cards(file, at, len(text))
        self._included.leave()

    def _marked(self, file: int, line: int, word: bytes) -> int:
        """Read a line that is not a card, and return the next line."""
        text = self.raw.texts[file]
        shown = text.line(line).split("$", 1)[0].upper()
        if word == b"ENDDATA":
            self._ended = self._ended or self._in_bulk
        elif word == b"BEGIN":
            words = re.split(r"[\s=]+", shown.strip())[1:]
            if words and words[0] != "BULK" or len(words) > 1:
                what = f"{shown.strip()}: a deck of several models is not read"
                todo = "write each superelement or module into a deck of its own"
                raise self.raw.error((file, line), what, todo)
            if not self._in_bulk:
                self.raw.sets += control_sets(text, line)
            self._in_bulk = True
        else:
            return self._include(file, line)
        return line + 1

    def _include(self, file: int, line: int) -> int:
        text = self.raw.texts[file]
        name = re.sub(r"^\s*INCLUDE\s*=?\s*", "", text.line(line), flags=re.IGNORECASE)
        quote = name[:1] if name[:1] in "'\"" and name else ""
        end = line + 1
        if quote:
            name = name[1:].rstrip()
            while quote not in name and end < len(text) and end < line + 20:
                name += text.line(end).strip()
                end += 1
            if quote not in name:
                what = "INCLUDE: the quote around the name is not closed"
                raise self.raw.error((file, line), what, "close it")
            name = name.split(quote, 1)[0]
        else:
            name = name.split("$", 1)[0]
        self._file(self._included.add(name, (file, line)))
        return end

    def _cards(self, file: int, first: int, end: int) -> None:
        """Read all cards in a range of lines."""
        if end <= first:
            return
        text = self.raw.texts[file]
        lines = sorted_lines(text, first, end)
        taken = np.zeros(end - first, dtype=bool)
        self._plain_grids(file, lines, taken)
        self._large_grids(file, lines, taken)
        for name, count in PLAIN_SHELLS.items():
            rows = np.flatnonzero(lines.plain & (lines.heads == name.encode()))
            if len(rows):
                self.raw.elements.append(self._plain_shells(file, lines, rows, (name, count)))
                taken[rows] = True
        self._rest(file, lines, taken)

    def _plain_grids(self, file: int, lines: Lines, taken: Bools) -> None:
        """Read complete GRID cards in columns of 8."""
        text = self.raw.texts[file]
        rows = np.flatnonzero(lines.plain & (lines.heads == b"GRID"))
        rows = rows[lines.stops[rows + lines.first] - text.begins[rows + lines.first] >= 48]
        if not len(rows):
            return
        ids = self._integers(file, lines, rows, (GRID["id"], 8))
        systems = self._integers(file, lines, rows, (GRID["system"], 8), -1)
        columns = np.array([place_of(GRID["point"] + k, 8)[1] for k in range(3)])
        self._add(file, rows + lines.first, (ids, systems), (columns, 8))
        taken[rows] = True

    def _large_grids(self, file: int, lines: Lines, taken: Bools) -> None:
        """Read complete GRID* cards followed by their second line."""
        text = self.raw.texts[file]
        rows = np.flatnonzero(lines.plain & (lines.heads == b"GRID*"))
        rows = rows[rows + 1 < len(lines.heads)]
        at = rows + lines.first
        size = lines.stops - text.begins
        sound = (size[at] >= 72) & (size[at + 1] >= 24) & lines.plain[rows + 1]
        sound &= (lines.heads[rows + 1] == b"+") & (text.codes[text.begins[at + 1]] == ord("*"))
        rows, at = rows[sound], at[sound]
        if not len(rows):
            return
        ids = self._integers(file, lines, rows, (GRID["id"], 16))
        systems = self._integers(file, lines, rows, (GRID["system"], 16), -1)
        below = text.begins[at + 1].astype(np.int64) - text.begins[at]
        places = [place_of(GRID["point"] + k, 16) for k in range(3)]
        columns = np.stack([column + line * below for line, column in places], axis=1)
        self._add(file, at, (ids, systems), (columns, 16))
        taken[rows] = taken[rows + 1] = True

    def _add(
        self, file: int, at: Ints, numbers: tuple[Ints, Ints], layout: tuple[Ints, int]
    ) -> None:
        """Add nodes in lines `at`, with coordinates in columns (3,) or (n, 3) of some width."""
        text = self.raw.texts[file]
        columns, width = layout
        begins = (text.begins[at][:, None] + columns).astype(text.begins.dtype)
        values = np.empty((len(at), 3))
        for part in chunks(len(at)):
            for axis in range(3):
                begin = begins[part, axis]
                values[part, axis] = parse_reals(text.columns(begin, begin + width, width))
        widths = np.broadcast_to(np.uint8(width), (len(at), 3))
        ids, systems = numbers
        block = Block(file, at.astype(np.int32), ids, values, begins, widths, width, FIXED, systems)
        self.raw.blocks.append(block)

    def _integers(
        self, file: int, lines: Lines, rows: Ints, field: tuple[int, int], *blank: int
    ) -> Ints:
        """Return integers in (position, width); a blank field is an error or has a value."""
        text, (position, width) = self.raw.texts[file], field
        column = place_of(position, width)[1]
        found = np.empty(len(rows), dtype=np.int64)
        for part in chunks(len(rows)):
            at = rows[part] + lines.first
            codes = text.columns(text.begins[at] + column, lines.stops[at], width)
            found[part], sound = parse_integers(codes)
            empty = (codes == 32).all(axis=1)
            sound &= ~empty | bool(blank)
            if not sound.all():
                bad = int(np.flatnonzero(~sound)[0])
                shown = bytes(codes[bad]).decode("latin-1").strip()
                name = lines.heads[rows[part][bad]].decode("latin-1").rstrip("*")
                what = f'{name}: "{shown}" in field {position + 2} is not a whole number'
                raise self.raw.error((file, int(at[bad])), what)
            if blank:
                found[part][empty] = blank[0]
        return found

    def _plain_shells(self, file: int, lines: Lines, rows: Ints, kind: tuple[str, int]) -> Elements:
        name, count = kind
        ids = self._integers(file, lines, rows, (0, 8))
        properties = self._integers(file, lines, rows, (1, 8), 0)
        some = (self._integers(file, lines, rows, (k, 8)) for k in ELEMENTS[name][1])
        nodes = side_by_side(some, (len(rows), count))
        properties = np.where(properties == 0, ids, properties)
        numbers = small(ids), small(properties), nodes
        return Elements(name, "shell", *numbers, file, (rows + lines.first).astype(np.int32))

    def _rest(self, file: int, lines: Lines, taken: Bools) -> None:
        """Read all other cards one by one."""
        heads = np.char.rstrip(lines.heads, b"*")
        self._generated += [
            (file, int(k) + lines.first) for k in np.flatnonzero(np.char.startswith(heads, b"="))
        ]
        wanted = np.isin(heads, np.array([name.encode()[:8] for name in _OTHER])) & ~taken
        found: dict[str, list[Card]] = {}
        for card in cards(self.raw.texts[file], lines, np.flatnonzero(wanted) + lines.first):
            found.setdefault(card.name, []).append(card)
        for name, some in found.items():
            self._take(file, name, some)

    def _take(self, file: int, name: str, found: list[Card]) -> None:
        points = Points(self.raw, file)
        if name == "GRID":
            for card in found:
                self._odd_grid(file, card, points)
        elif name == "GRDSET":
            self._default_system = self._whole(file, found[0], CARDS[name]["system"][0]) or 0
        elif name in _FRAMES:
            for card in found:
                self._frame(file, card)
        elif name in ("SET1", "SET3"):
            self.raw.sets += card_sets(found)
        elif name == "PSHELL":
            for card in found:
                number, material, thickness = (k for (k,) in CARDS[name].values())
                self.raw.thickness[card.number(number)] = card.real(thickness)
                self.raw.materials.of_property[card.number(number)] = card.text(material)
        elif name == "MAT1":
            for card in found:
                self._material(card)
        if name in PLAIN_SHELLS or name in ELEMENTS:
            self.raw.elements += elements_of(self.raw, file, name, found)
        if name in ("CWELD", "CFAST", "CSEAM"):
            for card in found:
                add_weld_points(points, card)
        self.raw.blocks += points.blocks()
        for card in found if name in PLACING else ():
            note_placing(self.raw, name, (file, card.line))
        self.raw.stale += stale_of(file, name, found)

    def _material(self, card: Card) -> None:
        number, of_young, of_shear, of_poisson, of_density = (k for (k,) in CARDS["MAT1"].values())
        found, key = self.raw.materials, card.text(number)
        young, shear = card.real(of_young), card.real(of_shear)
        found.young[key], found.density[key] = young, card.real(of_density)
        is_given = card.text(of_poisson) or not (shear > 0.0 and young > 0.0)
        found.poisson[key] = card.real(of_poisson) if is_given else young / (2.0 * shear) - 1.0
        found.names[key] = f"MAT1 {key}"

    def _whole(self, file: int, card: Card, position: int) -> int | None:
        """Return an integer, or None if the field is blank. Raises FileError."""
        text = card.text(position)
        number = parse_integer(text) if text else None
        if text and number is None:
            what = f'{card.name}: "{text}" in field {position + 2} is not a whole number'
            raise self.raw.error((file, card.line), what)
        return number

    def _odd_grid(self, file: int, card: Card, points: Points) -> None:
        """Read a GRID card in free fields, with tabs or comments, or shortened."""
        node = self._whole(file, card, GRID["id"])
        if node is None:
            raise self.raw.error((file, card.line), "GRID: a node without an id")
        if len(card.fields) < GRID["point"] + 3:
            what = f"node {node}: GRID* without its second line"
            raise self.raw.error((file, card.line), what, "add the line with its third coordinate")
        system = self._whole(file, card, GRID["system"])
        first = GRID["point"]
        points.add(card, node, -1 if system is None else system, card.fields[first : first + 3])

    def _frame(self, file: int, card: Card) -> None:
        kind = card.name[-1]
        if card.name[4] == "1":
            for at in CARDS["CORD1"]["id"]:
                if card.text(at):
                    told = [self._whole(file, card, at + k) for k in range(4)]
                    ids = [number for number in told if number is not None]
                    if len(ids) < 4:
                        what = f"{card.name} {card.text(at)} needs three nodes"
                        raise self.raw.error((file, card.line), what)
                    self._define(file, card, ids[0], Frame(kind, (ids[1], ids[2], ids[3])))
            return
        number = self._whole(file, card, 0) or 0
        values = [parse_real(card.text(k)) for k in CARDS["CORD2"]["points"]]
        if None in values:
            what = f"{card.name} {number}: a coordinate is not a number"
            raise self.raw.error((file, card.line), what)
        reference = self._whole(file, card, CARDS["CORD2"]["system"][0]) or 0
        points = np.array(values).reshape(3, 3)
        self._define(file, card, number, Frame(kind, None, points, reference))

    def _define(self, file: int, card: Card, number: int, frame: Frame) -> None:
        old = self._frames.get(number)
        if old is not None and (
            (old.kind, old.nodes, old.reference) != (frame.kind, frame.nodes, frame.reference)
            or old.points is not None
            and frame.points is not None
            and not np.array_equal(old.points, frame.points)
        ):
            what = f"coordinate system {number} is defined twice, differently"
            raise self.raw.error((file, card.line), what, "remove one of the cards")
        self._frames[number] = frame


def _with_systems(block: Block, default: int) -> Block:
    """Return the block with the default system where a card does not give one."""
    assert block.systems is not None  # every GRID has its own, or -1
    systems = np.where(block.systems < 0, default, block.systems)
    return replace(block, systems=systems.astype(np.int32))
