# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every part of a CAD model bent and twisted by a tenth of its size, its holes and washers held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

SHARE = 0.1  # of its size that a part is bent and twisted by
LARGEST_TWIST = 0.3  # radians, of slender parts
REACH = 2.0  # radii beyond the rim of a hole where nothing of it is felt any more


@dataclass(frozen=True)
class Bending:
    """Bends along the longest axis of a part, and twists about it.

    centre: (3,) mm; axes: (3, 3) rows, the longest first; length, lift: mm; twist: radians, from
    the middle to an end.
    """

    centre: np.ndarray
    axes: np.ndarray
    length: float
    lift: float
    twist: float

    @classmethod
    def of(cls, points: np.ndarray) -> Bending:
        """The bending of a part with (n, 3) points."""
        extent = np.ptp(points, axis=0)
        order = np.argsort(-extent, kind="stable")
        size, half = float(np.linalg.norm(extent)), 0.5 * float(extent[order[1]])
        centre = 0.5 * (points.max(axis=0) + points.min(axis=0))
        twist = min(LARGEST_TWIST, SHARE * size / max(half, 1e-9 * size))
        return cls(centre, np.eye(3)[order], float(extent[order[0]]), SHARE * size, twist)

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """Where (n, 3) points go: along an arc whose ends are lifted, sections turned."""
        along, across, up = ((points - self.centre) @ self.axes.T).T
        turn = self.twist * 2.0 * along / self.length
        across, up = (
            across * np.cos(turn) - up * np.sin(turn),
            across * np.sin(turn) + up * np.cos(turn),
        )
        # An arc whose ends stand `lift` above its middle: radius (1 - cos) = lift.
        half = 0.5 * self.length
        bend = 2.0 * np.arctan(self.lift / half)
        radius = half / bend
        angle = along / radius
        along, up = (radius - up) * np.sin(angle), radius - (radius - up) * np.cos(angle)
        return self.centre + np.stack([along, across, up], axis=1) @ self.axes

    def rigid_at(self, place: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Where a rigid body that goes along with a place takes (n, 3) points."""
        step = 1e-4 * self.length
        ends = self(place + step * np.vstack([np.eye(3), -np.eye(3)]))
        left, _, right = np.linalg.svd((ends[:3] - ends[3:]).T / (2.0 * step))
        turn = left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right
        return self(place[None])[0] + (points - place) @ turn.T


def bent(part: Any, washer: float = 0.0, held: str = "round hole") -> np.ndarray:
    """(n, 3) positions of a CadPart, bent and twisted; its round holes go as rigid bodies.

    washer: how many radii around a hole go with it. What lies near a hole passes over from its
    motion to that of the part. held: the kind of features that are held in place of round holes.
    """
    points = np.array(part.points)
    bending = Bending.of(points)
    positions, nearest = bending(points), np.full(len(points), np.inf)
    for hole in part.features():
        if hole.kind != held:
            continue
        away = points - hole.center
        beside = away - np.outer(away @ hole.axis, hole.axis)
        along = np.maximum(np.abs(away @ hole.axis) - 0.5 * hole.length, 0.0)
        distance = np.hypot(np.linalg.norm(beside, axis=1) - hole.radius, along)
        far = np.maximum(distance / hole.radius - washer, 0.0) / REACH
        far[np.isin(np.arange(len(points)), hole.vertices)] = 0.0
        far[distance < 1e-9] = 0.0
        chosen = (far < 1.0) & (far < nearest)
        nearest[chosen] = far[chosen]
        share = (1.0 - far[chosen] ** 2)[:, None] ** 2
        rigid = bending.rigid_at(hole.center, points[chosen])
        positions[chosen] = share * rigid + (1.0 - share) * bending(points[chosen])
    return positions
