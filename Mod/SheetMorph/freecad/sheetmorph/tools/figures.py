# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed figures on the screen, (k, 2) px each, and the camera under which they were drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

Place = tuple[float, float]  # px from the lower left corner of the view

BRUSH, RECTANGLE, LASSO = "brush", "rectangle", "lasso"
DRAWN = (BRUSH, RECTANGLE, LASSO)
SIDES = 32  # of the polygon that stands for a circle
NEAREST = 2.0  # px between the corners of a lasso
STRIDE = 0.25  # of the radius, between two stored places of a brush stroke
SMALLEST, LARGEST, STEP = 4.0, 400.0, 1.15  # px, and the factor of one wheel step on the radius


@dataclass(frozen=True)
class Camera:
    """The projection (4, 4) from global mm to clip coordinates, and the view's size in px."""

    to_clip: np.ndarray
    width: float
    height: float

    @classmethod
    def of_view(cls, view: Sequence[float], points: np.ndarray) -> Camera:
        """Return the camera of a `view`, with depths for points (n, 3) mm."""
        rows = np.reshape(view, (-1, 4)).astype(float)
        if len(rows) == 2:
            back = np.cross(*rows[:, :3])
            depths = -points @ back
            reach = max(np.ptp(depths), 1e-9)
            rows = np.vstack([rows, [*-back / reach, -depths.mean() / reach], [0.0, 0.0, 0.0, 1.0]])
        else:
            depths = points @ rows[2, :3] + rows[2, 3]
            near = 0.5 * depths.min(initial=1e9, where=depths > 0.0)
            rows = np.vstack([rows[:2], rows[2] - [0.0, 0.0, 0.0, 2.0 * near], rows[2]])
        rows[:2] -= rows[3]
        return cls(rows, 2.0, 2.0)

    @property
    def view(self) -> list[float]:
        """The rows (4,) of `to_pixels` that give px, and the divisor unless it is 1."""
        rows = self.to_pixels
        return rows[[0, 1, 3] if rows[3, :3].any() else [0, 1]].ravel().tolist()

    @property
    def to_pixels(self) -> np.ndarray:
        """The matrix (4, 4) to px from the lower left corner, depth and divisor."""
        found = self.to_clip.astype(float)
        found[0] = 0.5 * self.width * (found[0] + found[3])
        found[1] = 0.5 * self.height * (found[1] + found[3])
        return found

    def pixels(self, points) -> np.ndarray:
        """Return px (x, y) from the lower left corner and the depth of points (n, 3) mm."""
        places = np.asarray(points, float).reshape(-1, 3)
        found = np.column_stack([places, np.ones(len(places))]) @ self.to_pixels.T
        return found[:, :3] / found[:, 3:]

    def away(self, points, place) -> np.ndarray:
        """Return the distances (n,) px of points (n, 3) mm from a place (2,) px."""
        return np.linalg.norm(self.pixels(points)[:, :2] - np.asarray(place, float), axis=1)

    def line(self, x: float, y: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the ends (3,) mm of the line of sight through a pixel, within the view."""
        place = (2.0 * x / self.width - 1.0, 2.0 * y / self.height - 1.0)
        ends = np.linalg.solve(self.to_clip, np.array([(*place, z, 1.0) for z in (-1.0, 1.0)]).T)
        near, far = (ends[:3] / ends[3]).T
        return near, far

    def may_show(self, low: np.ndarray, high: np.ndarray, outline: np.ndarray) -> bool:
        """Return whether a box between corners (3,) may be visible around a figure (k, 2) px."""
        choice = np.array([[k & 1, k & 2, k & 4] for k in range(8)], bool)
        corners = np.column_stack([np.where(choice, high, low), np.ones(8)]) @ self.to_clip.T
        if (corners[:, 3] <= 0.0).any():
            return True  # at least partly behind the eye
        places = 0.5 * (1.0 + corners[:, :2] / corners[:, 3:]) * (self.width, self.height)
        below, above = (places.min(axis=0) - 1.0, places.max(axis=0) + 1.0)  # 1 px for rounding
        return bool((below <= outline.max(axis=0)).all() and (above >= outline.min(axis=0)).all())


def circle(centre: Place, radius: float) -> np.ndarray:
    """Return a circle as a polygon."""
    return swept(centre, centre, radius)


def swept(start: Place, end: Place, radius: float) -> np.ndarray:
    """Return the outline of the area that a circle covers from one place to another."""
    along = math.atan2(end[1] - start[1], end[0] - start[0])
    half = np.linspace(-math.pi / 2, math.pi / 2, SIDES // 2 + 1)
    angles = np.concatenate([along + half, along + math.pi + half])
    centres = np.concatenate([np.tile(end, (len(half), 1)), np.tile(start, (len(half), 1))])
    return centres + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def rectangle(one: Place, other: Place) -> np.ndarray:
    """Return the rectangle between two opposite corners."""
    (left, low), (right, high) = one, other
    return np.array([[left, low], [right, low], [right, high], [left, high]], dtype=float)


def lasso(places: Sequence[Place]) -> np.ndarray:
    """Return the figure through the places, without those too near to the previous one."""
    kept = [places[0]]
    for place in places[1:]:
        if math.dist(place, kept[-1]) >= NEAREST:
            kept.append(place)
    return np.array(kept, dtype=float)


def outlines(figure) -> list[np.ndarray]:
    """Return the outlines that a `sentences.DrawnFigure` covers, in the order of drawing."""
    places = [tuple(place) for place in figure.places]
    if figure.tool == BRUSH:
        strokes = zip(places, places[1:])
        first = circle(places[0], figure.radius)
        return [first, *(swept(start, end, figure.radius) for start, end in strokes)]
    if figure.tool == RECTANGLE:
        return [rectangle(places[0], places[-1])]
    if figure.tool != LASSO:
        raise ValueError(f"A figure is a {', '.join(DRAWN)}, not a {figure.tool}.")
    return [lasso(places)]


def number(value: float) -> float:
    """Return a whole number as int, another one as float."""
    return int(value) if float(value).is_integer() else float(value)


def resized(radius: float, steps: float) -> float:
    """Return the radius of the brush (px) after a number of wheel steps."""
    return min(max(radius * STEP**steps, SMALLEST), LARGEST)


class Drawing:
    """The figure that the mouse draws while its button is down."""

    def __init__(self, tool: str, start: Place, radius: float = 0.0):
        """Start a figure at a place; `tool` is BRUSH with a `radius`, RECTANGLE or LASSO."""
        self._tool, self._radius = tool, radius
        self._places = [start]
        self._last = start  # the present place of the mouse, of which a brush stores only some

    def go_to(self, place: Place) -> np.ndarray:
        """Continue to a place; return the new area of a brush stroke, else the figure so far."""
        self._last = place
        if self._tool != BRUSH:
            self._places.append(place)
            return self.outline()
        last = self._places[-1]
        if math.dist(place, last) < STRIDE * self._radius:
            return circle(last, self._radius)
        self._places.append(place)
        return swept(last, place, self._radius)

    def rest(self) -> np.ndarray | None:
        """Return the last area of a brush stroke when the button is released, None if empty."""
        last = self._places[-1]
        if self._tool != BRUSH or self._last == last:
            return None
        self._places.append(self._last)
        return swept(last, self._last, self._radius)

    @property
    def places(self) -> list[list[float]]:
        """The places that define the figure."""
        kept = self._places
        if self._tool == RECTANGLE:
            kept = [kept[0], kept[-1]]
        elif self._tool == LASSO:
            kept = lasso(kept).tolist()
        return [[number(x), number(y)] for x, y in kept]

    def outline(self) -> np.ndarray:
        """Return the figure so far; for a brush, the circle at its present place."""
        if self._tool == BRUSH:
            return circle(self._last, self._radius)
        if self._tool == RECTANGLE:
            return rectangle(self._places[0], self._places[-1])
        return lasso(self._places)

    @property
    def has_extent(self) -> bool:
        """Whether the figure is more than a click; a brush accepts clicks too."""
        extent = np.ptp(np.array(self._places), axis=0)
        return self._tool == BRUSH or bool((extent > 2 * NEAREST).any())
