# SPDX-License-Identifier: LGPL-2.1-or-later
"""Node groups of Radioss, with rigid bodies and multi-strand elements defined by them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..model import Elements, NamedSet, Raw
from .submodels import Shift

# The ids that a group of each kind lists.
_NODES, _RANGES, _PARTS, _GROUPS = ("NODE", "NODENS"), "GENE", "PART", "GRNOD"


@dataclass(frozen=True)
class _User:
    """An entity with a node group: card, kind, id, part, main node (0 if none), and group."""

    card: str
    kind: str
    number: int
    part: int
    main: int
    group: int
    place: tuple[int, int]


class Groups:
    """Collector of groups while a deck is read; their nodes are resolved at the end."""

    def __init__(self, raw: Raw):
        self._raw = raw
        self._groups: dict[int, tuple[str, list[int]]] = {}
        self._users: list[_User] = []

    def add(self, kind: str, number: int, members: Sequence[int], shift: Shift) -> None:
        """Add a group with the numbers in its lines."""
        by = shift.node if kind in (*_NODES, _RANGES) else shift.other
        by = shift.part if kind == _PARTS else by
        own = [one + by if one > 0 else one - by if one < 0 else 0 for one in members]
        self._groups[number + shift.other] = (kind, own)

    def add_body(self, body: tuple[int, int, int], shift: Shift, place: tuple[int, int]) -> None:
        """Add a rigid body with id, main node and group, at (file, line)."""
        number, main, group = body
        main += shift.node if main else 0
        group += shift.other if group else 0
        user = _User("/RBODY", "rigid", number + shift.other, 0, main, group, place)
        self._users.append(user)

    def add_line(
        self, number: int, of: tuple[int, int], shift: Shift, place: tuple[int, int]
    ) -> None:
        """Add an element through all nodes of a group; of has its part and group."""
        part, group = of
        user = _User("/XELEM", "line", number, part + shift.part, 0, group + shift.other, place)
        self._users.append(user)

    def finish(self) -> None:
        """Add the groups and their elements to the deck."""
        for number, (kind, members) in self._groups.items():
            if kind in _NODES:
                self._raw.sets.append(NamedSet(f"GRNOD {number}", "nodes", members))
        for user in self._users:
            self._add(user)

    def _add(self, user: _User) -> None:
        found = self._nodes_of(user.group, set()) if user.group else []
        file, line = user.place
        if found is None:
            place = f"{self._raw.texts[file].name}, line {line + 1}"
            what = f"the nodes of its group {user.group} are not known"
            self._raw.notes.append(f"{place}: {user.card} {user.number} is not checked: {what}")
            return
        nodes = list(dict.fromkeys([user.main, *found] if user.main else found))
        if len(nodes) > 1:
            self._raw.elements.append(
                Elements(
                    user.card, user.kind, np.array([user.number]), np.array([user.part]),
                    np.array([nodes], dtype=np.int64), file, np.array([line], np.int32),
                )
            )  # fmt: skip

    def _nodes_of(self, number: int, open_groups: set[int]) -> list[int] | None:
        """Return the nodes of a group, or None if it is missing or of an unsupported kind."""
        if number not in self._groups or number in open_groups:
            return None
        kind, members = self._groups[number]
        if kind in _NODES:
            return [one for one in members if one > 0]
        if kind == _RANGES:
            known = np.unique(np.concatenate([np.zeros(0, np.int64), *self._all_ids()]))
            pairs = list(zip(members[::2], members[1::2]))
            inside = [known[(known >= low) & (known <= high)] for low, high in pairs]
            nodes = np.concatenate([np.zeros(0, np.int64), *inside]).astype(np.int64)
            return [int(node) for node in nodes]
        if kind == _PARTS:
            return self._of_parts(members)
        return self._combined(members, {*open_groups, number}) if kind == _GROUPS else None

    def _combined(self, members: Sequence[int], open_groups: set[int]) -> list[int] | None:
        """Return the nodes of several groups without those of negative groups."""
        kept: dict[int, None] = {}
        for member in sorted(members, key=lambda one: one < 0):
            some = self._nodes_of(abs(member), open_groups)
            if some is None:
                return None
            for node in some:
                kept.pop(node, None) if member < 0 else kept.setdefault(node)
        return list(kept)

    def _all_ids(self) -> list[np.ndarray[tuple[int], np.dtype[np.int64]]]:
        return [np.asarray(block.ids, dtype=np.int64) for block in self._raw.blocks]

    def _of_parts(self, parts: Sequence[int]) -> list[int]:
        found = [np.zeros(0, dtype=np.int64)]
        for block in self._raw.elements:
            rows = np.isin(block.properties, parts)
            found.append(np.unique(block.nodes[rows].astype(np.int64)))
        nodes = np.unique(np.concatenate(found))
        return [int(node) for node in nodes[nodes > 0]]
