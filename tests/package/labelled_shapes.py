# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts made of simple forms, with the vertices of every form known: labels for what is found.

Lengths in mm. `coarse` scales the edges; rims of round holes keep at least 8 vertices.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from sheet_meshes import NEAR, Loop, circle, divided, flat, folded, grid, inside, lifted, polygon
from sheet_meshes import revolved, rounded, thickened

Where = Callable[[np.ndarray], np.ndarray]


@dataclass
class Shape:
    """(n, 3) points, (m, 3) triangles, and labels: (kind, the vertices of that form)."""

    name: str
    points: np.ndarray
    triangles: np.ndarray
    labels: list[tuple[str, frozenset[int]]] = field(default_factory=list)

    def label(self, kind: str, where: Where) -> None:
        """Labels the vertices where a condition on (n, 3) points holds."""
        self.labels.append((kind, frozenset(np.flatnonzero(where(self.points)).tolist())))

    def edge(self) -> float:
        """Median length of the edges."""
        ends = self.points[self.triangles]
        return float(np.median(np.linalg.norm(ends - np.roll(ends, 1, axis=1), axis=2)))


# -- the catalogue


def catalogue(coarse: float = 1.0) -> list[Shape]:
    """Every kind of feature at least twice, on parts of their own."""
    makers = (
        _plate,
        _solid_plate,
        _angle,
        _hat,
        _pressed,
        _tube,
        _cone,
        _dome,
        _disc,
        _pin,
        _collar,
    )
    return [make(5.0 * coarse) for make in makers]


def _rim_count(radius: float, step: float) -> int:
    return max(8, round(2 * np.pi * radius / step))


def _openings(step: float) -> list[tuple[str, Loop]]:
    near = step / 2
    return [
        ("round hole", circle((30, 30), 12, _rim_count(12, near))),
        ("round hole", circle((30, 90), 6, _rim_count(6, near))),
        ("slotted hole", rounded((80, 30), (40, 14), 7, near)),
        ("slotted hole", rounded((80, 90), (30, 16), 8, near)),
        ("rectangular hole", rounded((140, 30), (36, 24), 6, near)),
        ("rectangular hole", rounded((140, 90), (30, 20), 0, near)),
        ("hole", polygon([(170, 20), (190, 20), (190, 30), (180, 30), (180, 50), (170, 50)], near)),
        ("hole", polygon([(175, 75), (192, 105), (158, 105)], near)),
    ]


def _plate(step: float) -> Shape:
    holes = _openings(step)
    outline = polygon([(0, 0), (200, 0), (200, 120), (0, 120)], step)
    points, triangles = flat(outline, [loop for _, loop in holes], step)
    shape = Shape("plate", lifted(points), triangles)
    shape.label("plane", lambda p: p[:, 2] > -1)
    first = len(outline)
    for kind, loop in holes:
        shape.labels.append((kind, frozenset(range(first, first + len(loop)))))
        first += len(loop)
    return shape


def _solid_plate(step: float) -> Shape:
    holes = _openings(step)
    outline = polygon([(0, 0), (200, 0), (200, 120), (0, 120)], step)
    points, triangles = flat(outline, [loop for _, loop in holes], step)
    loops = [len(outline), *(len(loop) for _, loop in holes)]
    shape = Shape("solid plate", *thickened(points, triangles, loops, 3.0))
    count, first = len(points), len(outline)
    for where in (lambda p: p[:, 2] > 2, lambda p: p[:, 2] < 1):
        shape.label("plane", where)
    for axis, at in ((0, 0), (0, 200), (1, 0), (1, 120)):
        shape.label("plane", lambda p, axis=axis, at=at: np.abs(p[:, axis] - at) < NEAR)
    for kind, loop in holes:
        rim = np.arange(first, first + len(loop))
        shape.labels.append((kind, frozenset([*rim.tolist(), *(rim + count).tolist()])))
        first += len(loop)
    _label_wall(shape, (30, 30), 12)
    _label_wall(shape, (30, 90), 6)
    for x in (-1, 1):
        _label_wall(shape, (80 + x * 13, 30), 7, (x, 0))
        _label_wall(shape, (80 + x * 7, 90), 8, (x, 0))
    return shape


def _label_wall(shape: Shape, center: Sequence[float], radius: float, way=(0, 0)) -> None:
    """The cylinder of a hole, or what of it lies to one side; what has less than a thousandth of
    the part's area is below the smallest area of a surface."""
    off = shape.points[:, :2] - center
    on_it = np.abs(np.linalg.norm(off, axis=1) - radius) < 0.01 * radius
    shape.label("cylinder", lambda p: on_it & np.all(off * way > -NEAR, axis=1))


def _angle(step: float) -> Shape:
    points, triangles, run = folded([(80, 0), (9.42, 90), (20, 0)], 150, step)
    shape = Shape("angle", points, triangles)
    _label_runs(shape, run, (("plane",), ("cylinder",), ("plane", "flange")))
    return shape


def _hat(step: float) -> Shape:
    runs = [
        (18, 0),
        (9.42, 90),
        (30, 0),
        (9.42, -90),
        (60, 0),
        (9.42, -90),
        (30, 0),
        (9.42, 90),
        (18, 0),
    ]
    points, triangles, run = folded(runs, 240, step)
    shape = Shape("hat", points, triangles)
    flange, bend, plane = ("plane", "flange"), ("cylinder",), ("plane",)
    _label_runs(shape, run, (flange, bend, plane, bend, plane, bend, plane, bend, flange))
    return shape


def _label_runs(shape: Shape, run: np.ndarray, kinds: Sequence[Sequence[str]]) -> None:
    """A run has its own vertices and the last ones of the run before."""
    across = int(np.count_nonzero(shape.points[:, 0] == shape.points[0, 0]))
    for number, of_run in enumerate(kinds):
        own = np.flatnonzero(run == number)
        before = np.arange(max(0, own[0] - across), own[0])
        vertices = frozenset([*own.tolist(), *before.tolist()])
        shape.labels += [(kind, vertices) for kind in of_run]


def _pressed(step: float) -> Shape:
    """A plate with a bead and a round emboss, both with slopes of 45 degrees."""
    foot = {
        "bead": rounded((60, 30), (80, 24), 12, step / 2),
        "emboss": circle((150, 70), 24, _rim_count(24, step / 2)),
    }
    top = {
        "bead": rounded((60, 30), (70, 14), 7, step / 2),
        "emboss": circle((150, 70), 18, _rim_count(18, step / 2)),
    }
    outline = polygon([(0, 0), (200, 0), (200, 110), (0, 110)], step)
    points, triangles = flat(outline, [], step, [*foot.values(), *top.values()])
    grown = {name: _reach(loop) for name, loop in foot.items()}
    height = np.zeros(len(points))
    for name, rise in (("bead", 5.0), ("emboss", 6.0)):
        near = inside(grown[name], points)
        away = cKDTree(divided(top[name], 0.05)).query(points)[0]
        away[inside(_reach(top[name]), points)] = 0.0
        height[near] = np.clip(rise - away[near], 0.0, rise)
    shape = Shape("pressed", lifted(points, height), triangles)
    shape.label("plane", lambda p: p[:, 2] < NEAR)
    for name in foot:
        raised = inside(grown[name], points)
        shape.label(name, lambda p, raised=raised: raised)
        high = height[raised].max()
        shape.label("plane", lambda p, raised=raised, high=high: raised & (p[:, 2] > high - 0.1))
    _label_slopes(shape, inside(grown["bead"], points), inside(grown["emboss"], points))
    return shape


def _label_slopes(shape: Shape, bead: np.ndarray, emboss: np.ndarray) -> None:
    """Of a bead from x = 32 to 88 around y = 30, and of a round emboss."""
    x, y, z = shape.points.T
    bead = (
        bead & (z < 5 + NEAR) & (np.hypot(np.clip(np.abs(x - 60) - 28, 0, None), y - 30) > 7 - NEAR)
    )
    for way in (-1, 1):
        shape.label(
            "plane", lambda p, way=way: bead & (np.abs(x - 60) < 28.5) & (way * (y - 30) > 0)
        )
        shape.label("cone", lambda p, way=way: bead & (way * (x - 60) > 27.5))
    away = np.hypot(x - 150, y - 70)
    shape.label("cone", lambda p: emboss & (away > 18 - 0.01))
    for radius in (18, 24):  # creases around what lies inside them
        shape.label("round edge", lambda p, radius=radius: np.abs(away - radius) < 0.01)


def _reach(loop: Loop) -> Loop:
    """The loop a trifle larger, so that its own points lie inside."""
    middle = loop.mean(axis=0)
    return middle + (1 + 1e-6) * (loop - middle)


def _tube(step: float) -> Shape:
    rows = np.column_stack([np.full(13, 20.0), np.linspace(0, 80, 13)])
    shape = Shape("tube", *revolved(rows, max(12, round(2 * np.pi * 20 / step))))
    shape.label("cylinder", lambda p: p[:, 2] > -1)
    shape.label("round edge", lambda p: p[:, 2] < NEAR)
    shape.label("round edge", lambda p: p[:, 2] > 80 - NEAR)
    return shape


def _cone(step: float) -> Shape:
    rows = np.column_stack([np.linspace(40, 15, 9), np.linspace(0, 50, 9)])
    shape = Shape("cone", *revolved(rows, max(12, round(2 * np.pi * 30 / step))))
    shape.label("cone", lambda p: p[:, 2] > -1)
    shape.label("round edge", lambda p: p[:, 2] < NEAR)
    # The sheet lies around the small end, as seen along the axis.
    shape.label("round hole", lambda p: p[:, 2] > 50 - NEAR)
    return shape


def _dome(step: float) -> Shape:
    angles = np.linspace(0, 1.35, 10)
    rows = 40 * np.column_stack([np.cos(angles), np.sin(angles)])
    shape = Shape("dome", *revolved(rows, max(16, round(2 * np.pi * 40 / step))))
    shape.label("sphere", lambda p: p[:, 2] > -1)
    shape.label("round edge", lambda p: p[:, 2] < NEAR)
    top = shape.points[:, 2].max()
    shape.label("round hole", lambda p: p[:, 2] > top - NEAR)
    return shape


def _disc(step: float) -> Shape:
    rim, hole = circle((0, 0), 50, _rim_count(50, step)), circle(
        (5, 0), 15, _rim_count(15, step / 2)
    )
    points, triangles = flat(rim, [hole], step)
    shape = Shape("disc", lifted(points), triangles)
    shape.label("plane", lambda p: p[:, 2] > -1)
    shape.labels.append(("round edge", frozenset(range(len(rim)))))
    shape.labels.append(("round hole", frozenset(range(len(rim), len(rim) + len(hole)))))
    return shape


def _pin(step: float) -> Shape:
    rim = circle((0, 0), 25, _rim_count(25, step))
    points, triangles = flat(rim, [], step)
    shape = Shape("pin", *thickened(points, triangles, [len(rim)], 30.0))
    count = len(points)
    ring = np.arange(len(rim))
    shape.label("plane", lambda p: p[:, 2] > 29)
    shape.label("plane", lambda p: p[:, 2] < 1)
    shape.labels.append(("cylinder", frozenset([*ring.tolist(), *(ring + count).tolist()])))
    shape.labels += [("round edge", frozenset((ring + k).tolist())) for k in (0, count)]
    return shape


def _collar(step: float) -> Shape:
    """A plate whose hole is drawn up to a collar with a sharp edge."""
    rim = circle((60, 60), 20, _rim_count(20, step / 2))
    outline = polygon([(0, 0), (120, 0), (120, 120), (0, 120)], step)
    points, triangles = flat(outline, [rim], step)
    count, size, first = len(points), len(rim), len(outline)
    rows = np.array([lifted(rim, z) for z in (0.0, 5.0, 10.0)])
    wall, cells = grid(rows, wraps=True)
    number = np.concatenate([first + np.arange(size), count + np.arange(2 * size)])
    shape = Shape(
        "collar", np.vstack([lifted(points), wall[size:]]), np.vstack([triangles, number[cells]])
    )
    shape.label("plane", lambda p: p[:, 2] < NEAR)
    vertices = frozenset(number.tolist())
    shape.labels += [("round hole", vertices), ("cylinder", vertices)]
    return shape
