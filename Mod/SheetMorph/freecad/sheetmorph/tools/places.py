# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that move with the material of parts: found near the mouse, and measured."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

VERTEX = QT_TRANSLATE_NOOP("SheetMorph_panels", "Vertex")
MIDPOINT = QT_TRANSLATE_NOOP("SheetMorph_panels", "Mid-point")
SURFACE = "surface"

REACH = 12.0  # px around the mouse in which a vertex or mid-point attracts
_CANDIDATES = np.array(
    [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.5, 0], [0, 0.5, 0.5], [0.5, 0, 0.5]], float
)


@dataclass(frozen=True, eq=False)
class Place:
    """A point that moves with the material: weights (3,) of the vertices (3,) of a triangle."""

    part: str
    vertices: np.ndarray
    weights: np.ndarray
    kind: str

    def at(self, points: np.ndarray) -> np.ndarray:
        """Return the position (3,) for positions (n, 3) of the part."""
        return self.weights @ points[self.vertices]

    def is_on(self, meshes: dict) -> bool:
        """Return whether meshes still have this part and its vertices."""
        return self.part in meshes and self.vertices.max() < len(meshes[self.part][0])


def place_near(part: str, mesh: tuple, hit, away: Callable) -> Place:
    """Return the vertex or mid-point of the triangle that a ray has hit, else the hit itself.

    `mesh` has points (n, 3) and triangles (m, 3). `away(points)` returns the distances of points
    (k, 3) from the mouse, px; the mouse has a reach of REACH.
    """
    points, triangles = mesh
    vertices = np.asarray(triangles[hit.triangle])
    gaps = away(_CANDIDATES @ points[vertices])
    nearest = int(gaps.argmin())
    if gaps[nearest] > REACH:
        return Place(part, vertices, np.asarray(hit.barycentric), SURFACE)
    return Place(part, vertices, _CANDIDATES[nearest], VERTEX if nearest < 3 else MIDPOINT)


@dataclass(frozen=True)
class Distance:
    """The distance between two places at rest and now, mm."""

    rest: float
    now: float

    @property
    def change(self) -> float:
        """The change since rest, mm."""
        return self.now - self.rest


def distance(places, rest: dict, now: dict) -> Distance:
    """Return the distance of two places on meshes, by part, at rest and now."""
    rest_ends, ends = ([one.at(mesh[one.part][0]) for one in places] for mesh in (rest, now))
    return Distance(*(float(np.linalg.norm(b - a)) for a, b in (rest_ends, ends)))
