# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connections in LS-DYNA that are not elements: welds, rigid bodies, systems by nodes."""

from __future__ import annotations

import numpy as np

from ..model import Elements, NamedSet, Raw
from ..numbers import parse_integer, parse_real
from .cards import DynaCards, Section
from .table import CARDS, Field

JOINTS = (
    "CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET", "CONSTRAINED_NODAL_RIGID_BODY",
    "CONSTRAINED_NODE_SET", "CONSTRAINED_GENERALIZED_WELD", "CONSTRAINED_EXTRA_NODES",
    "CONSTRAINED_JOINT", "DEFINE_COORDINATE_NODES", "SET_NODE", "SET_PART", "SET_SHELL",
)  # fmt: skip
_LARGEST = 1e15
# Start of a keyword, and the kind of its joint. The second table has joints of node sets.
_OF_NODES = {
    "CONSTRAINED_SPOTWELD": "weld",
    "CONSTRAINED_RIVET": "weld",
    "CONSTRAINED_JOINT": "constraint",
    "DEFINE_COORDINATE_NODES": "frame",
    "CONSTRAINED_EXTRA_NODES_NODE": "rigid",
}
_OF_SETS = {
    "CONSTRAINED_NODAL_RIGID_BODY": "rigid",
    "CONSTRAINED_EXTRA_NODES_SET": "rigid",
    "CONSTRAINED_GENERALIZED_WELD": "weld",
    "CONSTRAINED_NODE_SET": "constraint",
}
# What the numbers of a set refer to.
_SETS = {"SET_NODE": "nodes", "SET_PART": "properties", "SET_SHELL": "elements"}


class Joints:
    """Collector of joints; those of sets are resolved at the end."""

    def __init__(self, raw: Raw):
        self._raw = raw
        self._sets: dict[int, list[int]] = {}  # node sets
        self._named: dict[str, tuple[str, list[int]]] = {}
        self._by_set: list[tuple[str, str, tuple[int, int, int], int, int]] = []

    def add(self, cards: DynaCards, section: Section) -> None:
        """Read a keyword."""
        name, rows = section.name, section.rows.tolist()
        for word, of in _SETS.items():
            if name.startswith(word):
                self._set(cards, section, (word, of))
                return
        rows = _cards_of(name, rows)
        for begin, kind in _OF_NODES.items():
            if name.startswith(begin):
                self._of_nodes(cards, section, rows, (kind, CARDS[begin]))
                return
        for begin, kind in _OF_SETS.items():
            if name.startswith(begin):
                # Options of a rigid body add cards; without them, each card is a body.
                plain = name.removesuffix("_ID").removesuffix("_TITLE") == begin
                for line in rows if plain else rows[:1]:
                    self._of_set(cards, section, line, (kind, CARDS[begin]))

    def _of_nodes(
        self,
        cards: DynaCards,
        section: Section,
        rows: list[int],
        what: tuple[str, dict[str, Field]],
    ) -> None:
        kind, layout = what
        place = layout["nodes"]
        for line in rows:
            fields = cards.fields(line, cards.width)
            nodes = [_number(text) for text in fields[place.at : place.at + place.count]]
            number = _number(fields[layout["id"].at]) if "id" in layout else 0
            self._joint(f"*{section.name}", kind, number, (nodes, cards.file, line))

    def _of_set(
        self, cards: DynaCards, section: Section, line: int, what: tuple[str, dict[str, Field]]
    ) -> None:
        kind, layout = what
        fields = cards.fields(line, cards.width)
        owner, group = _number(fields[layout["id"].at]), _number(fields[layout["set"].at])
        main = _number(fields[layout["main"].at]) if "main" in layout else 0
        self._by_set.append((section.name, kind, (owner, group, main), cards.file, line))

    def _joint(self, name: str, kind: str, number: int, what: tuple[list[int], int, int]) -> None:
        nodes, file, line = what
        if any(nodes):
            one = np.array([nodes], dtype=np.int64)
            self._raw.elements.append(
                Elements(
                    name, kind, np.array([number]), np.zeros(1, np.int64), np.maximum(one, 0),
                    file, np.array([line], np.int32),
                )
            )  # fmt: skip

    def _set(self, cards: DynaCards, section: Section, what: tuple[str, str]) -> None:
        name, rows = section.name, section.rows.tolist()
        word, of = what
        has_title = name.endswith("_TITLE")
        name = name.removesuffix("_TITLE").removesuffix("_COLLECT")
        title = cards.text.line(rows[0]).strip() if has_title and rows else ""
        rows = rows[1:] if has_title else rows
        kind = name[len(word) :]
        if not rows or kind not in ("", "_LIST", "_LIST_GENERATE", "_COLUMN", "_LIST_SMOOTH"):
            return
        number = _number(cards.fields(rows[0], cards.width)[CARDS["SET"]["id"].at])
        members = self._named.setdefault(f"{word} {number}", (of, []))[1]
        if word == "SET_NODE":
            self._sets[number] = members
        if title:
            self._named.setdefault(f"{word} {title}", (of, members))
        most = CARDS["SET"]["members"].count
        for line in rows[CARDS["SET"]["members"].card :]:
            numbers = [_number(text) for text in cards.fields(line, cards.width)[:most]]
            if kind == "_COLUMN":
                members.append(numbers[0])
            elif kind == "_LIST_GENERATE":
                for low, high in zip(numbers[::2], numbers[1::2]):
                    members += list(range(low, min(high, low + 10**6) + 1)) if low > 0 else []
            else:
                members += [number for number in numbers if number > 0]

    def finish(self) -> None:
        """Add the joints of node sets, and the sets, to the deck."""
        for title, (of, members) in self._named.items():
            self._raw.sets.append(NamedSet(title, of, members))
        for name, kind, (owner, group, main), file, line in self._by_set:
            members = self._sets.get(group, [])
            nodes = ([main] if main > 0 else []) + members
            self._joint(f"*{name}", kind, owner, (nodes, file, line))


def _cards_of(name: str, rows: list[int]) -> list[int]:
    """Return the cards that list the joined nodes, without ids, titles and option cards."""
    words = name.split("_")
    first = int("ID" in words or "TITLE" in words)
    if name.startswith("CONSTRAINED_SPOTWELD"):
        # Each weld has its id, and its filter, in separate cards.
        return rows[first :: 1 + first + int("FILTERED" in words)]
    if name.startswith("CONSTRAINED_RIVET"):
        return rows[first :: 1 + first]
    return rows[first:][:1] if name.startswith("CONSTRAINED_JOINT") else rows[first:]


def _number(text: str) -> int:
    found = parse_integer(text)
    if found is None:
        real = parse_real(text)
        found = int(real) if real is not None and abs(real) < _LARGEST else 0
    return found
