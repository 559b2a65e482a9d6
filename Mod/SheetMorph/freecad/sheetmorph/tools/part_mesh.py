# SPDX-License-Identifier: LGPL-2.1-or-later
"""The targets of a pick on one part: facets, faces, hole rims and connected pieces.

Vertices are numpy arrays of unique ids in ascending order.
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
    """Return vertices in any order, repeated or not, as an array of unique ids."""
    given = vertices if isinstance(vertices, np.ndarray) else np.array(list(vertices), np.int32)
    return np.unique(given).astype(np.int32)


def nearest_part(meshes: dict, ray: Ray) -> str:
    """Return the name of the PartMesh that a ray meets first, empty if it meets none."""
    gaps = {name: mesh.distance(ray) for name, mesh in meshes.items()}
    nearest = min(gaps, key=gaps.get, default="")
    return nearest if gaps.get(nearest, math.inf) < math.inf else ""


def meets_box(ray: Ray, low: np.ndarray, high: np.ndarray) -> bool:
    """Return whether a ray may meet the box between two corners (3,), with room for rounding."""
    slack = 1e-9 * (np.abs(low) + np.abs(high) + np.abs(ray.origin) + 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = (np.stack([low - slack, high + slack]) - ray.origin) / ray.direction
    along = np.where(np.isnan(ends), 0.0, ends)  # 0 / 0: the ray lies in the plane of a side
    return bool(along.min(axis=0).max() <= along.max(axis=0).min() and along.max() >= 0.0)


class PartMesh:
    """A part as displayed (for hits) and at rest (for faces and rims)."""

    def __init__(self, core, rest: tuple, seen: np.ndarray):
        """Wrap a part; `core` is `sheetmorph._core`, `rest` has points and triangles.

        `seen` (n, 3) are the displayed points.
        """
        self._rest, self.triangles = rest
        self._core = core
        self._seen = np.ascontiguousarray(seen, float)
        self._edges: dict[float, Rims] = {}  # of the last crease angle
        # key, triangles and vertices of the last search
        self._last: tuple = ((), NOTHING, NOTHING)

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
        """The vertices that belong to a triangle."""
        return np.unique(self.triangles).astype(np.int32)

    @cached_property
    def rims(self) -> Rims:
        """The closed boundaries."""
        loops = [np.asarray(loop) for loop in self._core.boundary_loops(self._mesh)]
        return Rims(loops, self._seen, self._outlines(loops, 1.0))

    def edges(self, crease: float) -> Rims:
        """Return the closed boundaries and the closed creases of at least the angle `crease`."""
        if crease not in self._edges:
            self._edges = {crease: self._edges_at(crease)}
        return self._edges[crease]

    def prepare(self) -> None:
        """Build the search structures, so that the first move of the mouse need not wait."""
        self.groups(())

    def hit(self, ray: Ray):
        """Return the triangle and the point (3,) that the ray meets first, or None."""
        found = self._nearest(ray)
        return None if found is None else (int(found.triangle), np.asarray(found.point))

    def distance(self, ray: Ray) -> float:
        """Return the distance of the part along a ray in mm, infinite if the ray misses it."""
        found = self._nearest(ray)
        return math.inf if found is None else float(found.distance)

    def vertex(self, triangle: int, point: np.ndarray) -> np.ndarray:
        """Return the corner of a triangle that is nearest to a point (3,)."""
        corners = self.triangles[triangle]
        gaps = np.linalg.norm(self._seen[corners] - point, axis=1)
        return corners[[int(gaps.argmin())]]

    def facet(self, triangle: int) -> np.ndarray:
        """Return the vertices of one triangle."""
        return np.unique(self.triangles[triangle])

    def face(self, triangle: int, crease: float) -> np.ndarray:
        """Return the vertices of the face around a triangle; it ends at `crease` radians."""
        key = ("face", float(crease))
        return self._remembered(key, triangle, lambda: self._near.face(triangle, key[1]))

    def piece(self, triangle: int) -> np.ndarray:
        """Return the vertices of the connected component of a triangle."""
        return self._remembered(("piece",), triangle, lambda: self._near.piece(triangle))

    def inside(self, camera: Camera, outline: np.ndarray, hiding=None) -> np.ndarray:
        """Return the vertices inside a closed outline, (k, 2) px.

        `hiding` are the meshes, this one included, that may hide a vertex; with None, hidden
        vertices count too.
        """
        screen = self._core.Screen(camera.to_clip, camera.width, camera.height)
        found = self._core.vertices_inside(self._tree, screen, outline)
        if hiding is not None:
            trees = [mesh._tree for mesh in hiding if camera.may_show(*mesh._box, outline)]
            found = self._core.visible_vertices(self._tree, found, screen, trees)
        return np.asarray(found)

    def rim(self, ray: Ray, rings: int, *, crease: float, holes_only: bool = False) -> np.ndarray:
        """Return the rim nearest to where the ray meets the part, with `rings` around it.

        A ray through an empty hole finds the rim of that hole. A ray far from every rim and from
        the part finds none.
        """
        found = self.hit(ray)
        rims = self.edges(crease)
        nearest = rims.nearest(ray, None if found is None else found[1], holes_only)
        return NOTHING if nearest is None else self.grown(nearest, rings)

    def place_on_rim(self, ray: Ray, crease: float, holes_only: bool) -> list[float] | None:
        """Return a point at rest (3,) on the rim that `rim` finds, None without one."""
        found = self.hit(ray)
        point = None if found is None else found[1]
        loop = self.edges(crease).nearest(ray, point, holes_only)
        if loop is None:
            return None
        near = ray.origin if point is None else point
        first = int(np.linalg.norm(self._seen[loop] - near, axis=1).argmin())
        return np.asarray(self._rest[loop[first]], float).tolist()

    def places_of_holes(self) -> list[list[float]]:
        """Return a point at rest (3,) on the rim of every hole."""
        return [np.asarray(self._rest[loop[0]], float).tolist() for loop in self.rims.holes()]

    def place_at_rest(self, triangle: int, point: np.ndarray) -> list[float]:
        """Return the position at rest of a displayed point (3,) on a triangle."""
        a, b, c = self._seen[self.triangles[triangle]]
        weights = np.linalg.lstsq(np.stack([b - a, c - a], axis=1), point - a, rcond=None)[0]
        corners = np.asarray(self._rest, float)[self.triangles[triangle]]
        inner = np.clip([1.0 - weights.sum(), *weights], 0.0, 1.0)
        return (inner @ corners / inner.sum()).tolist()

    def rim_at(self, vertex: int, rings: int) -> np.ndarray:
        """Return the closed boundary through a vertex with rings of vertices around it.

        Raises ValueError if no boundary passes through the vertex.
        """
        return self.grown(self._core.boundary_loop_at(self._mesh, vertex), rings)

    def hole_rims(self, rings: int) -> list[np.ndarray]:
        """Return the rims of all holes."""
        return [self.grown(loop, rings) for loop in self.rims.holes()]

    def grown(self, vertices, rings: int = 1) -> np.ndarray:
        """Return the vertices with `rings` rings of neighbours."""
        return np.asarray(self._near.grown(to_ids(vertices), int(rings)))

    def shrunk(self, vertices, rings: int = 1) -> np.ndarray:
        """Return the vertices without their `rings` outermost rings."""
        return np.asarray(self._near.shrunk(to_ids(vertices), int(rings)))

    def groups(self, vertices) -> list[np.ndarray]:
        """Return the connected pieces of a set of vertices, in the order of their first one."""
        return [np.asarray(piece) for piece in self._near.pieces(to_ids(vertices))]

    def _nearest(self, ray: Ray):
        """Return the kernel's hit; parts that no ray comes near build no search tree."""
        if not meets_box(ray, *self._box):
            return None
        return self._tree.nearest_hit(ray.origin, ray.direction)

    def _remembered(self, key: tuple, triangle: int, find) -> np.ndarray:
        """Return the vertices of the triangles that `find()` returns.

        The same search from one of these triangles returns the same array.
        """
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
        """Return the numbers of the loops that are outlines of their connected component.

        These are the longest loop and all loops of at least `share` of its length, if they span
        half of the component. A sheet whose outline ends in T-joints has holes only.
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
