# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in an input file: sets of nodes and elements, including those of parts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...base.arrays import Ints
from ..model import NamedSet, Raw
from ..numbers import parse_integer
from .lines import AbaqusLines, Keyword

_MOST = 10**7
# By part number: the blocks of its elements, and the shift of its ids.
Before = Mapping[int, tuple[Sequence[int], Ints]]
Owners = Mapping[int, tuple[Sequence[int], int]]


class NamedSets:
    """Collector of sets; the names of parts are resolved at the end."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], list[tuple[int, Ints]]] = {}
        self._sections: dict[str, list[int]] = {}

    def add(self, kind: str, name: str, owner: int, ids: Ints) -> None:
        """Add nodes ("NSET") or elements ("ELSET") of a part, by its number, to a set."""
        if name and len(ids):
            self._found.setdefault((kind, name.upper()), []).append((owner, ids))

    def add_section(self, name: str, number: int) -> None:
        """Register the set name that *ELEMENT gives its elements, with their property number."""
        if name:
            self._sections.setdefault(name.upper(), []).append(number)

    def read(self, lines: AbaqusLines, keyword: Keyword, owner: int) -> None:
        """Read *NSET or *ELSET with its numbers, ranges and names of other sets."""
        kind = keyword.name
        name = keyword.options.get(kind, "").upper()
        numbers, names = members_of(lines, keyword)
        self.add(kind, name, owner, np.array(numbers, dtype=np.int64))
        for other in names:
            found = list(self._found.get((kind, other), []))
            if kind == "ELSET" and other in self._sections:
                found.append((_OF_PROPERTY, np.array(self._sections[other])))
            self._found.setdefault((kind, name), []).extend(found)

    def elements_of(self, owner: int, name: str) -> tuple[Ints, list[int]]:
        """Return the element ids of a part in a set, and the property numbers in it."""
        pieces = self._found.get(("ELSET", name), [])
        ids = [ids for of, ids in pieces if of == owner]
        numbers = [number for of, some in pieces if of == _OF_PROPERTY for number in some.tolist()]
        return np.concatenate([np.empty(0, dtype=np.int64), *ids]), numbers

    def finish(self, raw: Raw, owners: Owners, before: Before) -> None:
        """Add the sets to the deck.

        before has the original elements of property numbers from which sections took some, as
        blocks and ids.
        """

        def add_numbers(name: str, numbers: Sequence[int]) -> None:
            raw.sets.append(NamedSet(f"ELSET {name}", "properties", list(numbers)))
            for number in numbers:
                if number in before:
                    blocks, ids = before[number]
                    raw.sets.append(NamedSet(f"ELSET {name}", "elements", ids, tuple(blocks)))

        for name, own in self._sections.items():
            add_numbers(name, own)
        for (kind, name), pieces in self._found.items():
            for owner, ids in pieces:
                blocks, shift = owners.get(owner, ((), 0))
                if kind == "NSET":
                    raw.sets.append(
                        NamedSet(f"NSET {name}", "nodes", ids + shift if shift else ids)
                    )
                elif owner == _OF_PROPERTY:
                    add_numbers(name, ids.tolist())
                else:
                    raw.sets.append(NamedSet(f"ELSET {name}", "elements", ids, tuple(blocks)))


_OF_PROPERTY = 1  # in place of a part number, which is at most 0


def members_of(lines: AbaqusLines, keyword: Keyword) -> tuple[list[int], list[str]]:
    """Return the numbers and the names in the lines of a set."""
    numbers: list[int] = []
    names: list[str] = []
    for line in keyword.rows.tolist():
        words = [word for word in lines.words(line) if word]
        found = [number for number in map(parse_integer, words) if number is not None]
        names += [word for word in words if parse_integer(word) is None]
        if "GENERATE" in keyword.options and len(found) >= 2:
            step = max(1, found[2]) if len(found) > 2 else 1
            numbers += range(found[0], min(found[1], found[0] + _MOST) + 1, step)
        else:
            numbers += found
    return numbers, names
