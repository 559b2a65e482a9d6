# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bends of a sheet: location, angle, and length of the neutral fibre."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.errors import FileError
from ..files.reading import read_bytes

if TYPE_CHECKING:
    from .. import _core

# Inner radius over thickness, and K-factor: the position of the neutral fibre in the thickness,
# from the inside.
_USUAL = ((0.0, 0.33), (1.0, 0.38), (3.0, 0.43), (10.0, 0.5))
_SHARP = math.radians(20.0)  # sharper edges are folds without a radius
_STRAIGHT = 0.98  # smallest cosine between two edges of one fold


@dataclass(frozen=True)
class KTable:
    """K-factors by inner radius over thickness, linear in between and constant outside.

    rows has (ratio, K) with ascending ratios.
    """

    rows: tuple[tuple[float, float], ...] = _USUAL

    @classmethod
    def read(cls, path: str | Path) -> KTable:
        """Read a text file with a ratio and a K-factor per line. Raises FileError, OSError."""
        place, rows = Path(path), []
        for number, line in enumerate(
            read_bytes(place).decode("utf-8-sig", "replace").splitlines(), 1
        ):
            words = line.split("#")[0].replace(",", " ").split()
            if words:
                rows.append(_row(place, number, words))
        if not rows or any(a[0] >= b[0] for a, b in zip(rows, rows[1:])):
            todo = "give one R/T ratio and K-factor per line, with rising ratios"
            raise FileError(place, "it is not a table of K-factors", todo)
        return cls(tuple(rows))

    def at(self, ratio: float) -> float:
        """Return the K-factor for a ratio of inner radius to thickness."""
        ratios, factors = zip(*self.rows)
        return float(np.interp(ratio, ratios, factors))


def _row(place: Path, number: int, words: list[str]) -> tuple[float, float]:
    try:
        ratio, factor = (float(word) for word in words)
        if ratio >= 0.0 and 0.0 < factor < 1.0:
            return ratio, factor
    except ValueError:
        pass
    what = f'"{" ".join(words)[:40]}" is not a row of a table of K-factors'
    todo = "write a ratio R/T of 0 or more and a K-factor between 0 and 1"
    raise FileError(place, what, todo, number)


@dataclass(frozen=True, eq=False)
class Bend:
    """A bend of a sheet.

    Attributes
    ----------
    angle : float
        Bend angle, radians.
    radius : float
        Radius of the given sheet, mm; 0 for a sharp fold.
    is_up : bool
        Whether it bends towards the side of the normals.
    direction : array (3,)
        Unit vector along the bend.
    vertices : array (k,)
        Vertex indices.
    triangles : array (j,)
        Triangle indices.
    inner, k_factor, allowance : float or None
        Inner radius, mm, K-factor, and length of the neutral fibre, mm; None without a thickness.
    """

    angle: float
    radius: float
    is_up: bool
    direction: Floats
    vertices: Ints
    triangles: Ints
    inner: float | None = None
    k_factor: float | None = None
    allowance: float | None = None

    @property
    def factor(self) -> float:
        """Length of the neutral fibre relative to the given sheet."""
        if self.allowance is None or not self.radius:
            return 1.0
        return self.allowance / (self.angle * self.radius)


def find_bends(
    core: ModuleType, mesh: _core.TriangleMesh, thickness: float | None, table: KTable
) -> list[Bend]:
    """Return the bends of a kernel mesh, rounded ones first; thickness is in mm."""
    points, triangles = np.asarray(mesh.points), np.asarray(mesh.triangles)
    normals = _normals(points, triangles)
    found, taken = [], np.zeros(len(triangles), bool)
    for feature in core.find_features(mesh):
        if feature.kind != "bend":
            continue
        is_in = np.zeros(len(points), bool)
        is_in[feature.vertices] = True
        own = np.flatnonzero(is_in[triangles].all(axis=1) & ~taken)
        if not len(own):
            continue
        taken[own] = True
        axis, near = np.asarray(feature.axis), _beside(triangles, own)
        # The adjacent row of triangles may cross the end of the bend, but the next one is flat.
        far = _beside(triangles, np.union1d(own, near))
        angles = [_turn(normals[own], normals[sides], axis) for sides in (far, near)]
        angle = next((a for a in angles if a is not None), float(feature.angle))
        is_up = _bends_up(points[triangles[own]].mean(axis=1), normals[own], axis)
        bend = Bend(angle, float(feature.radius), is_up, axis, np.unique(triangles[own]), own)
        found.append(_with_allowance(bend, thickness, table))
    return [*found, *_folds(points, triangles, normals, taken)]


def _with_allowance(bend: Bend, thickness: float | None, table: KTable) -> Bend:
    if not thickness:
        return bend
    inner = max(bend.radius - 0.5 * thickness, 0.0)
    k_factor = table.at(inner / thickness)
    told = inner, k_factor, bend.angle * (inner + k_factor * thickness)
    return Bend(
        bend.angle, bend.radius, bend.is_up, bend.direction, bend.vertices, bend.triangles, *told
    )


def _beside(triangles: Ints, own: Ints) -> Ints:
    """Return the triangles that touch the given ones but are not among them."""
    touched = np.flatnonzero(np.isin(triangles, triangles[own]).any(axis=1))
    return np.setdiff1d(touched, own)


def _turn(normals: Floats, beside: Floats, axis: Floats) -> float | None:
    """Return the angle between the flats beside a bend, radians; None if it ends on one side."""
    middle = normals.mean(axis=0)
    middle -= axis * (middle @ axis)
    across = np.cross(axis, middle)
    angles = np.arctan2(beside @ across, beside @ middle)
    ends = angles[angles > 0.0], angles[angles < 0.0]
    if not all(map(len, ends)):
        return None
    return float(np.median(ends[0]) - np.median(ends[1]))


def _bends_up(centres: Floats, normals: Floats, axis: Floats) -> bool:
    """Return whether the normals of a cylinder converge, so that it curves to their side."""
    across = np.cross(axis, normals.mean(axis=0))
    shift = (centres - centres.mean(axis=0)) @ across
    turn = (normals - normals.mean(axis=0)) @ across
    return bool(shift @ turn < 0.0)


def _normals(points: Floats, triangles: Ints) -> Floats:
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    found: Floats = normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    return found


def _folds(points: Floats, triangles: Ints, normals: Floats, taken: Bools) -> Iterator[Bend]:
    """Yield straight rows of edges at which the sheet bends sharply."""
    sides = np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owner = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort(np.sort(sides, axis=1).T)
    edges, owner, sides = np.sort(sides, axis=1)[order], owner[order], sides[order]
    pairs = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    one, other = owner[pairs], owner[pairs + 1]
    along = points[sides[pairs, 1]] - points[sides[pairs, 0]]
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]
    sine = np.einsum("ij,ij->i", np.cross(normals[one], normals[other]), along)
    angle = np.arctan2(sine, np.einsum("ij,ij->i", normals[one], normals[other]))
    sharp = np.flatnonzero((np.abs(angle) > _SHARP) & ~(taken[one] | taken[other]))
    for row in _rows(edges[pairs[sharp]], along[sharp], np.sign(angle[sharp])):
        k = sharp[row]
        yield Bend(
            angle=float(np.abs(angle[k]).mean()),
            radius=0.0,
            is_up=bool(angle[k].mean() < 0.0),
            direction=along[k[0]],
            vertices=np.unique(edges[pairs[k]]),
            triangles=np.zeros(0, int),
        )


def _rows(edges: Ints, along: Floats, sign: Floats) -> list[Ints]:
    """Return indices of edges that continue each other straight and bend to the same side."""
    at_vertex: dict[int, list[int]] = {}
    for k, (a, b) in enumerate(edges.tolist()):
        at_vertex.setdefault(a, []).append(k)
        at_vertex.setdefault(b, []).append(k)
    row_of = np.full(len(edges), -1)
    rows: list[Ints] = []
    for start in range(len(edges)):
        if row_of[start] >= 0:
            continue
        row_of[start], members, left = len(rows), [start], [start]
        while left:
            k = left.pop()
            for near in {j for vertex in edges[k].tolist() for j in at_vertex[vertex]}:
                is_on = abs(along[near] @ along[k]) > _STRAIGHT and sign[near] == sign[k]
                if row_of[near] < 0 and is_on:
                    row_of[near] = len(rows)
                    members.append(near)
                    left.append(near)
        rows.append(np.array(members))
    return rows
