# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be picked on one part, asked from the kernel: facets, faces, hole rims, pieces.

Vertices are numpy arrays of ids, ascending, each once.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cached_property

import numpy as np

from freecad.sheetmorph.tools.figures import Camera
from freecad.sheetmorph.tools.rims import Ray, Rims, extent, length

NOTHING = np.zeros(0, np.int32)


def to_ids(vertices: Iterable[int]) -> np.ndarray:
    """Vertices in any order, repeated or not, as an array of ids."""
    given = vertices if isinstance(vertices, np.ndarray) else np.array(list(vertices), np.int32)
    return np.unique(given).astype(np.int32)


def nearest_part(meshes: dict, ray: Ray) -> str:
    """The name of the PartMesh that a ray meets first, an empty string if none."""
    gaps = {name: mesh.distance(ray) for name, mesh in meshes.items()}
    nearest = min(gaps, key=gaps.get, default="")
    return nearest if gaps.get(nearest, math.inf) < math.inf else ""


def meets_box(ray: Ray, low: np.ndarray, high: np.ndarray) -> bool:
    """Whether a ray may meet what lies between two corners (3,); rounding included."""
    slack = 1e-9 * (np.abs(low) + np.abs(high) + np.abs(ray.origin) + 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = (np.stack([low - slack, high + slack]) - ray.origin) / ray.direction
    along = np.where(np.isnan(ends), 0.0, ends)  # 0 / 0: within the slab's own plane
    return bool(along.min(axis=0).max() <= along.max(axis=0).min() and along.max() >= 0.0)


class PartMesh:
    """A part as it is seen (for hits) and as it is at rest (for faces and rims)."""

    def __init__(self, core, rest: tuple, seen: np.ndarray):
        """``core``: sheetmorph._core; ``rest``: points and triangles; ``seen``: (n, 3) points."""
        self._rest, self.triangles = rest
        self._core = core
        self._seen = np.ascontiguousarray(seen, float)
        self._edges: dict[float, Rims] = {}  # of the last crease angle
        self._last: tuple = ((), NOTHING, NOTHING)  # what was asked for, its triangles, vertices

    @cached_property
    def _mesh(self):
        return self._core.TriangleMesh(np.ascontiguousarray(self._rest, float), self.triangles)

    @cached_property
    def _tree(self):
        return self._core.PickingTree(self._seen, self.triangles)

    @cached_property
    def _box(self) -> tuple[np.ndarray, np.ndarray]:
        return self._seen.min(axis=0), self._seen.max(axis=0)

    @cached_property
    def size(self) -> float:
        """The diagonal of the bounding box, mm."""
        return extent(self._seen[self.used])

    @cached_property
    def used(self) -> np.ndarray:
        """The vertices that a triangle has."""
        return np.unique(self.triangles).astype(np.int32)

    @cached_property
    def rims(self) -> Rims:
        """The closed boundaries."""
        loops = [np.asarray(loop) for loop in self._core.boundary_loops(self._mesh)]
        return Rims(loops, self._seen, self._outlines(loops, 1.0))

    def edges(self, crease: float) -> Rims:
        """The closed boundaries, and the closed edges at which the part bends by ``crease``."""
        if crease not in self._edges:
            self._edges = {crease: self._edges_at(crease)}
        return self._edges[crease]

    def prepare(self) -> None:
        """Finds beforehand what the first move of the mouse would wait for."""
        self.groups(())

    def hit(self, ray: Ray):
        """The triangle and point (3,) the ray meets first, or None."""
        found = self._nearest(ray)
        return None if found is None else (int(found.triangle), np.asarray(found.point))

    def distance(self, ray: Ray) -> float:
        """How far along a ray the part is, mm; infinite if the ray misses it."""
        found = self._nearest(ray)
        return math.inf if found is None else float(found.distance)

    def vertex(self, triangle: int, point: np.ndarray) -> np.ndarray:
        """The corner of a triangle that is nearest to a point (3,)."""
        corners = self.triangles[triangle]
        gaps = np.linalg.norm(self._seen[corners] - point, axis=1)
        return corners[[int(gaps.argmin())]]

    def facet(self, triangle: int) -> np.ndarray:
        """The vertices of one triangle."""
        return np.unique(self.triangles[triangle])

    def face(self, triangle: int, crease: float) -> np.ndarray:
        """The vertices of the face around a triangle; ``crease``: radians at which it ends."""
        key = ("face", float(crease))
        return self._remembered(key, triangle, lambda: self._near.face(triangle, key[1]))

    def piece(self, triangle: int) -> np.ndarray:
        """The vertices of the connected component of a triangle."""
        return self._remembered(("piece",), triangle, lambda: self._near.piece(triangle))

    def inside(self, camera: Camera, outline: np.ndarray, hiding=None) -> np.ndarray:
        """The vertices seen inside a closed outline, (k, 2) px.

        ``hiding``: the meshes, this one among them, that hide what lies behind them; None: all
        through the part.
        """
        screen = self._core.Screen(camera.to_clip, camera.width, camera.height)
        found = self._core.vertices_inside(self._tree, screen, outline)
        if hiding is not None:
            trees = [mesh._tree for mesh in hiding if camera.may_show(*mesh._box, outline)]
            found = self._core.visible_vertices(self._tree, found, screen, trees)
        return np.asarray(found)

    def rim(self, ray: Ray, rings: int, *, crease: float, holes_only: bool = False) -> np.ndarray:
        """The rim nearest to where the ray meets the part, with rings of vertices around it.

        A ray through an empty hole takes its rim; a ray far from every rim and part takes none.
        """
        found = self.hit(ray)
        rims = self.edges(crease)
        nearest = rims.nearest(ray, None if found is None else found[1], holes_only)
        return NOTHING if nearest is None else self.grown(nearest, rings)

    def place_on_rim(self, ray: Ray, crease: float, holes_only: bool) -> list[float] | None:
        """A place at rest (3,) on the rim that `rim` takes; None if it takes none."""
        found = self.hit(ray)
        point = None if found is None else found[1]
        loop = self.edges(crease).nearest(ray, point, holes_only)
        if loop is None:
            return None
        near = ray.origin if point is None else point
        first = int(np.linalg.norm(self._seen[loop] - near, axis=1).argmin())
        return np.asarray(self._rest[loop[first]], float).tolist()

    def places_of_holes(self) -> list[list[float]]:
        """A place at rest (3,) on the rim of every hole."""
        return [np.asarray(self._rest[loop[0]], float).tolist() for loop in self.rims.holes()]

    def place_at_rest(self, triangle: int, point: np.ndarray) -> list[float]:
        """Where a point (3,) seen on a triangle is at rest."""
        a, b, c = self._seen[self.triangles[triangle]]
        weights = np.linalg.lstsq(np.stack([b - a, c - a], axis=1), point - a, rcond=None)[0]
        corners = np.asarray(self._rest, float)[self.triangles[triangle]]
        inner = np.clip([1.0 - weights.sum(), *weights], 0.0, 1.0)
        return (inner @ corners / inner.sum()).tolist()

    def rim_at(self, vertex: int, rings: int) -> np.ndarray:
        """The closed boundary through a vertex, with rings of vertices around it.

        Raises ValueError if there is none.
        """
        return self.grown(self._core.boundary_loop_at(self._mesh, vertex), rings)

    def hole_rims(self, rings: int) -> list[np.ndarray]:
        """The rims of all holes."""
        return [self.grown(loop, rings) for loop in self.rims.holes()]

    def grown(self, vertices, rings: int = 1) -> np.ndarray:
        """The vertices and so many rings of neighbours."""
        return np.asarray(self._near.grown(to_ids(vertices), int(rings)))

    def shrunk(self, vertices, rings: int = 1) -> np.ndarray:
        """The vertices without so many outermost rings."""
        return np.asarray(self._near.shrunk(to_ids(vertices), int(rings)))

    def groups(self, vertices) -> list[np.ndarray]:
        """The connected pieces of a set of vertices, in order of their first one."""
        return [np.asarray(piece) for piece in self._near.pieces(to_ids(vertices))]

    def _nearest(self, ray: Ray):
        """The kernel's hit; the tree of a part that the mouse is never on is never built."""
        if not meets_box(ray, *self._box):
            return None
        return self._tree.nearest_hit(ray.origin, ray.direction)

    def _remembered(self, key: tuple, triangle: int, find) -> np.ndarray:
        """The vertices of the triangles that ``find()`` returns, the same array within them."""
        if key != self._last[0] or not self._last[1][triangle]:
            triangles = np.asarray(find())
            is_inside = np.zeros(len(self.triangles), bool)
            is_inside[triangles] = True
            vertices = np.asarray(self._core.vertices_of_triangles(self._mesh, triangles))
            self._last = (key, is_inside, vertices)
        return self._last[2]

    @cached_property
    def _near(self):
        return self._core.Neighbourhood(self._mesh)

    @cached_property
    def _labels(self) -> np.ndarray:
        return np.asarray(self._core.components(self._mesh))

    def _edges_at(self, crease: float) -> Rims:
        known = {tuple(np.sort(loop)) for loop in self.rims.loops}
        found = [np.asarray(loop) for loop in self._near.rims(float(crease))]
        added = [loop for loop in found if tuple(np.sort(loop)) not in known]
        first = len(self.rims.loops)
        outlines = {first + k for k in self._outlines(added, 0.9)}
        return Rims(self.rims.loops + added, self._seen, self.rims.outlines | outlines)

    def _outlines(self, loops, share: float) -> set[int]:
        """The numbers of the loops that are outlines of their connected component.

        Those are the longest one, and all of ``share`` of its length, if they span half of the
        component; a sheet whose outline ends in T-joints has holes only.
        """
        lengths = [length(self._seen[loop]) for loop in loops]
        longest: dict[int, float] = {}
        for loop, mine in zip(loops, lengths):
            component = int(self._labels[loop[0]])
            longest[component] = max(longest.get(component, 0.0), mine)
        return {
            number
            for number, (loop, mine) in enumerate(zip(loops, lengths))
            if mine >= share * longest[int(self._labels[loop[0]])] and self._is_wide(loop)
        }

    def _is_wide(self, loop) -> bool:
        component = self._labels == self._labels[loop[0]]
        return extent(self._seen[loop]) > 0.5 * extent(self._seen[component])
