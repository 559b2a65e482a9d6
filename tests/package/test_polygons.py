# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polygons of a file as triangles: exact area, no triangle turned over, holes stay open."""

from __future__ import annotations

import math
import random
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import FileError, read_part
from sheetmorph.base.polygons import triangulate

Outline = list[tuple[float, float]]


def refusal(number: int, what: str) -> FileError:
    return FileError("part.obj", what, "split it", number + 1)


def star(noise: random.Random, centre: tuple[float, float], radii: tuple[float, float]) -> Outline:
    """A simple polygon round a centre, most of them not convex, counterclockwise."""
    count = noise.randint(3, 14)
    turn = noise.random()
    found = []
    for k in range(count):
        angle = math.tau * (k + turn + 0.6 * noise.random()) / count
        radius = noise.uniform(*radii)
        found.append((centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)))
    return found


def comb(noise: random.Random) -> Outline:
    """A polygon of right angles with teeth of random length, some sides in one line."""
    teeth = noise.randint(2, 8)
    found = [(0.0, 0.0), (3.0, 0.0), (2.0 * teeth, 0.0)]
    for k in reversed(range(teeth)):
        high = float(noise.randint(2, 6))
        found += [(2.0 * k + 2.0, high), (2.0 * k + 1.0, high), (2.0 * k + 1.0, 1.0)]
        found += [(2.0 * k, 1.0)]
    return found


def crosses(a: tuple, b: tuple, c: tuple, d: tuple) -> bool:
    """Whether two segments have a point in common that is no common end."""
    if {a, b} & {c, d}:
        return False

    def side(p: tuple, q: tuple, r: tuple) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) <= 1e-9 and side(c, d, a) * side(c, d, b) <= 1e-9


def bridged(noise: random.Random, outline: Outline, hole: Outline) -> Outline | None:
    """One outline with a hole in it, which a bridge connects to a corner that sees it."""
    sides = [*zip(outline, outline[1:] + outline[:1]), *zip(hole, hole[1:] + hole[:1])]
    pairs = [(i, j) for i in range(len(outline)) for j in range(len(hole))]
    noise.shuffle(pairs)
    for i, j in pairs:
        if not any(crosses(outline[i], hole[j], c, d) for c, d in sides):
            inside = hole[j::-1] + hole[:j:-1]
            return outline[: i + 1] + inside + [hole[j]] + outline[i:]
    return None


def plate_with_holes(noise: random.Random) -> tuple[Outline, float]:
    """A plate with up to four holes as one polygon with bridges, and its area."""
    outline = star(noise, (0.0, 0.0), (9.0, 20.0))
    area = shoelace(outline)
    for centre in [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)][: noise.randint(1, 4)]:
        if all(math.hypot(*p) > 9.0 for p in edge_points(outline)):
            hole = star(noise, centre, (0.5, 2.0))
            joined = bridged(noise, outline, hole)
            if joined is not None:
                outline, area = joined, area - shoelace(hole)
    return outline, area


def edge_points(outline: Outline) -> Outline:
    return [
        (a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]))
        for a, b in zip(outline, outline[1:] + outline[:1])
        for s in (0.0, 0.25, 0.5, 0.75)
    ]


def shoelace(outline: Outline) -> float:
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))


def in_space(noise: random.Random, outline: Outline, is_shared: bool) -> tuple:
    """Points (n, 3) anywhere in space, the polygon's vertices, and its normal.

    is_shared: both sides of a bridge have the same vertices.
    """
    shift = noise.randrange(len(outline))
    outline = outline[shift:] + outline[:shift]
    places = list(dict.fromkeys(outline)) if is_shared else outline
    polygon = [places.index(p) for p in outline] if is_shared else list(range(len(outline)))
    spin = np.linalg.qr(np.random.default_rng(noise.randrange(10**9)).normal(size=(3, 3)))[0]
    scale = 10.0 ** noise.uniform(-3, 3)
    flat = np.column_stack([np.array(places), np.zeros(len(places))])
    normal = spin[:, 2] * np.linalg.det(spin)
    return scale * (flat @ spin.T + 7.0), polygon, normal * np.sign(shoelace(outline)), scale


@pytest.mark.parametrize("kind", ["star", "comb", "holes"])
@pytest.mark.parametrize("is_shared", [True, False])
def test_random_polygons_keep_their_area_and_no_triangle_is_turned_over(kind: str, is_shared: bool):
    noise = random.Random(f"{kind} {is_shared}")
    for _ in range(60):
        if kind == "holes":
            outline, area = plate_with_holes(noise)
        else:
            outline = star(noise, (0, 0), (1.0, 9.0)) if kind == "star" else comb(noise)
            area = shoelace(outline)
        points, polygon, normal, scale = in_space(noise, outline, is_shared)
        triangles = triangulate(points, [polygon], refusal)
        assert len(triangles) == len(polygon) - 2
        a, b, c = (points[triangles[:, k]] for k in range(3))
        areas = 0.5 * np.cross(b - a, c - a) @ normal / scale**2
        assert areas.min() > -1e-9
        assert areas.sum() == pytest.approx(area, rel=1e-9)
        # The sides of the polygon have one triangle, all others two, against each other.
        sides = Counter((t[k], t[(k + 1) % 3]) for t in triangles.tolist() for k in range(3))
        border = Counter(zip(polygon, polygon[1:] + polygon[:1]))
        assert border - sides == Counter()
        inner = sides - border
        assert inner == Counter({(b, a): n for (a, b), n in inner.items()})


def test_a_polygon_that_crosses_itself_is_refused_with_its_line(tmp_path: Path):
    path = tmp_path / "part.obj"
    lines = ["v 0 0 0", "v 2 2 0", "v 2 0 0", "v 0 2 0", "v -1 1 0", "f 1 2 3 4 5"]
    path.write_text("\n".join(lines) + "\n")
    with pytest.raises(FileError, match="the polygon of 5 corners crosses itself") as caught:
        read_part(path)
    assert caught.value.line == 6


def test_quads_that_are_not_convex_are_cut_inside():
    points = np.array([[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]], float)
    for shift in range(4):
        quad = [(k + shift) % 4 for k in range(4)]
        triangles = triangulate(points, [quad], refusal)
        a, b, c = (points[triangles[:, k]] for k in range(3))
        assert np.cross(b - a, c - a)[:, 2].min() > 0.0


def test_large_polygons_take_no_long_time():
    """A plate with 20 x 20 round holes has a polygon of some 10,000 corners as a skin."""
    noise = random.Random(1)
    outline = [(k + 0.0, 40.0 * (k % 2) * noise.random()) for k in range(2000)]
    outline += [(2000.0, 50.0), (0.0, 50.0)]
    points = np.column_stack([np.array(outline), np.zeros(len(outline))])
    triangles = triangulate(points, [range(len(outline))], refusal)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    assert 0.5 * np.cross(b - a, c - a)[:, 2].sum() == pytest.approx(shoelace(outline))
