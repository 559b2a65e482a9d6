# SPDX-License-Identifier: LGPL-2.1-or-later
"""Worst stretch and fold of a mesh, computed from positions only."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.blocks import in_blocks
from ..base.part_mesh import PartMesh

# As a share of the size: shorter edges have no meaningful relative change.
_NO_LENGTH = 1e-12
# A triangle whose height is below this share of its longest edge counts as degenerate.
_NO_HEIGHT = 1e-5
# An edge below this share of its rest length has collapsed.
COLLAPSED = 0.1


@dataclass(frozen=True)
class Edge:
    """A mesh edge: its lengths at rest and deformed, mm, and its deformed midpoint (3,)."""

    before: float
    after: float
    place: Floats

    @property
    def strain(self) -> float:
        """Absolute change of length, relative to the rest length."""
        return abs(self.after / self.before - 1.0)


class EdgeChanges:
    """Changes of edge lengths and dihedral angles; the rest values are computed once.

    rest is (n, 3) and triangles (m, 3).
    """

    def __init__(self, rest: Floats, triangles: Ints):
        edges, self._sides = _edges(triangles)
        lengths = _lengths(rest, edges)
        has_length = lengths > _NO_LENGTH * np.ptp(rest, axis=0).max(initial=0.0)
        self._triangles = triangles
        self._edges, self._lengths = edges[has_length], lengths[has_length]
        self._angles = _angles(rest, triangles, self._sides)

    def worst(self, positions: Floats, rest: Floats | None = None) -> Edge | None:
        """Return the edge with the largest strain at positions (n, 3), or None without edges.

        A rest shape (n, 3) replaces the one of the constructor.
        """
        before = None if rest is None else np.maximum(_lengths(rest, self._edges), 1e-300)
        return self._edge(positions, lambda ratio: int(np.abs(ratio - 1.0).argmax()), before)

    def shortest(self, positions: Floats) -> Edge | None:
        """Return the edge with the smallest ratio to its rest length at (n, 3), or None."""
        return self._edge(positions, lambda ratio: int(ratio.argmin()))

    def collapsed(self, positions: Floats) -> int:
        """Count the edges below a tenth of their rest length at positions (n, 3)."""
        return int((_lengths(positions, self._edges) < COLLAPSED * self._lengths).sum())

    def _edge(
        self, positions: Floats, choose: Callable[[Floats], int], before: Floats | None = None
    ) -> Edge | None:
        if not len(self._edges):
            return None
        before = self._lengths if before is None else before
        lengths = _lengths(positions, self._edges)
        k = choose(lengths / before)
        place = positions[self._edges[k]].mean(axis=0)
        return Edge(float(before[k]), float(lengths[k]), place)

    def worst_fold(self, positions: Floats) -> float | None:
        """Return the largest change of a dihedral angle at positions (n, 3), degrees, or None."""
        change = np.abs(_angles(positions, self._triangles, self._sides) - self._angles)
        change = change[np.isfinite(change)]
        return float(np.degrees(change.max())) if len(change) else None


def crushed(mesh: PartMesh, positions: Floats) -> Ints:
    """Return the triangles (k,) that became degenerate: height below 1e-5 of the longest edge."""
    before, after = (
        _relative_heights(points, mesh.triangles) for points in (mesh.points, positions)
    )
    found: Ints = np.flatnonzero((after <= _NO_HEIGHT) & (before > _NO_HEIGHT))
    return found


def _relative_heights(points: Floats, triangles: Ints) -> Floats:
    """Return the smallest height of each triangle (m,) over its longest edge."""
    sides = [_lengths(points, triangles[:, [k, (k + 1) % 3]]) for k in range(3)]
    longest = np.maximum.reduce(sides) if len(triangles) else np.empty(0)
    found: Floats = 2.0 * areas(points, triangles) / np.maximum(longest, 1e-300) ** 2
    return found


def _lengths(points: Floats, edges: Ints) -> Floats:
    def of(part: slice) -> Floats:
        found: Floats = np.linalg.norm(points[edges[part, 0]] - points[edges[part, 1]], axis=1)
        return found

    return in_blocks(of, len(edges))


def middle_edge(points: Floats, triangles: Ints) -> float:
    """Return the median edge length of triangles (m, 3), 0 if there are none.

    Inner edges count twice.
    """
    lengths = [_lengths(points, triangles[:, [k, (k + 1) % 3]]) for k in range(3)]
    found = np.concatenate(lengths)
    return float(np.median(found, overwrite_input=True)) if len(found) else 0.0


def _edges(triangles: Ints) -> tuple[Ints, tuple[Ints, Ints]]:
    """Return sorted unique edges (e, 2), and pairs of triangles (k,), (k,) that share one."""
    count, size = len(triangles), int(triangles.max(initial=0)) + 1
    keys = np.empty(3 * count, dtype=np.int64)
    for k in range(3):
        one, other = triangles[:, k], triangles[:, (k + 1) % 3]
        low, high = np.minimum(one, other), np.maximum(one, other)
        keys[k * count : (k + 1) * count] = high.astype(np.int64) * size + low
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    owner = (order % max(count, 1)).astype(np.int32)
    is_next = keys[1:] == keys[:-1]
    pairs = np.flatnonzero(is_next)
    keys = keys[np.concatenate([np.ones(min(1, len(keys)), bool), ~is_next])]
    edges = np.stack([keys % size, keys // size], axis=1).astype(np.int32)
    return edges, (owner[pairs], owner[pairs + 1])


def _angles(points: Floats, triangles: Ints, sides: tuple[Ints, Ints]) -> Floats:
    """Return the angles (k,) between pairs of triangles; NaN if one has no area."""
    normals = _area_normals(points, triangles)
    with np.errstate(all="ignore"):
        normals /= np.linalg.norm(normals, axis=1)[:, None]

    def of(part: slice) -> Floats:
        a, b = normals[sides[0][part]], normals[sides[1][part]]
        across: Floats = np.linalg.norm(np.cross(a, b), axis=1)
        return np.arctan2(across, np.einsum("ij,ij->i", a, b))

    return in_blocks(of, len(sides[0]))


def principal_stretches(
    rest: Floats,
    positions: Floats,
    triangles: Ints,
    wanted: tuple[Floats, Floats] | None = None,
) -> Floats:
    """Return the principal stretches (m, 2) of each triangle, the larger one first.

    They are the singular values of the deformation gradient, 1 at rest. Triangles that are
    degenerate at rest give NaN, because rounding dominates their shape. rest and positions are (n,
    3), triangles (m, 3). wanted has unit directions (m, 3) and factors (m,): lengthening by a
    factor along its direction does not count as stretch.
    """

    def of(part: slice) -> Floats:
        told = None if wanted is None else (wanted[0][part], wanted[1][part])
        return PrincipalStretches(rest, triangles[part], told)(positions)

    return in_blocks(of, len(triangles))


class PrincipalStretches:
    """principal_stretches() for many positions of one mesh; the rest shape is evaluated once."""

    def __init__(
        self,
        rest: Floats,
        triangles: Ints,
        wanted: tuple[Floats, Floats] | None = None,
    ):
        gradients, axes = _shape_gradients(rest, triangles)
        if wanted is not None:
            along = np.einsum("mik,mk->mi", axes, wanted[0])
            shorter = (1.0 / np.asarray(wanted[1]) - 1.0)[:, None, None]
            gradients = gradients @ (np.eye(2) + shorter * along[:, :, None] * along[:, None, :])
        gradients[_relative_heights(rest, triangles) <= _NO_HEIGHT] = np.nan
        self._triangles = np.asarray(triangles)
        # The gradients of the three corners sum to zero, so two edges define the deformation.
        with np.errstate(all="ignore"):
            (a, b), (c, d) = gradients[:, 1].T, gradients[:, 2].T
            self._metric = (
                (a * a, 2.0 * a * c, c * c),
                (a * b, a * d + b * c, c * d),
                (b * b, 2.0 * b * d, d * d),
            )

    def __call__(self, positions: Floats) -> Floats:
        """Return the stretches (m, 2) at positions (n, 3)."""
        first, second, third = (positions[corners] for corners in self._triangles.T)
        one, other = second - first, third - first
        pairs = ((one, one), (one, other), (other, other))
        dots = [np.einsum("mk,mk->m", a, b) for a, b in pairs]
        with np.errstate(all="ignore"):
            xx, xy, yy = (sum(map(np.multiply, row, dots)) for row in self._metric)
            mean, half = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), xy)
            squares = np.column_stack([mean + half, mean - half])
            found: Floats = np.sqrt(np.maximum(squares, 0.0))
            return found


def curvature_changes(rest: Floats, positions: Floats, triangles: Ints) -> Floats:
    """Return the change of curvature (m, 2, 2) of each triangle in its rest plane, 1/mm.

    Triangles without area at rest give NaN. rest and positions are (n, 3), mm; triangles is (m, 3).
    The curvature comes from vertex normals (Rusinkiewicz 2004).
    """
    before, after = (_vertex_normals(points, triangles) for points in (rest, positions))

    def of(part: slice) -> Floats:
        corners = triangles[part]
        gradients, _ = _shape_gradients(rest, corners)
        with np.errstate(all="ignore"):
            now = _curvatures(positions, after, corners, gradients)
            return now - _curvatures(rest, before, corners, gradients)

    return in_blocks(of, len(triangles))


def arcs(points: Floats, triangles: Ints) -> tuple[Floats, Ints]:
    """Return directions of largest curvature (m, 3), and bend angles (m,) along them, rad.

    The angle is the rotation of the normal within the triangle, 0 if it has no area. points is (n,
    3), mm; triangles is (m, 3).
    """
    gradients, axes = _shape_gradients(points, triangles)
    with np.errstate(all="ignore"):
        normals = _vertex_normals(points, triangles)
        form = np.nan_to_num(_curvatures(points, normals, triangles, gradients))
    values, vectors = np.linalg.eigh(form)
    most = np.abs(values).argmax(axis=1)
    rows = np.arange(len(triangles))
    directions = np.einsum("mi,mik->mk", vectors[rows, :, most], np.nan_to_num(axes))
    along = np.einsum("mik,mk->mi", points[triangles], directions)
    return directions, np.abs(values[rows, most]) * np.ptp(along, axis=1)


def areas(points: Floats, triangles: Ints) -> Floats:
    """Return the areas (m,) in mm^2 of triangles (m, 3) over points (n, 3), mm."""
    found: Floats = 0.5 * np.linalg.norm(_area_normals(points, triangles), axis=1)
    return found


def _area_normals(points: Floats, triangles: Ints) -> Floats:
    def of(part: slice) -> Floats:
        first, second, third = (points[corner] for corner in triangles[part].T)
        found: Floats = np.cross(second - first, third - first)
        return found

    return in_blocks(of, len(triangles))


def _vertex_normals(points: Floats, triangles: Ints) -> Floats:
    """Return unit vertex normals (n, 3); 0 for a vertex without a triangle of non-zero area."""
    normals, at = _area_normals(points, triangles), triangles.T.ravel()
    sums = [np.bincount(at, np.tile(axis, 3), len(points)) for axis in normals.T]
    found: Floats = np.stack(sums, axis=1)
    found /= np.maximum(np.linalg.norm(found, axis=1), 1e-300)[:, None]
    return found


def _shape_gradients(rest: Floats, triangles: Ints) -> tuple[Floats, Floats]:
    """Return shape function gradients (m, 3, 2) in the rest plane, and its axes (m, 2, 3)."""
    corners = rest[triangles]
    normals = _area_normals(rest, triangles)
    with np.errstate(all="ignore"):
        doubled = np.linalg.norm(normals, axis=1)
        x = corners[:, 1] - corners[:, 0]
        x = x / np.linalg.norm(x, axis=1)[:, None]
        axes = np.stack([x, np.cross(normals / doubled[:, None], x)], axis=1)
        opposite = np.roll(corners, 1, axis=1) - np.roll(corners, -1, axis=1)
        turned = np.cross(normals[:, None, :], opposite) / (doubled**2)[:, None, None]
        return np.einsum("mik,mjk->mij", turned, axes), axes


def _curvatures(points: Floats, normals: Floats, triangles: Ints, gradients: Floats) -> Floats:
    """Return the negative second fundamental form (m, 2, 2) from normals (n, 3) of the points."""
    along = np.einsum("mik,mil->mkl", points[triangles], gradients)
    turning = np.einsum("mik,mil->mkl", normals[triangles], gradients)
    form = np.einsum("mki,mkj->mij", along, turning)
    found: Floats = 0.5 * (form + form.transpose(0, 2, 1))
    return found
