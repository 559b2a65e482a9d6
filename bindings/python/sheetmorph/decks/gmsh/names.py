# SPDX-License-Identifier: LGPL-2.1-or-later
"""Physical groups of a Gmsh mesh: surfaces as element sets, curves and points as node sets."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from ...base.arrays import Ints
from ..model import NamedSet, Raw

_DIMENSIONS = {"mass": 0, "line": 1, "shell": 2, "solid": 3}
_NAME = re.compile(rb'^\s*([0-3])\s+(\d+)\s+"([^"\n]*)"', re.MULTILINE)
Entity = tuple[int, int]  # dimension and tag


class PhysicalGroups:
    """Collector of the geometric entities in each group."""

    def __init__(self) -> None:
        self._groups: dict[Entity, set[int]] = {}

    def add(self, kind: str, entities: Ints, groups: Ints) -> None:
        """Add elements of a kind with their entities and groups (n,), 0 for none (version 2)."""
        pairs = np.unique(np.stack([entities, groups], axis=1), axis=0)
        for entity, group in pairs.tolist():
            if entity > 0 and group > 0:
                self._groups.setdefault((_DIMENSIONS[kind], entity), set()).add(group)

    def read_entities(self, text: bytes, version: float) -> None:
        """Read $Entities of version 4; an invalid section is ignored."""
        words = text.split()
        try:
            counts, at = [int(word) for word in words[:4]], 4
            for dimension, count in enumerate(counts):
                for _ in range(count):
                    at = self._entity(words, at, (dimension, version))
        except (ValueError, IndexError):
            return

    def _entity(self, words: list[bytes], at: int, form: tuple[int, float]) -> int:
        """Read one entity and return the start of the next one."""
        dimension, version = form
        place = at + 1 + (3 if dimension == 0 and version > 4.0 else 6)
        end = place + 1 + int(words[place])
        found = {abs(int(word)) for word in words[place + 1 : end]}
        if found:
            self._groups.setdefault((dimension, int(words[at])), set()).update(found)
        return end if dimension == 0 else end + 1 + int(words[end])

    def sets(self, raw: Raw, names: bytes) -> Iterator[NamedSet]:
        """Yield the named groups of the elements; names has $PhysicalNames."""
        for mark in _NAME.finditer(names):
            dimension, group = int(mark.group(1)), int(mark.group(2))
            tags = [
                tag
                for (of, tag), groups in self._groups.items()
                if of == dimension and group in groups
            ]
            ids: list[Ints] = []
            for block in raw.elements:
                if _DIMENSIONS.get(block.kind) == dimension:
                    rows = np.isin(block.properties, tags)
                    ids.append(block.ids[rows] if dimension > 1 else np.unique(block.nodes[rows]))
            if sum(map(len, ids)):
                name = f"physical {mark.group(3).decode('utf-8', 'replace')}"
                kind = "elements" if dimension > 1 else "nodes"
                yield NamedSet(name, kind, np.unique(np.concatenate(ids)))
