# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors for volumes: box, half-space, slab, cylinder, sphere."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ..base.arrays import Floats
from .chosen import Chosen, SelectorError
from .part_shape import PartShape

# Subdivision of a triangle edge, to measure the share of the triangle inside a volume.
_CUTS = 12


def _middles() -> Floats:
    """Return barycentric coordinates (k, 3) of the centres of equal small triangles."""
    upward = [(i, j, 1 / 3) for i in range(_CUTS) for j in range(_CUTS - i)]
    downward = [(i, j, 2 / 3) for i in range(_CUTS - 1) for j in range(_CUTS - 1 - i)]
    first = np.array([((i + s) / _CUTS, (j + s) / _CUTS) for i, j, s in upward + downward])
    return np.column_stack([first, 1.0 - first.sum(axis=1)])


_SAMPLES = _middles()


def _box(points: Floats, corners: Any) -> Floats:
    ends = np.sort(np.array(corners, dtype=float), axis=0)
    found: Floats = np.maximum(ends[0] - points, points - ends[1]).max(axis=1)
    return found


def _half_space(points: Floats, told: Mapping[str, Any]) -> Floats:
    return -_height(points, told, "normal")


def _slab(points: Floats, told: Mapping[str, Any]) -> Floats:
    found: Floats = np.abs(_height(points, told, "normal")) - 0.5 * told["thickness"]
    return found


def _cylinder(points: Floats, told: Mapping[str, Any]) -> Floats:
    away = points - np.array(told["point"], dtype=float)
    along = _height(points, told, "direction")
    across = away - np.outer(along, unit(told["direction"], "direction"))
    beyond = np.linalg.norm(across, axis=1) - told["radius"]
    if "length" in told:
        beyond = np.maximum(beyond, np.maximum(-along, along - told["length"]))
    found: Floats = beyond
    return found


def _sphere(points: Floats, told: Mapping[str, Any]) -> Floats:
    found: Floats = (
        np.linalg.norm(points - np.array(told["center"], dtype=float), axis=1) - told["radius"]
    )
    return found


def _height(points: Floats, told: Mapping[str, Any], key: str) -> Floats:
    """Return the signed distances (n,) of points along a direction, mm."""
    found: Floats = (points - np.array(told["point"], dtype=float)) @ unit(told[key], key)
    return found


def unit(direction: Any, key: str) -> Floats:
    """Return the direction (3,) with length 1. Raises SelectorError if its length is zero."""
    length = float(np.linalg.norm(np.array(direction, dtype=float)))
    if not length > 1e-100:
        todo = "give it a direction, for example [0, 0, 1]"
        raise SelectorError(f"the {key} has no length", todo, (key,))
    return np.array(direction, dtype=float) / length


# Signed distance of points (n, 3) from each volume, mm, at most 0 inside.
_OUTSIDE: dict[str, Callable[[Floats, Any], Floats]] = {
    "box": _box,
    "half_space": _half_space,
    "slab": _slab,
    "cylinder": _cylinder,
    "sphere": _sphere,
}
VOLUMES = tuple(_OUTSIDE)


def within(shape: PartShape, key: str, told: Any) -> Chosen:
    """Return the vertices inside a volume, and the share of every triangle inside."""
    inside = shape.used & (_OUTSIDE[key](shape.points, told) <= shape.slack)
    share = inside[shape.triangles].mean(axis=1)
    cut = np.flatnonzero((share > 0.0) & (share < 1.0))
    corners = shape.points[shape.triangles[cut]]
    places = np.einsum("sk,tkd->tsd", _SAMPLES, corners).reshape(-1, 3)
    taken = _OUTSIDE[key](places, told) <= shape.slack
    share[cut] = taken.reshape(len(cut), len(_SAMPLES)).mean(axis=1)
    return Chosen(inside, share)
