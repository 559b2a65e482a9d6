# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheets of a recipe by their names in joint files: parts, property numbers, groups."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel
from ..base.motion import Motion
from ..files.deck_file import DeckFile
from ..measuring.strain import middle_edge
from ..recipe.parts import Source

if TYPE_CHECKING:
    from .. import _core


@dataclass(frozen=True)
class Foot:
    """The point of a sheet nearest to a given point.

    source is the number of the file and triangle that of its mesh. distance and thickness are in
    mm; thickness is 0 if not given.
    """

    source: int
    triangle: int
    barycentric: Floats
    distance: float
    thickness: float


@dataclass(frozen=True)
class Piece:
    """Triangles (k,) of a source with their search tree.

    source is the number of the file. thickness is that of the sheet and edge the median edge
    length, mm.
    """

    source: int
    triangles: Ints
    tree: _core.PickingTree
    thickness: float
    edge: float

    def foot(self, point: Floats) -> Foot | None:
        """Return the nearest point of the sheet, or None."""
        hit = self.tree.nearest_point(point)
        if hit is None:
            return None
        triangle = int(self.triangles[hit.triangle])
        where = np.asarray(hit.barycentric)
        return Foot(self.source, triangle, where, float(hit.distance), self.thickness)


class Sheets:
    """The sheets of all part files at rest, in assembly coordinates."""

    def __init__(self, sources: Sequence[Source], thickness: Mapping[str, float]):
        self.sources = list(sources)
        self.rest = [s.placement.placed(s.file.mesh.points) for s in self.sources]
        self._thickness = thickness
        self._pieces: dict[tuple[str, ...], list[Piece]] = {}

    def named(self, names: tuple[str, ...]) -> list[Piece]:
        """Return the sheets of the first name that matches any."""
        if names not in self._pieces:
            found: list[Piece] = []
            for name in names:
                found = found or self._of_part(name) or self._of_number(name)
                found = found or self._of_group(name)
            self._pieces[names] = found
        return self._pieces[names]

    def all(self) -> list[Piece]:
        """Return all parts."""
        if () not in self._pieces:
            names = [name for source in self.sources for name in source.members]
            self._pieces[()] = [piece for name in names for piece in self._of_part(name)]
        return self._pieces[()]

    def _of_part(self, wanted: str) -> list[Piece]:
        return [
            self._piece(k, self._own(source, vertices), self._thickness.get(name, 0.0))
            for k, source in enumerate(self.sources)
            for name, vertices in source.members.items()
            if wanted in (name, name.rsplit("/", 1)[-1])
        ]

    def _of_number(self, wanted: str) -> list[Piece]:
        """Return the sheets with a property number (PID)."""
        if not wanted.isdecimal():
            return []
        number, found = int(wanted[:18]), []
        for k, source in enumerate(self.sources):
            if isinstance(source.file, DeckFile):
                rows = np.flatnonzero(source.file.sheet.properties == number)
                thickness = source.file.deck.raw.thickness.get(number, 0.0)
                found += [self._piece(k, rows, thickness)] if len(rows) else []
        return found

    def _of_group(self, wanted: str) -> list[Piece]:
        found = []
        for k, source in enumerate(self.sources):
            labels = source.file.mesh.labels
            groups = labels.groups if labels is not None else {}
            for name, rows in groups.items():
                if wanted in (name, name.split(" ", 1)[-1]):
                    found.append(self._piece(k, np.asarray(rows), 0.0))
        return found

    @staticmethod
    def _own(source: Source, vertices: Ints) -> Ints:
        inside = np.zeros(len(source.file.mesh.points), dtype=bool)
        inside[vertices] = True
        return np.flatnonzero(inside[source.file.mesh.triangles].all(axis=1))

    def _piece(self, number: int, rows: Ints, thickness: float) -> Piece:
        points = self.rest[number]
        triangles = np.ascontiguousarray(self.sources[number].file.mesh.triangles[rows], np.int32)
        tree = load_kernel().PickingTree(points, triangles)
        return Piece(number, rows, tree, thickness, middle_edge(points, triangles))

    def motions(self, of_parts: Mapping[str, Floats], feet: Sequence[Foot]) -> list[Motion]:
        """Return the motion of each source at some feet, with its parts at positions (n, 3)."""
        found = []
        for k, source in enumerate(self.sources):
            own = source.positions(dict(of_parts))
            triangles = source.file.mesh.triangles
            asked = [triangles[foot.triangle] for foot in feet if foot.source == k]
            rows = np.unique(asked).astype(np.int64)
            moved = source.placement.placed(own)
            still = (own == source.file.mesh.points).all(axis=1)
            moved[still] = self.rest[k][still]
            found.append(Motion(self.rest[k], moved, triangles, rows))
        return found
