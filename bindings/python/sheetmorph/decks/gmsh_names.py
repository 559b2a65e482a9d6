# SPDX-License-Identifier: LGPL-2.1-or-later
"""Physical groups of a Gmsh mesh: of surfaces as elements, of curves and points as nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from ..arrays import Ints
from .model import NamedSet, Raw

_DIMENSIONS = {"mass": 0, "line": 1, "shell": 2, "solid": 3}
_NAME = re.compile(rb'^\s*([0-3])\s+(\d+)\s+"([^"\n]*)"', re.MULTILINE)
Entity = tuple[int, int]  # dimension and tag


class PhysicalGroups:
    """Gathers which entities of the geometry are in which group."""

    def __init__(self) -> None:
        self._groups: dict[Entity, set[int]] = {}

    def add(self, kind: str, entities: Ints, groups: Ints) -> None:
        """Elements of a kind, their entities and groups (n,), 0 for none, as version 2 has them."""
        pairs = np.unique(np.stack([entities, groups], axis=1), axis=0)
        for entity, group in pairs.tolist():
            if entity > 0 and group > 0:
                self._groups.setdefault((_DIMENSIONS[kind], entity), set()).add(group)

    def read_entities(self, text: bytes, version: float) -> None:
        """What $Entities of version 4 says; a section that is none says nothing."""
        words = text.split()
        try:
            counts, at = [int(word) for word in words[:4]], 4
            for dimension, count in enumerate(counts):
                for _ in range(count):
                    at = self._entity(words, at, (dimension, version))
        except (ValueError, IndexError):
            return

    def _entity(self, words: list[bytes], at: int, form: tuple[int, float]) -> int:
        """Take one entity; where the next one begins."""
        dimension, version = form
        place = at + 1 + (3 if dimension == 0 and version > 4.0 else 6)
        end = place + 1 + int(words[place])
        found = {abs(int(word)) for word in words[place + 1 : end]}
        if found:
            self._groups.setdefault((dimension, int(words[at])), set()).update(found)
        return end if dimension == 0 else end + 1 + int(words[end])

    def sets(self, raw: Raw, names: bytes) -> Iterator[NamedSet]:
        """The groups with a name, of the elements that were read; names: $PhysicalNames."""
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
