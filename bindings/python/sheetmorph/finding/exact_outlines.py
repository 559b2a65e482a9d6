# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact slots and rectangles through a solid, from the CAD surfaces of their walls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Entry = dict[str, Any]
OUTLINES = ("slotted hole", "rectangular hole")
_NEARLY_ALL = 0.9
_SAME = 1e-7  # relative difference of equal numbers in a file


def exact_outline(entry: Entry, exact: Sequence[Entry]) -> Entry:
    """Return a slot or rectangle found on a mesh, with the exact values of its walls.

    The walls must be the two half cylinders of a slot, or the four quarter cylinders or four planes
    of a rectangle; otherwise the entry is unchanged.
    """
    inside = frozenset(entry["vertices"])
    walls = [
        known
        for known in exact
        if len(inside.intersection(known["vertices"])) >= _NEARLY_ALL * len(known["vertices"])
    ]
    rounds = [wall for wall in walls if wall["kind"] == "cylinder" and wall["hollow"]]
    planes = [wall for wall in walls if wall["kind"] == "plane"]
    if len(rounds) in (2, 4) and _are_alike(rounds):
        numbers = _of_cylinders(rounds)
    elif not rounds and len(planes) == 4:
        numbers = _of_planes(planes)
    else:
        numbers = None
    return entry if numbers is None else _placed(entry, numbers, walls)


def _are_alike(rounds: Sequence[Entry]) -> bool:
    first, *others = rounds
    return all(
        abs(one["radius"] - first["radius"]) <= _SAME * first["radius"]
        and np.linalg.norm(np.cross(one["axis"], first["axis"])) <= _SAME
        for one in others
    )


def _of_cylinders(rounds: Sequence[Entry]) -> Entry | None:
    """Return the values of a slot from two cylinders, or of a rounded rectangle from four."""
    axis, radius = np.array(rounds[0]["axis"]), float(rounds[0]["radius"])
    off = np.array([wall["center"] for wall in rounds]) - rounds[0]["center"]
    spans = off - np.outer(off @ axis, axis)
    sides = sorted(np.linalg.norm(spans[1:], axis=1).tolist())
    if len(rounds) == 4 and abs(np.hypot(*sides[:2]) - sides[2]) > _SAME * sides[2]:
        return None  # not a rectangle
    length, width = (sides[0], 0.0) if len(rounds) == 2 else (sides[1], sides[0])
    return {
        "axis": axis,
        "center": np.array(rounds[0]["center"]) + spans.mean(axis=0),
        "radius": radius,
        "length": length + 2.0 * radius,
        "width": width + 2.0 * radius,
    }


def _of_planes(planes: Sequence[Entry]) -> Entry | None:
    """Return the values of a sharp rectangle from two pairs of parallel planes."""
    normals = np.array([wall["axis"] for wall in planes])
    points = np.array([wall["center"] for wall in planes])
    facing = next((k for k in (1, 2, 3) if abs(normals[0] @ normals[k]) > 1.0 - _SAME), 0)
    pairs = [(0, facing), tuple(k for k in (1, 2, 3) if k != facing)] if facing else []
    if not pairs or abs(normals[pairs[1][0]] @ normals[pairs[1][1]]) < 1.0 - _SAME:
        return None
    first, second = (normals[pair[0]] for pair in pairs)
    if abs(first @ second) > _SAME:
        return None
    center, sizes = points[0].copy(), []
    for normal, (a, b) in zip((first, second), pairs):
        sizes.append(abs(float(normal @ (points[b] - points[a]))))
        center += normal * (normal @ (0.5 * (points[a] + points[b]) - center))
    axis = np.cross(first, second)
    return {
        "axis": axis / np.linalg.norm(axis),
        "center": center,
        "radius": 0.0,
        "length": max(sizes),
        "width": min(sizes),
    }


def _placed(entry: Entry, numbers: Entry, walls: Sequence[Entry]) -> Entry:
    """Return the entry with exact values; its centre keeps the position along the axis."""
    axis = numbers["axis"] * (1.0 if numbers["axis"] @ entry["axis"] >= 0.0 else -1.0)
    away = np.array(entry["center"]) - numbers["center"]
    return {
        **entry,
        **numbers,
        "axis": axis.tolist(),
        "center": (numbers["center"] + (away @ axis) * axis).tolist(),
        "residual": max(wall["residual"] for wall in walls),
    }
