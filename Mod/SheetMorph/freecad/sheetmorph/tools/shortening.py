# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawn figures with fewer places that select the same vertices."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from freecad.sheetmorph.tools.figures import BRUSH, LASSO, Camera, number
from freecad.sheetmorph.tools.sentences import tool_of, view_of

BESIDE = 0.01
"""The distance (px) from an edge within which a vertex may count as either side."""


def shortened(where: Any, points: np.ndarray, away: float) -> Any:
    """Return a selector whose figures have fewer places, at most `away` px from the drawn line.

    `points` (n, 3) are the vertices of the part. A lasso keeps each of them on the same side.
    """
    if isinstance(where, list):
        return [shortened(one, points, away) for one in where]
    if not isinstance(where, dict):
        return where
    found = {key: value if key == "drawn" else shortened(value, points, away)
             for key, value in where.items()}  # fmt: skip
    if "drawn" in where and away > 0.0:
        told = where["drawn"]
        tool = tool_of(told)
        places = np.array(told[tool], float).reshape(-1, 2)
        if tool == BRUSH:
            places = places[straightened(places, away)]
        elif tool == LASSO and len(places) > 3:
            places = places[corners(places, seen(view_of(told), points), away)]
        found["drawn"] = {**told, tool: [number(value) for value in places.ravel().tolist()]}
    return found


def seen(view: list, points: np.ndarray) -> np.ndarray:
    """Return the screen positions (k, 2) px of the points (n, 3) in front of the eye."""
    camera = Camera.of_view(view, points).to_pixels
    found = points @ camera[:, :3].T + camera[:, 3]
    found = found[found[:, 3] > 0.0]
    return found[:, :2] / found[:, 3:]


def straightened(line: np.ndarray, away: float) -> list[int]:
    """Return the numbers of the points to keep of a line (k, 2), both ends included.

    No other point is farther than `away` from the line through the kept ones.
    """
    kept, end = [0], 1
    while end < len(line):
        if farthest(line, kept[-1], end) > away:
            kept.append(end - 1)
        else:
            end += 1
    return [*kept, len(line) - 1] if len(line) > 1 else kept


def farthest(line: np.ndarray, first: int, last: int) -> float:
    """Return the largest distance from the points between two of a line (k, 2) to their chord."""
    start, along = line[first], line[last] - line[first]
    between = line[first : last + 1] - start
    share = np.clip(between @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return float(np.linalg.norm(between - share[:, None] * along, axis=1).max())


def corners(line: np.ndarray, points: np.ndarray, away: float) -> list[int]:
    """Return the numbers of the corners to keep of a closed line (k, 2), px.

    The smallest corners go first. A corner stays if the line would otherwise pass a point (n, 2) on
    its other side, or deviate by more than `away`.
    """
    kept = list(range(len(line)))
    if (line[0] == line[-1]).all():
        kept.pop()  # a closed line repeats its first place
    held: set[int] = set()
    while len(kept) > 3:
        places = line[kept]
        sizes = np.abs(turn(places[:-2], places[1:-1], places[2:]))
        sizes[[k for k, place in enumerate(kept[1:-1]) if place in held]] = np.inf
        k = int(sizes.argmin()) + 1
        if np.isinf(sizes[k - 1]):
            break
        first, last = kept[k - 1], kept[k + 1]
        if farthest(line, first, last) > away or any_inside(places[k - 1 : k + 2], points):
            held.add(kept[k])
            continue
        held -= {first, last}
        kept.pop(k)
    return kept


def turn(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> Any:
    """Return twice the signed area of triangles on the screen, positive for a left turn."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (
        c[..., 0] - a[..., 0]
    )


def any_inside(triangle: np.ndarray, points: np.ndarray) -> bool:
    """Return whether a point (n, 2) is in a triangle (3, 2) or within BESIDE of its edges."""
    low, high = triangle.min(axis=0) - BESIDE, triangle.max(axis=0) + BESIDE
    near = points[((points >= low) & (points <= high)).all(axis=1)]
    a, b, c = triangle
    ways = ((a, b), (b, c), (c, a))
    sides = np.array([turn(p, q, near) / max(math.dist(p, q), BESIDE) for p, q in ways])
    return bool(((sides >= -BESIDE).all(axis=0) | (sides <= BESIDE).all(axis=0)).any())
