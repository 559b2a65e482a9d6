# SPDX-License-Identifier: LGPL-2.1-or-later
"""One value a vertex while a morph moves: how far it went, how good its triangles, how open a gap.

Parts are given by name; positions are (n, 3) mm, global; a vertex without a value has NaN.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from freecad.sheetmorph.tools import colour_scale

PERFECT = 60.0  # degrees: the corners of an equilateral triangle
MOST_PLACES = 10
APART = 0.12  # of a part's size: places are at least that far from each other
NEAR = 0.25  # of a part's size: a region farther than that names no place
LEAST_STRETCH = 0.05  # percent: less is no place to look at
Positions = dict[str, np.ndarray]


class Displacement:
    """How far every vertex is from where it was at rest, mm."""

    unit, worst = "mm", "farthest"

    def __init__(self, rest: Positions):
        self._rest = rest

    def __call__(self, positions: Positions) -> Positions:
        """The values (n,) by part."""
        return {name: _lengths(positions[name] - rest) for name, rest in self._rest.items()}


class Quality:
    """The smallest corner of the triangles at every vertex, degrees: 60 is best."""

    unit, worst = "°", "sharpest corner"
    is_low_bad = True

    def __init__(self, core, triangles: dict[str, np.ndarray]):
        """``core``: sheetmorph._core; ``triangles`` (m, 3) by part."""
        self._core, self._triangles = core, triangles

    def __call__(self, positions: Positions) -> Positions:
        """The values (n,) by part."""
        return {
            name: self._core.vertex_quality(positions[name], triangles)
            for name, triangles in self._triangles.items()
        }

    @staticmethod
    def span(_extreme: float) -> tuple[float, float]:
        """The ends of its colours."""
        return 0.0, PERFECT


class Stretch:
    """By how much the sheet is stretched or pressed around every vertex at most, percent.

    Compared with the shape at rest that has the sizes of the pose: ``start_from``.
    """

    unit, worst = "%", "largest stretch"

    def __init__(self, stretches, meshes: dict[str, tuple], regions: Iterable[Region] = ()):
        """``stretches``: sheetmorph.strain.PrincipalStretches; ``meshes``: by part points (n, 3)
        at rest and triangles (m, 3)."""
        self._stretches = stretches
        self._parts = {
            name: (triangles, len(rest), *_around(triangles))
            for name, (rest, triangles) in meshes.items()
        }
        self._from: dict[str, tuple] = {}
        self.start_from({name: rest for name, (rest, _) in meshes.items()})
        self._sizes = {
            name: float(np.linalg.norm(np.ptp(rest, axis=0))) if len(rest) else 0.0
            for name, (rest, _) in meshes.items()
        }
        self._regions = tuple(regions)

    def start_from(self, rest: Positions) -> None:
        """Compare with other positions (n, 3) from now on; the same arrays cost nothing."""
        for name, points in rest.items():
            if name not in self._from or self._from[name][0] is not points:
                self._from[name] = points, self._stretches(points, self._parts[name][0])

    def __call__(self, positions: Positions) -> Positions:
        """The values (n,) by part."""
        found = {}
        for name, (_, count, vertices, order, starts) in self._parts.items():
            strain = 100.0 * np.abs(self._from[name][1](positions[name]) - 1.0).max(axis=1)
            values = np.full(count, np.nan)
            if len(order):
                values[vertices] = np.maximum.reduceat(np.nan_to_num(strain)[order], starts)
            found[name] = values
        return found

    def places(self, positions: Positions, values: Positions) -> tuple[Place, ...]:
        """Where the sheets are stretched most, the worst place first."""
        found = [
            Place(name, positions[name][k], float(values[name][k]))
            for name in values
            for k in _peaks(values[name], positions[name], APART * self._sizes[name])
        ]
        return tuple(sorted(found, key=lambda place: -place.value)[:MOST_PLACES])

    def near(self, positions: Positions, place: Place) -> str:
        """What the region of the part is called that is nearest to a place."""
        reach, label = NEAR * self._sizes[place.part], ""
        for region in self._regions:
            if region.part == place.part and len(region.vertices):
                seen = positions[place.part][region.vertices]
                distance = _lengths(seen - place.point).min()
                if distance <= reach:
                    reach, label = distance, region.label
        return label


@dataclass(frozen=True, eq=False)
class Region:
    """Vertices (k,) of a part that have a name."""

    label: str
    part: str
    vertices: np.ndarray


@dataclass(frozen=True, eq=False)
class Place:
    """A vertex of a part with one of the worst values: where it is, (3,) mm."""

    part: str
    point: np.ndarray
    value: float


def _peaks(values, points, apart: float) -> list[int]:
    """The largest values, apart from each other."""
    left = np.flatnonzero(np.nan_to_num(values) >= LEAST_STRETCH)
    found: list[int] = []
    while len(left) and len(found) < MOST_PLACES:
        worst = int(left[values[left].argmax()])
        found.append(worst)
        left = left[_lengths(points[left] - points[worst]) > apart]
    return found


def _around(triangles):
    """The vertices that triangles (m, 3) have, the triangles around one after the other, and where
    those of each begin."""
    corners = np.asarray(triangles).ravel()
    order = np.argsort(corners, kind="stable")
    vertices, starts = np.unique(corners[order], return_index=True)
    return vertices, order // 3, starts


@dataclass(frozen=True, eq=False)
class Side:
    """Vertices (k,) of a part and the part they face."""

    part: str
    vertices: np.ndarray
    other: str


class Gaps:
    """By how much the distance of the vertices of contacts to the other part has changed, mm."""

    unit, worst = "mm", "largest change"

    def __init__(self, core, meshes: dict[str, tuple], sides: Iterable[Side]):
        """``meshes``: by part points (n, 3) at rest and triangles (m, 3)."""
        self._counts = {name: len(points) for name, (points, _) in meshes.items()}
        trees = {name: core.PickingTree(*mesh) for name, mesh in meshes.items()}
        self._feet = [self._foot(trees[side.other], meshes, side) for side in sides]

    def __call__(self, positions: Positions) -> Positions:
        """The values (n,) by part."""
        found = {name: np.full(count, np.nan) for name, count in self._counts.items()}
        for side, corners, weights, gap in self._feet:
            values = np.abs(_gaps(positions, side, corners, weights) - gap)
            known = found[side.part][side.vertices]
            found[side.part][side.vertices] = np.fmax(known, values)
        return found

    @staticmethod
    def _foot(tree, meshes: dict[str, tuple], side: Side) -> tuple:
        """Where every vertex of a side touches the other part at rest, and how far that is."""
        rest = {name: points for name, (points, _) in meshes.items()}
        hits = [tree.nearest_point(point) for point in rest[side.part][side.vertices]]
        corners = meshes[side.other][1][[hit.triangle for hit in hits]]
        weights = np.array([hit.barycentric for hit in hits])
        return side, corners, weights, _gaps(rest, side, corners, weights)


def _gaps(positions: Positions, side: Side, corners, weights) -> np.ndarray:
    feet = np.einsum("kc,kcx->kx", weights, positions[side.other][corners])
    return _lengths(positions[side.part][side.vertices] - feet)


def _lengths(vectors: np.ndarray) -> np.ndarray:
    return np.sqrt(np.einsum("kx,kx->k", vectors, vectors))


@dataclass(frozen=True)
class Legend:
    """The values at the two ends of the colours, the worst value and the part it is on;
    histogram: an element_quality.Histogram where elements are measured; places: the worst; near:
    which region the first of them is near to."""

    span: tuple[float, float]
    extreme: float
    part: str
    histogram: object = None
    places: tuple[Place, ...] = ()
    near: str = ""


def legend_of(valuer, positions: Positions, values: Positions) -> Legend:
    """The legend for what one of the above answered; the part is empty if there is no value."""
    is_low_bad = getattr(valuer, "is_low_bad", False)
    known = {name: found[np.isfinite(found)] for name, found in values.items()}
    known = {name: found for name, found in known.items() if len(found)}
    if not known:
        return Legend((0.0, 1.0), 0.0, "")
    pick = (np.min, min) if is_low_bad else (np.max, max)
    extremes = {name: float(pick[0](found)) for name, found in known.items()}
    part = pick[1](extremes, key=lambda name: extremes[name])
    span = valuer.span if hasattr(valuer, "span") else _from_zero
    histogram = getattr(valuer, "histogram", None)
    places = valuer.places(positions, values) if isinstance(valuer, Stretch) else ()
    near = valuer.near(positions, places[0]) if places else ""
    return Legend(span(extremes[part]), extremes[part], part, histogram, places, near)


def _from_zero(extreme: float) -> tuple[float, float]:
    return 0.0, colour_scale.round_up(extreme)


def turn_of(rotation: np.ndarray) -> float:
    """The angle of a rotation (3, 3), degrees from 0 to 180."""
    skew = rotation - rotation.T
    sine = 0.5 * np.linalg.norm((skew[2, 1], skew[0, 2], skew[1, 0]))
    return float(np.degrees(np.arctan2(sine, 0.5 * (np.trace(rotation) - 1.0))))
