# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maps from flat blanks into space: bends, flat seats around holes, beads.

A map takes (n, 2) blank coordinates and returns (n, 3) positions, both in mm.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from shapes.curves import closed_steps

Map = Callable[[np.ndarray], np.ndarray]
STEP = 1e-4


@dataclass(frozen=True)
class Frame:
    """A plane in space: origin and two orthonormal directions; `normal` completes them."""

    origin: np.ndarray
    first: np.ndarray
    second: np.ndarray

    @property
    def normal(self) -> np.ndarray:
        return np.cross(self.first, self.second)

    def raised(self, height: float) -> Frame:
        return Frame(self.origin + height * self.normal, self.first, self.second)


@dataclass(frozen=True)
class Seat:
    """The sheet is exactly flat within `inner` mm of a blank point and free again at `outer`."""

    centre: tuple[float, float]
    inner: float
    outer: float
    frame: Frame


@dataclass(frozen=True)
class Bead:
    """A stamped bead along a segment: half widths `crest` of its flat top and `foot`."""

    start: tuple[float, float]
    end: tuple[float, float]
    crest: float
    foot: float
    height: float

    def outlines(self, spacing: float) -> tuple[np.ndarray, np.ndarray]:
        """Closed blank polylines around the foot and around the crest."""
        return self._capsule(self.foot, spacing), self._capsule(self.crest, spacing)

    def _capsule(self, radius: float, spacing: float) -> np.ndarray:
        start, end = np.asarray(self.start), np.asarray(self.end)
        along = (end - start) / np.linalg.norm(end - start)
        half = np.linspace(-np.pi / 2, np.pi / 2, 25)
        bow = np.column_stack([np.cos(half), np.sin(half)]) * radius
        axes = np.array([along, [-along[1], along[0]]])
        loop = np.vstack([end + bow @ axes, start - bow @ axes])
        return closed_steps(loop, spacing)


def tangent_frame(surface: Map, at: Sequence[float]) -> Frame:
    """The tangent plane of the surface over a blank point."""
    du, dv = _derivatives(surface, np.atleast_2d(np.asarray(at, float)))
    first = du[0] / np.linalg.norm(du[0])
    second = dv[0] - (dv[0] @ first) * first
    return Frame(surface(np.atleast_2d(at))[0], first, second / np.linalg.norm(second))


def normals(surface: Map, at: np.ndarray) -> np.ndarray:
    """(n, 3) unit normals, on the side the blank's counter-clockwise triangles face."""
    du, dv = _derivatives(surface, at)
    normal = np.cross(du, dv)
    return normal / np.linalg.norm(normal, axis=1, keepdims=True)


def with_seats(surface: Map, seats: Sequence[Seat]) -> Map:
    """The surface, flattened exactly onto each seat's plane around the seat's centre."""

    def seated(at: np.ndarray) -> np.ndarray:
        points = surface(at)
        for seat in seats:
            offset = at - np.asarray(seat.centre)
            away = np.linalg.norm(offset, axis=1)
            flat = seat.frame.origin + offset @ np.array([seat.frame.first, seat.frame.second])
            share = smooth_step((seat.outer - away) / (seat.outer - seat.inner))[:, None]
            blended = share * flat + (1 - share) * points
            points = np.where(share == 1.0, flat, blended)
        return points

    return seated


def with_beads(surface: Map, beads: Sequence[Bead]) -> Map:
    """The surface with every bead pressed out along its normal."""

    def beaded(at: np.ndarray) -> np.ndarray:
        height = np.zeros(len(at))
        for bead in beads:
            away = distance_to_segment(at, bead.start, bead.end)
            height += bead.height * smooth_step((bead.foot - away) / (bead.foot - bead.crest))
        return surface(at) + height[:, None] * normals(surface, at)

    return beaded


def distance_to_segment(at: np.ndarray, start: Sequence[float], end: Sequence[float]) -> np.ndarray:
    """(n,) distances of (n, d) points from a segment."""
    origin, span = np.asarray(start, float), np.asarray(end, float) - np.asarray(start, float)
    share = np.clip((at - origin) @ span / (span @ span), 0, 1)
    return np.linalg.norm(at - origin - share[:, None] * span, axis=1)


def smooth_step(share: np.ndarray) -> np.ndarray:
    """0 below 0, 1 above 1, with flat ends between."""
    t = np.clip(share, 0.0, 1.0)
    return t * t * (3 - 2 * t)


def _derivatives(surface: Map, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    du, dv = np.array([STEP, 0.0]), np.array([0.0, STEP])
    return (
        (surface(at + du) - surface(at - du)) / (2 * STEP),
        (surface(at + dv) - surface(at - dv)) / (2 * STEP),
    )
