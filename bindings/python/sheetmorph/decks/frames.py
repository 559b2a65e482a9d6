# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinate systems of nodes: rectangular, cylindrical, spherical, and nested."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..base.arrays import Floats
from ..base.errors import InputError

_SMALLEST = 1e-12
Locate = Callable[[int], Floats]


class FrameError(InputError):
    """A coordinate system that cannot be computed; ``frame`` is its number."""

    def __init__(self, frame: int, what: str):
        super().__init__(what, "correct the coordinate system")
        self.frame = frame


@dataclass(frozen=True)
class Frame:
    """A coordinate system.

    kind is "R", "C" or "S". It is defined by the ids of three nodes, or by points (3, 3) in the
    system `reference`: the origin, a point on the z axis and one in the xz plane. Angles are in
    degrees.
    """

    kind: str
    nodes: tuple[int, int, int] | None = None
    points: Floats | None = None
    reference: int = 0


class Frames:
    """The coordinate systems of a deck for given node positions.

    locate returns the position (3,) of a node in the basic system, by its id.
    """

    def __init__(self, frames: dict[int, Frame], locate: Locate):
        self._frames = frames
        self._locate = locate
        self._known: dict[int, tuple[Floats, Floats]] = {}
        self._open: list[int] = []

    def axes(self, number: int) -> tuple[Floats, Floats]:
        """Return origin (3,) and axes (3, 3), as rows, in the basic system. Raises FrameError."""
        if number == 0:
            return np.zeros(3), np.eye(3)
        if number not in self._known:
            if number in self._open:
                raise FrameError(number, f"coordinate system {number} is defined by itself")
            if number not in self._frames:
                raise FrameError(number, f"there is no coordinate system {number}")
            if len(self._open) > 200:
                raise FrameError(number, f"coordinate system {number} ends a chain of over 200")
            self._open.append(number)
            try:
                self._known[number] = _axes_of(number, self._points(self._frames[number]))
            finally:
                self._open.pop()
        return self._known[number]

    def _points(self, frame: Frame) -> Floats:
        if frame.nodes is not None:
            return np.array([self._locate(node) for node in frame.nodes])
        assert frame.points is not None
        return self.to_basic(frame.reference, frame.points)

    def to_basic(self, number: int, values: Floats) -> Floats:
        """Convert coordinates (n, 3) in a system to positions (n, 3) in the basic system."""
        if number == 0:
            return values
        origin, axes = self.axes(number)
        return origin + _flat(self._frames[number].kind, values) @ axes

    def from_basic(self, number: int, points: Floats, near: Floats) -> Floats:
        """Convert positions (n, 3) to coordinates (n, 3) in a system.

        Angles are chosen closest to those of `near`.
        """
        if number == 0:
            return points
        origin, axes = self.axes(number)
        return _round(self._frames[number].kind, (points - origin) @ axes.T, near)


def _axes_of(number: int, points: Floats) -> tuple[Floats, Floats]:
    origin, z, x = points[0], points[1] - points[0], points[2] - points[0]
    length = np.linalg.norm(z)
    y = np.cross(z, x)
    if not length > 0.0 or not np.linalg.norm(y) > _SMALLEST * length * np.linalg.norm(x):
        what = f"the three points of coordinate system {number} lie on a line"
        raise FrameError(number, what)
    z = z / length
    y = y / np.linalg.norm(y)
    return origin, np.array([np.cross(y, z), y, z])


def _flat(kind: str, values: Floats) -> Floats:
    if kind == "R":
        return values
    if kind == "C":
        angle = np.radians(values[:, 1])
        radius = values[:, 0]
        return np.stack([radius * np.cos(angle), radius * np.sin(angle), values[:, 2]], axis=1)
    tilt, turn = np.radians(values[:, 1]), np.radians(values[:, 2])
    across = values[:, 0] * np.sin(tilt)
    parts = [across * np.cos(turn), across * np.sin(turn), values[:, 0] * np.cos(tilt)]
    return np.stack(parts, axis=1)


def _round(kind: str, flat: Floats, near: Floats) -> Floats:
    if kind == "R":
        return flat
    radius = np.hypot(flat[:, 0], flat[:, 1])
    turn = np.degrees(np.arctan2(flat[:, 1], flat[:, 0]))
    if kind == "C":
        # On the axis the angle is arbitrary, so the one in the file stays.
        turn = np.where(radius > 0.0, _nearest(turn, near[:, 1]), near[:, 1])
        return np.stack([radius, turn, flat[:, 2]], axis=1)
    tilt = np.degrees(np.arctan2(radius, flat[:, 2]))
    turn = np.where(radius > 0.0, _nearest(turn, near[:, 2]), near[:, 2])
    return np.stack([np.linalg.norm(flat, axis=1), tilt, turn], axis=1)


def _nearest(angle: Floats, near: Floats) -> Floats:
    found: Floats = angle + 360.0 * np.round((near - angle) / 360.0)
    return found
