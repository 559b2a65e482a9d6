# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliding of nodes in their sheet until its elements meet limits; the connectivity stays.

Every free node tries a few positions around it in its tangent plane. It moves to the one where the
adjacent elements exceed the limits least, projected to the sheet. Nodes without a common element
move at the same time.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.kernel import load_kernel
from ..measuring.quality import MEASURES, areas

# Elements must clear a limit by this share of it, so that a move of a neighbour does not break it
# again. The first and the smallest step of a node are shares of its shortest edge.
_ROOM, _FIRST, _LEAST = 0.1, 0.25, 1e-3
_ROUNDS, _AROUND, _TURNED = 60, 2, 1e6
_DIRECTIONS = np.array([[np.cos(a), np.sin(a)] for a in np.arange(8) * np.pi / 4])


@dataclass(frozen=True)
class Slid:
    """The slid sheet.

    places is (n, 3). failing counts the elements before and after. rounds is the number of
    iterations. off_sheet is the largest distance of the centre of a changed element from the
    original sheet, mm.
    """

    places: Floats
    failing: tuple[int, int]
    rounds: int
    off_sheet: float


class Sliding:
    """A sheet with positions (n, 3) and faces (m, 4), the last corner -1 for triangles.

    Nodes slide in the triangles (t, 3). stays (n,) marks the nodes that do not slide. limits maps a
    measure to "min" or "max".
    """

    def __init__(
        self,
        places: Floats,
        triangles: Ints,
        faces: Ints,
        stays: Bools,
        limits: Mapping[str, Mapping[str, float]],
    ):
        self._rest, self._triangles = places, triangles
        self._places = self._rest.copy()
        self._faces, self._stays, self._limits = faces.astype(np.int64), stays, limits
        self._tree = load_kernel().PickingTree(np.ascontiguousarray(self._rest), self._triangles)
        self._around, self._starts = _elements_of(self._faces, len(self._rest))
        self._normals = _face_normals(self._rest, self._faces)
        self._step = _FIRST * _shortest_edges(self._rest, self._faces)
        self._least = _LEAST / _FIRST * self._step

    def slid(self) -> Slid:
        """Slide the nodes until no element fails or no node improves."""
        before = int(self._fails(np.arange(len(self._faces))).sum())
        rounds = 0
        while rounds < _ROUNDS:
            nodes = self._nodes_near(np.flatnonzero(self._fails(np.arange(len(self._faces)))))
            nodes = nodes[self._step[nodes] > self._least[nodes]]
            if not len(nodes):
                break
            rounds += 1
            for some in self._apart(nodes):
                self._go(some)
        after = int(self._fails(np.arange(len(self._faces))).sum())
        return Slid(self._places, (before, after), rounds, self._off_sheet())

    def _fails(self, elements: Ints) -> Bools:
        corners = self._places[np.maximum(self._faces[elements], 0)]
        return _missed(corners, self._faces[elements, 3] >= 0, self._limits, 0.0) > 0.0

    def _nodes_near(self, elements: Ints) -> Ints:
        """Return the free nodes of some elements and of the elements around them."""
        # The last entry absorbs the corner -1 of triangles.
        is_near = np.zeros(len(self._rest) + 1, dtype=bool)
        is_near[self._faces[elements]] = True
        for _ in range(_AROUND):
            is_near[-1] = False
            is_near[self._faces[is_near[self._faces].any(axis=1)]] = True
        return np.flatnonzero(is_near[:-1] & ~self._stays)

    def _apart(self, nodes: Ints) -> list[Ints]:
        """Split the nodes into groups without two nodes of one element."""
        groups, left = [], nodes
        order = np.random.default_rng(1).permutation(len(self._rest) + 1)
        while len(left):
            rank = np.full(len(self._rest) + 1, -1)
            rank[left] = order[left]
            rank[-1] = -1
            best = rank[self._faces].max(axis=1)
            rows, valid = self._rows(left)
            first = (~valid | (best[rows] == rank[left][:, None])).all(axis=1)
            groups.append(left[first])
            left = left[~first]
        return groups

    def _rows(self, nodes: Ints) -> tuple[Ints, Bools]:
        """Return the elements (k, d) of nodes, and which entries are valid."""
        counts = self._starts[nodes + 1] - self._starts[nodes]
        columns = np.arange(max(1, int(counts.max(initial=1))))
        valid = columns < counts[:, None]
        rows = self._around[np.where(valid, self._starts[nodes][:, None] + columns, 0)]
        return rows, valid

    def _go(self, nodes: Ints) -> None:
        """Move every node to the best of its trial positions if that improves its elements."""
        rows, valid = self._rows(nodes)
        here = self._places[nodes][:, None]
        now = self._missed_around(nodes, rows, valid, here)[:, 0]
        is_bad = now > 0.0
        nodes, rows, valid, now = nodes[is_bad], rows[is_bad], valid[is_bad], now[is_bad]
        if not len(nodes):
            return
        trials = self._trials(nodes, rows, valid)
        chosen = self._missed_around(nodes, rows, valid, trials).argmin(axis=1)
        targets = self._laid_back(trials[np.arange(len(nodes)), chosen], self._step[nodes])
        found = self._missed_around(nodes, rows, valid, targets[:, None])[:, 0]
        is_better = found < now * (1.0 - 1e-9)
        self._places[nodes[is_better]] = targets[is_better]
        self._step[nodes[~is_better]] *= 0.5

    def _trials(self, nodes: Ints, rows: Ints, valid: Bools) -> Floats:
        """Return trial positions (k, 9, 3): eight directions and the centre of the elements."""
        normal = (self._normals[rows] * valid[:, :, None]).sum(axis=1)
        one = np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)])
        one /= np.maximum(np.linalg.norm(one, axis=1, keepdims=True), 1e-300)
        two = np.cross(normal, one)
        two /= np.maximum(np.linalg.norm(two, axis=1, keepdims=True), 1e-300)
        here, step = self._places[nodes], self._step[nodes][:, None, None]
        ways = _DIRECTIONS[:, :1] * one[:, None] + _DIRECTIONS[:, 1:] * two[:, None]
        corners = self._faces[rows]
        there = (corners >= 0) & valid[:, :, None]
        sums = (self._places[np.maximum(corners, 0)] * there[..., None]).sum(axis=(1, 2))
        middle = sums / there.sum(axis=(1, 2))[:, None] - here
        long = np.linalg.norm(middle, axis=1, keepdims=True)
        middle *= np.minimum(1.0, step[:, 0] / np.maximum(long, 1e-300))
        found: Floats = here[:, None] + np.concatenate([step * ways, middle[:, None]], axis=1)
        return found

    def _missed_around(self, nodes: Ints, rows: Ints, valid: Bools, trials: Floats) -> Floats:
        """Return how far the elements around nodes exceed the limits (k, t) at trials (k, t, 3)."""
        faces = self._faces[rows]
        corners = self._places[np.maximum(faces, 0)]
        own = (faces == nodes[:, None, None])[:, None, ..., None]
        corners = np.where(own, trials[:, :, None, None], corners[:, None])
        quads = np.broadcast_to((faces[..., 3] >= 0)[:, None], corners.shape[:3])
        flat = corners.reshape(-1, 4, 3)
        missed = _missed(flat, quads.reshape(-1), self._limits, _ROOM)
        normals = np.broadcast_to(self._normals[rows][:, None], corners.shape[:3] + (3,))
        turned = (_vector_areas(flat, quads.reshape(-1)) * normals.reshape(-1, 3)).sum(axis=1) <= 0
        found = (missed + _TURNED * turned).reshape(corners.shape[:3])
        result: Floats = np.where(valid[:, None], found, 0.0).sum(axis=2)
        return result

    def _laid_back(self, places: Floats, reach: Floats) -> Floats:
        """Return the nearest points (k, 3) of the sheet; more distant points stay unchanged."""
        found = places.copy()
        for k, hit in enumerate(map(self._tree.nearest_point, places)):
            if hit is not None and hit.distance <= reach[k]:
                corners = self._rest[self._triangles[hit.triangle]]
                found[k] = np.asarray(hit.barycentric) @ corners
        return found

    def _off_sheet(self) -> float:
        changed = (self._places != self._rest).any(axis=1)
        faces = self._faces[changed[np.maximum(self._faces, 0)].any(axis=1)]
        there = (faces >= 0)[..., None]
        sums = (self._places[np.maximum(faces, 0)] * there).sum(axis=1)
        hits = map(self._tree.nearest_point, sums / there.sum(axis=1))
        return max((float(hit.distance) for hit in hits if hit is not None), default=0.0)


def _missed(
    corners: Floats,
    is_quad: Bools,
    limits: Mapping[str, Mapping[str, float]],
    room: float,
) -> Floats:
    """Return the squared excess (m,) of elements (m, 4, 3) over limits tightened by a share."""
    found = np.zeros(len(corners))
    for rows, count in ((is_quad, 4), (~is_quad, 3)):
        some = corners[rows, :count]
        if not len(some):
            continue
        missed = np.zeros(len(some))
        for name, limit in limits.items():
            values = MEASURES[name](some)
            for key, sign in (("max", 1.0), ("min", -1.0)):
                if key in limit:
                    scale = abs(limit[key]) or 1.0
                    over = sign * (values - limit[key]) / scale + room
                    missed += np.maximum(over, 0.0) ** 2
        found[rows] = missed
    return found


def _vector_areas(corners: Floats, is_quad: Bools) -> Floats:
    last = np.where(is_quad[:, None], corners[:, 3], corners[:, 0])
    found: Floats = np.cross(corners[:, 2] - corners[:, 0], last - corners[:, 1])
    return found


def _face_normals(places: Floats, faces: Ints) -> Floats:
    found = _vector_areas(places[np.maximum(faces, 0)], faces[:, 3] >= 0)
    result: Floats = found / np.maximum(np.linalg.norm(found, axis=1, keepdims=True), 1e-300)
    return result


def _elements_of(faces: Ints, count: int) -> tuple[Ints, Ints]:
    """Return the elements of all nodes in one array, and the start index of each node."""
    rows, columns = np.nonzero(faces >= 0)
    nodes = faces[rows, columns]
    order = np.argsort(nodes, kind="stable")
    starts = np.searchsorted(nodes[order], np.arange(count + 1))
    return rows[order], starts


def _shortest_edges(places: Floats, faces: Ints) -> Floats:
    """Return the shortest edge (n,) at every node, mm; 0 at nodes without an element."""
    last = np.where(faces[:, 3] >= 0, faces[:, 3], faces[:, 0])
    ring = np.concatenate([faces[:, :3], last[:, None]], axis=1)
    found = np.full(len(places), np.inf)
    for k in range(4):
        one, other = ring[:, k], ring[:, (k + 1) % 4]
        long = np.linalg.norm(places[one] - places[other], axis=1)
        long[long == 0.0] = np.inf
        for nodes in (one, other):
            np.minimum.at(found, nodes, long)
    return np.where(np.isfinite(found), found, 0.0)


def borders_and_creases(places: Floats, faces: Ints, angle: float) -> Bools:
    """Return the nodes (n,) on border edges, on non-manifold edges and on creases.

    A crease is an edge where two elements meet at more than the angle, degrees. Nodes of degenerate
    elements are included.
    """
    corners = faces.astype(np.int64)
    is_quad = corners[:, 3] >= 0
    last = np.where(is_quad, corners[:, 3], corners[:, 0])
    ring = np.concatenate([corners[:, :3], last[:, None]], axis=1)
    ends = np.sort(np.stack([ring, np.roll(ring, -1, axis=1)], axis=2), axis=2).reshape(-1, 2)
    owner = np.repeat(np.arange(len(corners)), 4)
    real = ends[:, 0] != ends[:, 1]
    ends, owner = ends[real], owner[real]
    edges, inverse, counts = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    inverse = inverse.ravel()
    is_kept = counts != 2
    order = np.argsort(inverse, kind="stable")
    pairs = owner[order][np.isin(inverse[order], np.flatnonzero(~is_kept))].reshape(-1, 2)
    normals = _face_normals(places, corners)
    cosine = np.abs((normals[pairs[:, 0]] * normals[pairs[:, 1]]).sum(axis=1))
    is_kept[~is_kept] = cosine < np.cos(np.radians(angle))
    found = np.zeros(len(places), dtype=bool)
    found[edges[is_kept]] = True
    flat = np.where(is_quad, areas(places[np.maximum(corners, 0)]), 1.0) <= 0.0
    found[corners[flat, :3]] = True
    return found
