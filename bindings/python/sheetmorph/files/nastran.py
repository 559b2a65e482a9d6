# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data: the coordinates of GRID cards are rewritten, every other byte stays."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ..errors import FileError, list_ids
from ..part_mesh import PartMesh
from .nastran_cards import Card, Field, cards, replaced
from .nastran_sets import labels_of
from .nastran_number import format_real, parse_real
from .part_file import PartFile
from .polygons import triangulate
from .text import read_bytes

_SHELLS = {"CTRIA3": 3, "CTRIAR": 3, "CQUAD4": 4, "CQUADR": 4}
_CURVED = frozenset({"CTRIA6", "CQUAD8", "CQUAD", "CTRIAX6"})
_NAMES = frozenset({"GRID", "GRDSET", *_SHELLS, *_CURVED})


@dataclass(frozen=True)
class _Grid:
    """A node: its coordinate system, the fields and the values of its three coordinates."""

    line: int
    system: int
    fields: tuple[Field, Field, Field]
    values: tuple[float, float, float]
    width: int


@dataclass
class _Deck:
    """What a deck says about its shells; elements hold node ids, element_lines line indices."""

    path: Path
    grids: dict[int, _Grid] = field(default_factory=dict)
    elements: list[list[int]] = field(default_factory=list)
    properties: list[int] = field(default_factory=list)
    element_lines: list[int] = field(default_factory=list)
    element_ids: list[int] = field(default_factory=list)
    default_system: int = 0

    def error(self, line: int, what: str, todo: str = "correct the card") -> FileError:
        return FileError(self.path, what, todo, line + 1)

    def integer(self, card: Card, position: int, default: int | None = None) -> int:
        text = card.text(position)
        if not text and default is not None:
            return default
        try:
            if len(text) > 16 or "_" in text:
                raise ValueError(text)
            return int(text)
        except ValueError:
            what = f'{card.name}: "{text}" in field {position + 2} is not a whole number'
            raise self.error(card.line, what) from None


class NastranFile(PartFile):
    """A deck; vertex ids are node ids, vertices the nodes of its shell elements in file order."""

    def __init__(self, path: Path):
        data = read_bytes(path)
        self._lines = [line.decode("latin-1") for line in data.splitlines(keepends=True)]
        deck = _read_deck(path, self._lines)
        _check(deck, self._lines)
        used = {node for element in deck.elements for node in element}
        ids = [node for node in deck.grids if node in used]
        self._grids = [deck.grids[node] for node in ids]
        index = {node: k for k, node in enumerate(ids)}
        points = np.array([grid.values for grid in self._grids])
        faces = [[index[node] for node in element] for element in deck.elements]
        rows = np.repeat(np.arange(len(faces)), [len(face) - 2 for face in faces])
        labels = labels_of(self._lines, deck.element_ids, rows, ids)
        mesh = PartMesh(points, triangulate(points, faces), np.array(ids), path.stem, labels)
        width = min(grid.width for grid in self._grids)
        super().__init__(path, mesh, f"{width} characters")
        self.properties = np.array(deck.properties)[rows]
        if len(ids) < len(deck.grids):
            kept = len(deck.grids) - len(ids)
            self.notes.append(f"{kept} nodes belong to no shell element and stay where they are")

    @property
    def lines(self) -> list[str]:
        """The deck's lines with their ends, as they stand in the file."""
        return self._lines

    def save(self, path: Path, positions: np.ndarray) -> None:
        edits: dict[int, list[tuple[Field, str]]] = {}
        changed = positions != self.mesh.points
        for row in np.flatnonzero(changed.any(axis=1)).tolist():
            grid = self._grids[row]
            # In free form a coordinate left out at the end needs its neighbours' commas.
            every = any(place.width < 0 for place in grid.fields)
            for axis in range(3):
                if changed[row, axis] or every:
                    text = self._text(row, float(positions[row, axis]))
                    place = grid.fields[axis]
                    edits.setdefault(place.line, []).append((place, text))
        lines = list(self._lines)
        for number, found in edits.items():
            lines[number] = replaced(lines[number], found)
        path.write_bytes("".join(lines).encode("latin-1"))

    def _text(self, row: int, value: float) -> str:
        try:
            return format_real(value, self._grids[row].width)
        except ValueError as error:
            node = self.mesh.file_ids([row])[0]
            todo = "check the motion, or use GRID* cards"
            raise FileError(self.path, f"node {node}: {error}", todo) from None

    def stored_positions(self, path: Path) -> np.ndarray:
        return NastranFile(path).mesh.points


def _read_deck(path: Path, lines: list[str]) -> _Deck:
    deck = _Deck(path)
    for card in cards(lines, _NAMES):
        if card.name == "GRID":
            _add_grid(deck, card)
        elif card.name == "GRDSET":
            deck.default_system = deck.integer(card, 1, 0)
        elif card.name in _CURVED:
            todo = "use CTRIA3 and CQUAD4 elements"
            raise deck.error(card.line, f"{card.name} has mid-side nodes, which are not read", todo)
        else:
            count = _SHELLS[card.name]
            deck.properties.append(deck.integer(card, 1, deck.integer(card, 0)))
            deck.elements.append([deck.integer(card, 2 + k) for k in range(count)])
            deck.element_lines.append(card.line)
            deck.element_ids.append(deck.integer(card, 0, 0))
    return deck


def _add_grid(deck: _Deck, card: Card) -> None:
    node = deck.integer(card, 0)
    if node in deck.grids:
        raise deck.error(card.line, f"node {node} is defined twice", "remove one of the GRID cards")
    if len(card.fields) < 5:
        what = f"node {node}: GRID* without its second line"
        raise deck.error(card.line, what, "add the line with its third coordinate")
    fields = card.fields[2:5]
    values = [parse_real(place.text) for place in fields]
    for place, value in zip(fields, values):
        if value is None:
            what = f'node {node}: "{place.text.strip()}" is not a number'
            raise deck.error(place.line, what)
    longest = max(len(place.text.strip()) for place in fields)
    width = 16 if card.is_large or longest > 8 else 8
    system = deck.integer(card, 1, -1)
    deck.grids[node] = _Grid(card.line, system, tuple(fields), tuple(values), width)


def _check(deck: _Deck, lines: list[str]) -> None:
    if not deck.elements:
        todo = "choose a deck with CTRIA3 or CQUAD4 elements"
        raise FileError(deck.path, "no shell elements were found", todo)
    for element, line in zip(deck.elements, deck.element_lines):
        missing = [node for node in element if node not in deck.grids]
        if missing:
            includes = any(text[:7].upper() == "INCLUDE" for text in lines)
            todo = "put the INCLUDE files into the deck" if includes else "add their GRID cards"
            raise deck.error(
                line, f"an element names nodes without GRID: {list_ids(missing)}", todo
            )
    used = {node for element in deck.elements for node in element}
    moved = [node for node in deck.grids if node in used and _system(deck, node) != 0]
    if moved:
        what = f"nodes {list_ids(moved)} stand in a coordinate system of their own (CP), not read"
        todo = "write these nodes in the basic system (CP 0 or blank)"
        raise deck.error(deck.grids[moved[0]].line, what, todo)


def _system(deck: _Deck, node: int) -> int:
    system = deck.grids[node].system
    return deck.default_system if system < 0 else system
