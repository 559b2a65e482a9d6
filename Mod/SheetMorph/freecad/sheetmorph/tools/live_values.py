# SPDX-License-Identifier: LGPL-2.1-or-later
"""One value per vertex during a motion, such as displacement, element quality or gap.

Dictionaries have the part name as key. Positions are (n, 3) mm, global. A vertex without a value
has NaN.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from freecad.sheetmorph.tools import colour_scale
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

PERFECT = 60.0  # degrees: the corners of an equilateral triangle
MOST_PLACES = 10
APART = 0.12  # of the part's size: least distance between two places
NEAR = 0.25  # of the part's size: largest distance at which a region names a place
LEAST_STRETCH = 0.05  # percent: a smaller value marks no place
Positions = dict[str, np.ndarray]


class Displacement:
    """The distance of every vertex from its position at rest, mm."""

    unit, worst = "mm", QT_TRANSLATE_NOOP("SheetMorph_panels", "largest displacement")

    def __init__(self, rest: Positions):
        self._rest = rest

    def __call__(self, positions: Positions) -> Positions:
        """Return the values (n,) by part."""
        return {name: _lengths(positions[name] - rest) for name, rest in self._rest.items()}


class Quality:
    """The smallest corner of the triangles at every vertex, degrees; 60 is best."""

    unit, worst = "°", QT_TRANSLATE_NOOP("SheetMorph_panels", "smallest corner")
    is_low_bad = True

    def __init__(self, core, triangles: dict[str, np.ndarray]):
        """Prepare the measure; `core` is `sheetmorph._core`, `triangles` are (m, 3) by part."""
        self._core, self._triangles = core, triangles

    def __call__(self, positions: Positions) -> Positions:
        """Return the values (n,) by part."""
        return {
            name: self._core.vertex_quality(positions[name], triangles)
            for name, triangles in self._triangles.items()
        }

    @staticmethod
    def span(_extreme: float) -> tuple[float, float]:
        """Return the ends of the colours."""
        return 0.0, PERFECT


class Stretch:
    """The largest stretch or compression of the sheet around every vertex, percent.

    The reference is the shape at rest with the sizes of the pose, see `start_from`.
    """

    unit, worst = "%", QT_TRANSLATE_NOOP("SheetMorph_panels", "largest stretch")

    def __init__(self, stretches, meshes: dict[str, tuple], regions: Iterable[Region] = ()):
        """Prepare the measure for parts at rest.

        `stretches` is `PrincipalStretches` of `sheetmorph.measuring.strain`. `meshes` maps part
        names to points at rest (n, 3) and triangles (m, 3).
        """
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
        """Set the reference positions (n, 3); passing the same arrays again costs nothing."""
        for name, points in rest.items():
            if name not in self._from or self._from[name][0] is not points:
                self._from[name] = points, self._stretches(points, self._parts[name][0])

    def __call__(self, positions: Positions) -> Positions:
        """Return the values (n,) by part."""
        found = {}
        for name, (_, count, vertices, order, starts) in self._parts.items():
            strain = 100.0 * np.abs(self._from[name][1](positions[name]) - 1.0).max(axis=1)
            values = np.full(count, np.nan)
            if len(order):
                values[vertices] = np.maximum.reduceat(np.nan_to_num(strain)[order], starts)
            found[name] = values
        return found

    def places(self, positions: Positions, values: Positions) -> tuple[Place, ...]:
        """Return the places of largest stretch, the worst first."""
        found = [
            Place(name, positions[name][k], float(values[name][k]))
            for name in values
            for k in _peaks(values[name], positions[name], APART * self._sizes[name])
        ]
        return tuple(sorted(found, key=lambda place: -place.value)[:MOST_PLACES])

    def near(self, positions: Positions, place: Place) -> str:
        """Return the label of the part's region nearest to a place, empty if none is near."""
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
    """Named vertices (k,) of a part."""

    label: str
    part: str
    vertices: np.ndarray


@dataclass(frozen=True, eq=False)
class Place:
    """A vertex of a part with one of the worst values, and its position (3,) mm."""

    part: str
    point: np.ndarray
    value: float


def _peaks(values, points, apart: float) -> list[int]:
    """Return the vertices of the largest values, at least `apart` from each other."""
    left = np.flatnonzero(np.nan_to_num(values) >= LEAST_STRETCH)
    found: list[int] = []
    while len(left) and len(found) < MOST_PLACES:
        worst = int(left[values[left].argmax()])
        found.append(worst)
        left = left[_lengths(points[left] - points[worst]) > apart]
    return found


def _around(triangles):
    """Return the vertices of triangles (m, 3), and the triangles around each of them.

    The triangles of all vertices are in one array; a third array has the start of each vertex.
    """
    corners = np.asarray(triangles).ravel()
    order = np.argsort(corners, kind="stable")
    vertices, starts = np.unique(corners[order], return_index=True)
    return vertices, order // 3, starts


@dataclass(frozen=True, eq=False)
class Side:
    """Vertices (k,) of a part and the name of the part that they face."""

    part: str
    vertices: np.ndarray
    other: str


class Gaps:
    """The change of the distance from the vertices of contacts to the other part, mm."""

    unit, worst = "mm", QT_TRANSLATE_NOOP("SheetMorph_panels", "largest change")

    def __init__(self, core, meshes: dict[str, tuple], sides: Iterable[Side]):
        """Measure the gaps at rest; `meshes` has points (n, 3) and triangles (m, 3) by part."""
        self._counts = {name: len(points) for name, (points, _) in meshes.items()}
        trees = {name: core.PickingTree(*mesh) for name, mesh in meshes.items()}
        self._feet = [self._foot(trees[side.other], meshes, side) for side in sides]

    def __call__(self, positions: Positions) -> Positions:
        """Return the values (n,) by part."""
        found = {name: np.full(count, np.nan) for name, count in self._counts.items()}
        for side, corners, weights, gap in self._feet:
            values = np.abs(_gaps(positions, side, corners, weights) - gap)
            known = found[side.part][side.vertices]
            found[side.part][side.vertices] = np.fmax(known, values)
        return found

    @staticmethod
    def _foot(tree, meshes: dict[str, tuple], side: Side) -> tuple:
        """Return the foot points of a side's vertices on the other part at rest, and the gaps."""
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
    """The values at both ends of the colours, the worst value and its part.

    `histogram` is an `element_quality.Histogram` where elements are measured. `places` are the
    worst places. `near` is the label of the region near the first place.
    """

    span: tuple[float, float]
    extreme: float
    part: str
    histogram: object = None
    places: tuple[Place, ...] = ()
    near: str = ""


def legend_of(valuer, positions: Positions, values: Positions) -> Legend:
    """Return the legend for the values of a measure; its part is empty without any value."""
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
    """Return the angle of a rotation (3, 3), degrees from 0 to 180."""
    skew = rotation - rotation.T
    sine = 0.5 * np.linalg.norm((skew[2, 1], skew[0, 2], skew[1, 0]))
    return float(np.degrees(np.arctan2(sine, 0.5 * (np.trace(rotation) - 1.0))))
