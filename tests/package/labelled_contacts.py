# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of parts that touch in every way there is: labels for the contacts that are found.

Every pair stands alone, 300 mm from the next; lengths in mm, gaps of 1 mm.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sheet_meshes import circle, flat, folded, lifted, polygon, revolved

GAP = 1.0
Mesh = tuple[np.ndarray, np.ndarray]


@dataclass
class Pairs:
    """parts: name to (points, triangles); labels: (a, b, kind, center, reach) of every place of
    contact; connections: elements as (part, vertex, part, vertex), parts by name."""

    parts: dict[str, Mesh] = field(default_factory=dict)
    labels: list[tuple[str, str, str, np.ndarray, float]] = field(default_factory=list)
    connections: list[tuple[str, int, str, int]] = field(default_factory=list)

    def add(self, kind: str, one: Mesh, other: Mesh, places: list[tuple[list[float], float]]):
        """A pair, and where (center, reach) it is in contact; returns the names."""
        number = len(self.parts) // 2
        shift = 300.0 * np.array([number % 4, number // 4, 0.0])
        names = f"{kind} {number} a", f"{kind} {number} b"
        for name, (points, triangles) in zip(names, (one, other)):
            self.parts[name] = (points + shift, triangles)
        for center, reach in places:
            self.labels.append((*names, kind, np.asarray(center) + shift, reach))
        return names


def pairs(coarse: float = 1.0) -> Pairs:
    """Two pairs and more of every kind of contact."""
    step, made = 5.0 * coarse, Pairs()
    for radius in (6.0, 9.0):
        lug = _lug(radius, step)
        made.add("bolt", lug, _raised(lug, GAP), [([0, 0, GAP / 2], 2 * radius)])
    for width in (150.0, 240.0):
        hat = folded(
            [(18, 0), (9.42, 90), (30, 0), (9.42, -90), (60, 0), (9.42, -90), (30, 0)]
            + [(9.42, 90), (18, 0)],
            width,
            step,
        )[:2]
        below = hat[0] * [1, 1, -1] - [0, 0, GAP], hat[1]
        middle = hat[0][:, 0].max() / 2
        places = [([x, width / 2, 0], width / 2) for x in (9.0, 2 * middle - 9.0)]
        made.add("flange", hat, below, places)
    plate = _plate(100, 80, step)
    for shift in (40.0, 60.0):
        over = plate[0] + [shift, 0, GAP], plate[1]
        made.add("face", plate, over, [([shift / 2 + 50, 40, 0], 60.0)])
    tubes = [_tube(20.0, step), _tube(20.0 + GAP, step)]
    made.add("face", *tubes, [([0, 0, 40], 45.0)])
    for tilt in (0.0, 20.0):
        turn = np.radians(90 - tilt)
        rib = _plate(80, 40, step)
        points = rib[0] @ np.array([[1, 0, 0], [0, np.cos(turn), np.sin(turn)], [0, 0, 1]])
        places = [([50, 40, 0], 42.0)]
        made.add("edge", plate, (points + [10, 40, 0.5], rib[1]), places)
    for length in (60.0, 90.0):
        _add_weld(made, length, step)
    return made


def _add_weld(made: Pairs, length: float, step: float) -> None:
    strip = _plate(length, 30, step)
    over = strip[0] + [0, 0, GAP], strip[1]
    a, b = made.add("weld", strip, over, [([length / 2, 15, 0], length / 2)])
    places = np.linspace(0.2, 0.8, 4)[:, None] * [length, 0] + [0, 15]
    for place in places:
        vertex = int(np.linalg.norm(strip[0][:, :2] - place, axis=1).argmin())
        made.connections.append((a, vertex, b, vertex))


def _raised(mesh: Mesh, height: float) -> Mesh:
    return mesh[0] + [0, 0, height], mesh[1]


def _plate(length: float, width: float, step: float) -> Mesh:
    points, triangles = flat(
        polygon([(0, 0), (length, 0), (length, width), (0, width)], step), [], step
    )
    return lifted(points), triangles


def _lug(radius: float, step: float) -> Mesh:
    rims = [circle((0, 0), r, max(8, round(2 * np.pi * r / step))) for r in (2 * radius, radius)]
    points, triangles = flat(rims[0], rims[1:], step / 2)
    return lifted(points), triangles


def _tube(radius: float, step: float) -> Mesh:
    rows = np.column_stack([np.full(13, radius), np.linspace(0, 80, 13)])
    return revolved(rows, max(16, round(2 * np.pi * 20 / step)))
