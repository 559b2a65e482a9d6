# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be picked on one part, asked from the kernel: facets, faces, hole rims, pieces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

OUTLINE_REACH = 0.05  # of the size: how far beside the part a click still takes its outline


@dataclass(frozen=True)
class Ray:
    """A line of sight, global mm; the direction has any length."""

    origin: np.ndarray
    direction: np.ndarray


class PartMesh:
    """A part as it is seen (for hits) and as it is at rest (for faces and rims)."""

    def __init__(self, core, rest: tuple, seen: np.ndarray):
        """``core``: sheetmorph._core; ``rest``: points and triangles; ``seen``: (n, 3) points."""
        points, self.triangles = rest
        self._core = core
        self._mesh = core.TriangleMesh(np.ascontiguousarray(points, float), self.triangles)
        self._seen = np.ascontiguousarray(seen, float)
        self._tree = core.PickingTree(self._seen, self.triangles)

    @property
    def size(self) -> float:
        """The diagonal of the bounding box, mm."""
        return self._extent(np.unique(self.triangles))

    @cached_property
    def rims(self) -> list[np.ndarray]:
        """The closed boundaries, vertex ids in order; found when they are first needed."""
        return [np.asarray(loop) for loop in self._core.boundary_loops(self._mesh)]

    def hit(self, ray: Ray):
        """The triangle and point (3,) the ray meets first, or None."""
        found = self._tree.nearest_hit(ray.origin, ray.direction)
        return None if found is None else (int(found.triangle), np.asarray(found.point))

    def facet(self, triangle: int) -> frozenset:
        """The vertices of one triangle."""
        return frozenset(self.triangles[triangle].tolist())

    def face(self, triangle: int, crease: float) -> frozenset:
        """The vertices of the face around a triangle; ``crease``: radians at which it ends."""
        facets = np.asarray(self._core.grow_to_creases(self._mesh, int(triangle), float(crease)))
        return frozenset(np.unique(self.triangles[facets]).tolist())

    def piece(self, triangle: int) -> frozenset:
        """The vertices of the connected component of a triangle."""
        facets = np.asarray(self._core.connected_triangles(self._mesh, int(triangle)))
        return frozenset(np.unique(self.triangles[facets]).tolist())

    def rim(self, ray: Ray, rings: int, holes_only: bool = False) -> frozenset:
        """The rim nearest to where the ray meets the part, with rings of vertices around it.

        A ray through an empty hole takes its rim; a ray far from every rim and part takes none.
        """
        candidates = [k for k in range(len(self.rims)) if not (holes_only and k in self._outlines)]
        if not candidates:
            return frozenset()
        found = self.hit(ray)
        gaps = {k: self._gap(ray, found, self.rims[k]) for k in candidates}
        nearest = min(candidates, key=lambda k: (gaps[k], len(self.rims[k])))
        if found is None and gaps[nearest] > self._reach(nearest):
            return frozenset()
        return self.grown(self.rims[nearest], rings)

    def hole_rims(self, rings: int) -> list[frozenset]:
        """The rims of all holes."""
        return [self.grown(r, rings) for k, r in enumerate(self.rims) if k not in self._outlines]

    def grown(self, vertices, rings: int = 1) -> frozenset:
        """The vertices and so many rings of neighbours."""
        return self._resized(self._core.grow_rings, vertices, rings)

    def shrunk(self, vertices, rings: int = 1) -> frozenset:
        """The vertices without so many outermost rings."""
        return self._resized(self._core.shrink_rings, vertices, rings)

    def groups(self, vertices) -> list[list[int]]:
        """The connected pieces of a set of vertices, each sorted, in order of their first one."""
        chosen = np.zeros(len(self._seen), bool)
        chosen[list(vertices)] = True
        ends = np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], axis=2).reshape(
            -1, 2
        )
        pieces = _Pieces(vertices)
        for a, b in ends[chosen[ends].all(axis=1)].tolist():
            pieces.join(a, b)
        return pieces.sorted()

    def _resized(self, function, vertices, rings: int) -> frozenset:
        ids = np.asarray(sorted(vertices), np.int32)
        if rings == 0 or len(ids) == 0:
            return frozenset(ids.tolist())
        return frozenset(np.asarray(function(self._mesh, ids, int(rings))).tolist())

    @cached_property
    def _outlines(self) -> set[int]:
        """The numbers of the rims that are outlines of their connected component.

        That is the longest rim of a component, if it spans half of it; a sheet whose outline
        ends in T-joints has holes only.
        """
        labels = np.asarray(self._core.components(self._mesh))
        longest: dict[int, int] = {}
        for number, rim in enumerate(self.rims):
            other = longest.get(int(labels[rim[0]]))
            if other is None or self._length(rim) > self._length(self.rims[other]):
                longest[int(labels[rim[0]])] = number
        return {
            number
            for component, number in longest.items()
            if self._extent(self.rims[number]) > 0.5 * self._extent(labels == component)
        }

    def _extent(self, vertices) -> float:
        """The diagonal of the bounding box of some vertices, mm."""
        return float(np.linalg.norm(np.ptp(self._seen[vertices], axis=0)))

    def _length(self, rim) -> float:
        points = self._seen[rim]
        return float(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum())

    def _gap(self, ray: Ray, found, rim) -> float:
        """Distance of a rim from the point that was hit, or from a ray that hits nothing."""
        gap = self._seen[rim] - (ray.origin if found is None else found[1])
        if found is None:
            along = ray.direction / np.linalg.norm(ray.direction)
            gap = gap - np.outer(gap @ along, along)
        return float(np.linalg.norm(gap, axis=1).min())

    def _reach(self, rim: int) -> float:
        """How far from a rim a click into the void may be: anywhere in a hole, near an outline."""
        extent = self._extent(self.rims[rim])
        return OUTLINE_REACH * extent if rim in self._outlines else extent / 2


class _Pieces:
    """Which vertices hang together."""

    def __init__(self, vertices):
        self._parent = {int(v): int(v) for v in vertices}

    def join(self, a: int, b: int) -> None:
        self._parent[self._root(a)] = self._root(b)

    def sorted(self) -> list[list[int]]:
        found: dict[int, list[int]] = {}
        for vertex in sorted(self._parent):
            found.setdefault(self._root(vertex), []).append(vertex)
        return list(found.values())

    def _root(self, vertex: int) -> int:
        while self._parent[vertex] != vertex:
            self._parent[vertex] = self._parent[self._parent[vertex]]
            vertex = self._parent[vertex]
        return vertex
