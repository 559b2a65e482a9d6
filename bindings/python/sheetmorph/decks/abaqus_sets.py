# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of an input file: sets of nodes and elements, also those that a part has for itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..arrays import Ints
from .abaqus_lines import AbaqusLines, Keyword
from .model import NamedSet, Raw
from .numbers import parse_integer

_MOST = 10**7
# Of a part by its number: the blocks of its elements, and how far its numbers are shifted.
Before = Mapping[int, tuple[Sequence[int], Ints]]
Owners = Mapping[int, tuple[Sequence[int], int]]


class NamedSets:
    """Gathers them; what names of parts stand for is known at the end only."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], list[tuple[int, Ints]]] = {}
        self._sections: dict[str, list[int]] = {}

    def add(self, kind: str, name: str, owner: int, ids: Ints) -> None:
        """Put nodes ("NSET") or elements ("ELSET") of a part, by its number, into a set."""
        if name and len(ids):
            self._found.setdefault((kind, name.upper()), []).append((owner, ids))

    def add_section(self, name: str, number: int) -> None:
        """A name that *ELEMENT gives all its elements, which have this property."""
        if name:
            self._sections.setdefault(name.upper(), []).append(number)

    def read(self, lines: AbaqusLines, keyword: Keyword, owner: int) -> None:
        """Take *NSET or *ELSET with what its lines list: numbers, ranges, names of other sets."""
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
        """The ids of the elements of a part in a set, and the numbers that *ELEMENT gave others."""
        pieces = self._found.get(("ELSET", name), [])
        ids = [ids for of, ids in pieces if of == owner]
        numbers = [number for of, some in pieces if of == _OF_PROPERTY for number in some.tolist()]
        return np.concatenate([np.empty(0, dtype=np.int64), *ids]), numbers

    def finish(self, raw: Raw, owners: Owners, before: Before) -> None:
        """Add them to what was read; before: of numbers of *ELEMENT that sections took elements
        away from, the blocks and ids of all that had them."""

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


_OF_PROPERTY = 1  # in place of a part's number, which is 0 or less


def members_of(lines: AbaqusLines, keyword: Keyword) -> tuple[list[int], list[str]]:
    """The numbers and the names that the lines of a set list."""
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
