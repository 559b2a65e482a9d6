# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bent sheets laid flat: against the blanks they were bent from."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from sheetmorph.cli import main
from sheetmorph.flat import NotFlat, flat_patterns

ROLLS = Path(__file__).parents[2].parent / "shared" / "data" / "08-isometric-roll-reference"
LENGTH, WIDTH, STEP = 60.0, 40.0, 1.25
HOLE, HOLE_RADIUS = (12.0, 20.0), 5.0


def blank() -> tuple[np.ndarray, np.ndarray]:
    """A plate of 60 x 40 mm with a round hole: (n, 2) mm, (m, 3)."""
    nx, ny = round(LENGTH / STEP), round(WIDTH / STEP)
    x, y = np.meshgrid(np.linspace(0, LENGTH, nx + 1), np.linspace(0, WIDTH, ny + 1))
    points = np.column_stack([x.T.ravel(), y.T.ravel()])
    a = (np.arange(nx)[:, None] * (ny + 1) + np.arange(ny)).ravel()
    b, c, d = a + ny + 1, a + ny + 2, a + 1
    triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    arm = points - HOLE
    far = np.linalg.norm(arm, axis=1)
    is_left = (far > HOLE_RADIUS - 0.5 * STEP)[triangles].all(axis=1)
    triangles = triangles[is_left]
    removed = np.setdiff1d(np.arange(len(points)), triangles)
    inside = far < HOLE_RADIUS + STEP
    rim = np.flatnonzero(inside & np.isin(np.arange(len(points)), _rim_of(triangles)))
    points[rim] = HOLE + arm[rim] * (HOLE_RADIUS / far[rim])[:, None]
    keep = np.setdiff1d(np.arange(len(points)), removed)
    new = np.full(len(points), -1)
    new[keep] = np.arange(len(keep))
    return points[keep], new[triangles]


def _rim_of(triangles: np.ndarray) -> np.ndarray:
    sides = np.sort(np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    return np.unique(edges[count == 1])


def bent(points: np.ndarray, radius: float, degrees: float, start: float = 25.0) -> np.ndarray:
    """(n, 3): the plate bent up by an angle about an axis along y, from x = start on."""
    angle = math.radians(degrees)
    s = np.clip((points[:, 0] - start) / radius, 0.0, angle)
    rest = points[:, 0] - start - radius * s
    flat = np.minimum(points[:, 0], start)
    beyond = np.where(points[:, 0] > start, rest, 0.0)
    x = flat + radius * np.sin(s) + beyond * np.cos(s)
    z = radius * (1.0 - np.cos(s)) + beyond * np.sin(s)
    return np.column_stack([x, points[:, 1], z])


def written(path: Path, points: np.ndarray, triangles: np.ndarray) -> Path:
    lines = ["v {!r} {!r} {!r}".format(*row) for row in points.tolist()]
    lines += ["f {} {} {}".format(*row) for row in (triangles + 1).tolist()]
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.fixture
def bracket(tmp_path):
    """The plate bent by 120 degrees with a radius of 8 mm in the middle of the metal."""
    points, triangles = blank()
    return written(tmp_path / "bracket.obj", bent(points, 8.0, 120.0), triangles)


def test_a_bracket_comes_back_to_the_blank_it_was_bent_from(bracket):
    (pattern,) = flat_patterns(bracket)
    assert pattern.size == pytest.approx((LENGTH, WIDTH), abs=0.02)
    assert len(pattern.holes) == 1 and pattern.rigid == [True]
    centre, radius = pattern.circles[0]
    assert radius == pytest.approx(HOLE_RADIUS, rel=2e-3)
    assert min(centre[0], LENGTH - centre[0]) == pytest.approx(HOLE[0], abs=0.05)
    (bend,) = pattern.bends
    assert math.degrees(bend.angle) == pytest.approx(120.0, abs=0.01)
    assert bend.radius == pytest.approx(8.0, rel=0.01)
    assert bend.is_up and bend.k_factor is None
    (line,) = pattern.lines
    along = {round(abs(float(x)), 1) for x in (line[1] - line[0])[:2]}
    assert 40.0 in along or any(abs(x - 40.0) < 1.5 for x in along)
    assert pattern.residual()[1] < 2e-3


def test_a_hole_that_keeps_its_form_is_rigid_in_the_blank(bracket):
    (pattern,) = flat_patterns(bracket)
    rim = pattern.holes[0]
    for step in (1, 5, 11):
        before = np.linalg.norm(pattern.rest[rim] - np.roll(pattern.rest[rim], step, 0), axis=1)
        after = np.linalg.norm(pattern.flat[rim] - np.roll(pattern.flat[rim], step, 0), axis=1)
        assert np.abs(after - before).max() < 1e-9


def test_the_neutral_fibre_makes_the_blank_shorter(bracket, tmp_path):
    thickness = 2.0
    (plain,) = flat_patterns(bracket)
    (pattern,) = flat_patterns(bracket, thickness=thickness)
    (bend,) = pattern.bends
    assert bend.inner == pytest.approx(bend.radius - 1.0)
    # Between the rows R/T = 3, K = 0.43 and R/T = 10, K = 0.5.
    assert bend.k_factor == pytest.approx(0.43 + 0.07 * (bend.inner / 2.0 - 3.0) / 7.0)
    wanted = plain.size[0] + bend.angle * thickness * (bend.k_factor - 0.5)
    assert pattern.size[0] == pytest.approx(wanted, abs=0.03)
    table = tmp_path / "k.txt"
    table.write_text("# R/T  K\n0.5, 0.25\n9 0.25\n")
    assert main(["flatten", str(bracket), "--thickness", "2", "--k-table", str(table)]) == 0


def test_every_format_is_written_and_tells_the_same(bracket, tmp_path, capsys):
    out = tmp_path / "blank"
    assert main(["flatten", str(bracket), "-o", str(out), "--quiet"]) == 0
    assert re.search(r"bracket: (59.99|60.00)", capsys.readouterr().out)
    told = json.loads((out / "bracket.json").read_text())
    assert told["bends"][0]["side"] == "up" and told["holes"][0]["keeps_its_form"]
    lines = (out / "bracket.dxf").read_text().splitlines()
    pairs = list(zip(lines[::2], lines[1::2]))
    assert pairs[0] == ("0", "SECTION") and pairs[-1] == ("0", "EOF")
    kinds = [value for code, value in pairs if code == "0"]
    assert kinds.count("POLYLINE") == 1 and kinds.count("CIRCLE") == 1 and kinds.count("LINE") == 1
    root = ElementTree.parse(out / "bracket.svg").getroot()
    assert root.get("width").endswith("mm")
    vertices = [row.split() for row in (out / "bracket.obj").read_text().splitlines()]
    flat = np.array([row[1:] for row in vertices if row[0] == "v"], float)
    assert np.ptp(flat, axis=0)[:2] == pytest.approx(told["size"])
    one = tmp_path / "only.svg"
    assert main(["flatten", str(bracket), "-o", str(one), "--quiet"]) == 0
    assert one.exists() and not (tmp_path / "only.dxf").exists()


def test_a_dome_cannot_be_laid_flat(tmp_path, capsys):
    points, triangles = blank()
    centre = points.mean(axis=0)
    height = 60.0 - np.sqrt(60.0**2 - ((points - centre) ** 2).sum(axis=1))
    dome = written(tmp_path / "dome.obj", np.column_stack([points, height]), triangles)
    assert main(["flatten", str(dome), "-o", str(tmp_path / "dome"), "--quiet"]) == 3
    assert "cannot be flattened within 1 %" in capsys.readouterr().err
    assert not (tmp_path / "dome").exists()
    assert main(["flatten", str(dome), "--limit", "20", "--quiet"]) == 0


def test_what_is_no_sheet_is_refused_with_a_reason(tmp_path, capsys):
    corners = np.array([[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]], float)
    closed = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    assert main(["flatten", str(written(tmp_path / "t.obj", corners, closed)), "--quiet"]) == 3
    assert "closed" in capsys.readouterr().err
    fins = np.array([[0, 1, 2], [0, 1, 3], [1, 0, 4]])
    points = np.vstack([corners, [[0, -9, 0]]])
    assert main(["flatten", str(written(tmp_path / "f.obj", points, fins)), "--quiet"]) == 3
    assert "T-joint" in capsys.readouterr().err
    assert main(["flatten", str(tmp_path / "nothing.obj")]) == 2
    table = tmp_path / "k.txt"
    table.write_text("three 0.4\n")
    sheet = written(tmp_path / "s.obj", corners, closed[1:])
    assert main(["flatten", str(sheet), "--k-table", str(table)]) == 2
    assert "K-factor" in capsys.readouterr().err


def test_sharp_folds_are_bend_lines(tmp_path):
    points, triangles = blank()
    shape = np.column_stack([points, np.maximum(points[:, 0] - 40.0, 0.0)])
    shape[:, 0] = np.minimum(shape[:, 0], 40.0)
    (pattern,) = flat_patterns(written(tmp_path / "l.obj", shape, triangles))
    (bend,) = pattern.bends
    assert math.degrees(bend.angle) == pytest.approx(90.0)
    assert bend.radius == 0.0
    assert np.linalg.norm(pattern.lines[0][1] - pattern.lines[0][0]) == pytest.approx(WIDTH)
    assert pattern.size == pytest.approx((LENGTH, WIDTH), abs=1e-6)


@pytest.mark.skipif(not ROLLS.is_dir(), reason="the rolled reference plates are not here")
@pytest.mark.parametrize("name", ["plate4SD_rolledA.ply", "plate4SD_rolledB.ply"])
def test_the_rolled_reference_plates_come_back_to_the_unit_square(name):
    (pattern,) = flat_patterns(ROLLS / name)
    assert pattern.size == pytest.approx((1.0, 1.0), abs=5e-4)


def test_a_closed_roll_says_that_it_does_not_fit(tmp_path):
    angle = np.linspace(0, 2 * np.pi, 25)[:-1]
    points = np.array([[np.cos(a), np.sin(a), z] for z in np.linspace(0, 3, 6) for a in angle])
    k = np.arange(24)
    rows = [[24 * z + k, 24 * z + (k + 1) % 24, 24 * (z + 1) + k] for z in range(5)] + [
        [24 * z + (k + 1) % 24, 24 * (z + 1) + (k + 1) % 24, 24 * (z + 1) + k] for z in range(5)
    ]
    triangles = np.vstack([np.column_stack(row) for row in rows])
    with pytest.raises(NotFlat, match="cannot be flattened"):
        flat_patterns(written(tmp_path / "tube.obj", points, triangles))
