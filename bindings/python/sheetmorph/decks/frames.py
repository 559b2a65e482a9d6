# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinate systems that nodes are written in: rectangular, cylindrical, spherical, in chains."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats

_SMALLEST = 1e-12
Locate = Callable[[int], Floats]


class FrameError(ValueError):
    """A coordinate system that cannot be worked out; ``frame``: its number."""

    def __init__(self, frame: int, what: str):
        super().__init__(what)
        self.frame = frame


@dataclass(frozen=True)
class Frame:
    """A coordinate system.

    kind: "R", "C" or "S"; nodes: ids of its three nodes, or None and then points: (3, 3) its
    origin, a point on its z axis and one in its xz plane, in the system `reference`; angles are
    degrees.
    """

    kind: str
    nodes: tuple[int, int, int] | None = None
    points: Floats | None = None
    reference: int = 0


class Frames:
    """The coordinate systems of a deck, with its nodes at some places.

    locate: the position (3,) in the basic system of the node with an id.
    """

    def __init__(self, frames: dict[int, Frame], locate: Locate):
        self._frames = frames
        self._locate = locate
        self._known: dict[int, tuple[Floats, Floats]] = {}
        self._open: list[int] = []

    def axes(self, number: int) -> tuple[Floats, Floats]:
        """Origin (3,) and axes (3, 3), one a row, in the basic system. Raises FrameError."""
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
        """Positions (n, 3) in the basic system of (n, 3) coordinates in a system."""
        if number == 0:
            return values
        origin, axes = self.axes(number)
        return origin + _flat(self._frames[number].kind, values) @ axes

    def from_basic(self, number: int, points: Floats, near: Floats) -> Floats:
        """Coordinates (n, 3) in a system of (n, 3) positions; angles nearest to those of `near`."""
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
        # On the axis every angle will do: the one of the file stays.
        turn = np.where(radius > 0.0, _nearest(turn, near[:, 1]), near[:, 1])
        return np.stack([radius, turn, flat[:, 2]], axis=1)
    tilt = np.degrees(np.arctan2(radius, flat[:, 2]))
    turn = np.where(radius > 0.0, _nearest(turn, near[:, 2]), near[:, 2])
    return np.stack([np.linalg.norm(flat, axis=1), tilt, turn], axis=1)


def _nearest(angle: Floats, near: Floats) -> Floats:
    found: Floats = angle + 360.0 * np.round((near - angle) / 360.0)
    return found
