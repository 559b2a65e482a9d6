# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed loops of vertices, and the search for the loop under a ray."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

OUTLINE_REACH = 0.05  # of the outline's size: how far beside the part a click still picks it


@dataclass(frozen=True)
class Ray:
    """A line of sight, global mm; the direction has any length."""

    origin: np.ndarray
    direction: np.ndarray


class Rims:
    """The closed loops of one part as ordered vertex ids; `outlines` are not holes."""

    def __init__(self, loops: list[np.ndarray], points: np.ndarray, outlines: set[int]):
        """Create the loops; `points` (n, 3) are in mm, `outlines` are numbers of loops."""
        self.loops, self.outlines = loops, outlines
        self._starts = np.cumsum([0] + [len(loop) for loop in loops])[:-1]
        self._points = points[np.concatenate([np.zeros(0, int), *loops]).astype(int)]
        self._sizes = np.array([len(loop) for loop in loops])
        self._reach = np.array(
            [
                extent(points[loop]) * (OUTLINE_REACH if k in outlines else 0.5)
                for k, loop in enumerate(loops)
            ]
        )

    def holes(self) -> list[np.ndarray]:
        """Return the loops that are not outlines."""
        return [loop for k, loop in enumerate(self.loops) if k not in self.outlines]

    def nearest(self, ray: Ray, hit, holes_only: bool):
        """Return the loop nearest to the point `hit` (3,) of the part, else to the ray.

        A ray beside the part finds a hole that it passes through, or an outline that it passes
        near, or None.
        """
        allowed = [k for k in range(len(self.loops)) if not (holes_only and k in self.outlines)]
        if not allowed:
            return None
        gaps = self._points - (ray.origin if hit is None else hit)
        if hit is None:
            along = ray.direction / np.linalg.norm(ray.direction)
            gaps = gaps - np.outer(gaps @ along, along)
        gaps = np.minimum.reduceat(np.linalg.norm(gaps, axis=1), self._starts)
        best = min(allowed, key=lambda k: (gaps[k], self._sizes[k]))
        is_far = hit is None and gaps[best] > self._reach[best]
        return None if is_far else self.loops[best]


def extent(points: np.ndarray) -> float:
    """Return the diagonal of the bounding box of points (k, 3), mm."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def length(points: np.ndarray) -> float:
    """Return the length of the closed line through points (k, 3), mm."""
    return float(np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1).sum())
