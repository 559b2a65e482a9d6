# SPDX-License-Identifier: LGPL-2.1-or-later
"""What joins nodes in LS-DYNA without being an element: welds, rigid bodies, systems by nodes."""

from __future__ import annotations

import numpy as np

from .dyna_cards import DynaCards, Section
from .model import Elements, NamedSet, Raw
from .numbers import parse_integer, parse_real

JOINTS = (
    "CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET", "CONSTRAINED_NODAL_RIGID_BODY",
    "CONSTRAINED_NODE_SET", "CONSTRAINED_GENERALIZED_WELD", "CONSTRAINED_EXTRA_NODES",
    "CONSTRAINED_JOINT", "DEFINE_COORDINATE_NODES", "SET_NODE", "SET_PART", "SET_SHELL",
)  # fmt: skip
_LARGEST = 1e15
# What the numbers of a set are of.
_SETS = {"SET_NODE": "nodes", "SET_PART": "properties", "SET_SHELL": "elements"}


class Joints:
    """Gathers them; those of sets are known at the end only."""

    def __init__(self, raw: Raw):
        self._raw = raw
        self._sets: dict[int, list[int]] = {}  # of nodes
        self._named: dict[str, tuple[str, list[int]]] = {}
        self._by_set: list[tuple[str, int, int, int, int, int]] = []

    def add(self, cards: DynaCards, section: Section) -> None:
        """Take a keyword."""
        name, rows = section.name, section.rows.tolist()
        for word, of in _SETS.items():
            if name.startswith(word):
                self._set(cards, section, (word, of))
                return
        each = 2 if name.endswith(("_FILTERED_FORCE", "_FILTERED_FORCE_ID")) else 1
        rows = rows[1:] if name.endswith(("_ID", "_TITLE")) and rows else rows
        if name.startswith(("CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET")):
            self._pairs(cards, section, rows[::each], ("weld", 0, 2))
        elif name.startswith("CONSTRAINED_JOINT"):
            self._pairs(cards, section, rows[:1], ("rigid", 0, 6))
        elif name.startswith("DEFINE_COORDINATE_NODES"):
            self._pairs(cards, section, rows, ("frame", 1, 4))
        elif name.startswith("CONSTRAINED_EXTRA_NODES_NODE"):
            self._pairs(cards, section, rows, ("rigid", 1, 2))
        elif rows:
            at = {"CONSTRAINED_NODAL": 2, "CONSTRAINED_EXTRA": 1}.get(name[:17], 0)
            fields = cards.fields(rows[0], cards.width)
            owner, group = _number(fields[0]), _number(fields[at])
            lead = _number(fields[3]) if at == 2 else 0
            self._by_set.append((name, owner, group, lead, cards.file, rows[0]))

    def _pairs(
        self, cards: DynaCards, section: Section, rows: list[int], place: tuple[str, int, int]
    ) -> None:
        kind, first, end = place
        for line in rows:
            fields = cards.fields(line, cards.width)
            nodes = [_number(text) for text in fields[first:end]]
            number = _number(fields[0]) if first else 0
            self._joint(f"*{section.name}", kind, number, (nodes, cards.file, line))

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
        number = _number(cards.fields(rows[0], cards.width)[0])
        members = self._named.setdefault(f"{word} {number}", (of, []))[1]
        if word == "SET_NODE":
            self._sets[number] = members
        if title:
            self._named.setdefault(f"{word} {title}", (of, members))
        for line in rows[1:]:
            numbers = [_number(text) for text in cards.fields(line, cards.width)[:8]]
            if kind == "_COLUMN":
                members.append(numbers[0])
            elif kind == "_LIST_GENERATE":
                for low, high in zip(numbers[::2], numbers[1::2]):
                    members += list(range(low, min(high, low + 10**6) + 1)) if low > 0 else []
            else:
                members += [number for number in numbers if number > 0]

    def finish(self) -> None:
        """Add what joins sets of nodes, and the sets themselves."""
        for title, (of, members) in self._named.items():
            self._raw.sets.append(NamedSet(title, of, members))
        for name, owner, group, lead, file, line in self._by_set:
            members = self._sets.get(group, [])
            nodes = ([lead] if lead > 0 else []) + members
            self._joint(f"*{name}", "rigid", owner, (nodes, file, line))


def _number(text: str) -> int:
    found = parse_integer(text)
    if found is None:
        real = parse_real(text)
        found = int(real) if real is not None and abs(real) < _LARGEST else 0
    return found
