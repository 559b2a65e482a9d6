# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connections between nodes of an input file that are not elements."""

from __future__ import annotations

import numpy as np

from ...base.arrays import Ints
from ..model import Elements, Raw
from ..numbers import parse_integer
from .lines import AbaqusLines, Keyword
from .sets import members_of
from .table import FIELDS


# Multi-point constraints that keep the distance between two nodes.
_RIGID = ("BEAM", "LINK")


class Sets:
    """Node sets by name, and the joints that refer to them."""

    def __init__(self, raw: Raw):
        self._raw = raw
        self._sets: dict[str, list[Ints]] = {}
        self._joints: list[tuple[str, str, list[str], int, int]] = []

    def add_nodes(self, name: str, ids: Ints) -> None:
        """Add nodes to a set if it has a name."""
        if name:
            self._sets.setdefault(name.upper(), []).append(ids)

    def add_joint(
        self, name: str, members: list[str], file: int, line: int, *, is_rigid: bool = True
    ) -> None:
        """Add a joint of nodes and node sets, by number and name."""
        kind = "rigid" if is_rigid else "constraint"
        self._joints.append((name, kind, members, file, line))

    def finish(self) -> None:
        """Add the joints to the elements of the deck."""
        for name, kind, members, file, line in self._joints:
            nodes = list(dict.fromkeys(self._resolved(members)))
            if len(nodes) > 1:
                self._raw.elements.append(
                    Elements(
                        f"*{name}", kind, np.zeros(1, np.int64), np.zeros(1, np.int64),
                        np.array([nodes]), file, np.array([line], np.int32),
                    )
                )  # fmt: skip

    def _resolved(self, members: list[str]) -> list[int]:
        found: list[int] = []
        for member in members:
            number = parse_integer(member)
            if number is not None:
                found += [number] if number > 0 else []
            else:
                for ids in self._sets.get(member.upper(), []):
                    found += ids.tolist()
        return found


def add_joint(sets: Sets, lines: AbaqusLines, keyword: Keyword) -> None:
    """Add a node set, or the joint of a keyword."""
    name, options = keyword.name, keyword.options
    if name == "NSET":
        ids, _ = members_of(lines, keyword)
        sets.add_nodes(options.get("NSET", ""), np.array(ids, dtype=np.int64))
    elif name == "RIGID BODY":
        members = [options.get("REF NODE", ""), options.get("ROT NODE", "")]
        members += [options.get(key, "") for key in ("NSET", "TIE NSET", "PIN NSET")]
        sets.add_joint(name, [one for one in members if one], lines.file, keyword.line)
    elif name == "KINEMATIC COUPLING":
        members = [options.get("REF NODE", "")]
        at = FIELDS[name]["node"][1]
        members += [lines.words(int(line))[at] for line in keyword.rows]
        sets.add_joint(name, members, lines.file, keyword.line)
    elif name == "MPC":
        for line in keyword.rows.tolist():
            _, first, end = FIELDS[name]["nodes"]
            words = lines.words(line)
            is_rigid = words[0] in _RIGID
            sets.add_joint(name, words[first:end], lines.file, line, is_rigid=is_rigid)
    elif name == "EQUATION":
        _equations(sets, lines, keyword)


def _equations(sets: Sets, lines: AbaqusLines, keyword: Keyword) -> None:
    """Add equations: the number of terms, then node, direction and factor of each."""
    members: list[str] = []
    missing, start = 0, 0
    for line in keyword.rows.tolist():
        words = lines.words(line)
        if missing <= 0:
            missing, members, start = parse_integer(words[0]) or 0, [], line
            continue
        terms = [word for word in words if word][:: FIELDS["EQUATION"]["term"][2]]
        members += terms
        missing -= len(terms)
        if missing <= 0:
            sets.add_joint(keyword.name, members, lines.file, start, is_rigid=False)
    if missing > 0:
        lines.raw.miss(lines.file, f"*EQUATION: {missing} terms are missing", start)
