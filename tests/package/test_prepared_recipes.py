# SPDX-License-Identifier: LGPL-2.1-or-later
"""Weld and remesh in recipes: what comes in as CAD exports it bends as if it had been meshed."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from sheetmorph import RecipeError, read_part, run
from sheetmorph.reporting.report import report_schema
from test_real_files import real_file

LENGTH, WIDTH, RADIUS, AROUND = 120.0, 60.0, 10.0, 48


def coarse_plate() -> tuple[np.ndarray, np.ndarray]:
    """A plate with a round hole as CAD exports it: every rim vertex tied to a corner far away.

    Vertices: the corners 0 .. 3, then the rim in order.
    """
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * [LENGTH / 2, WIDTH / 2]
    angles = 2.0 * np.pi * np.arange(AROUND) / AROUND
    rim = RADIUS * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    quadrant = (np.arange(AROUND) // (AROUND // 4)).tolist()
    triangles = []
    for k in range(AROUND):
        here, after, corner = 4 + k, 4 + (k + 1) % AROUND, quadrant[k]
        triangles.append([here, corner, after])
        if quadrant[(k + 1) % AROUND] != corner:
            triangles.append([after, corner, (corner + 1) % 4])
    points = np.column_stack([np.vstack([corners, rim]), np.zeros(4 + AROUND)])
    return points, np.array(triangles)


def write_obj(path: Path, points: np.ndarray, triangles: np.ndarray) -> None:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()]
    path.write_text("\n".join(lines) + "\n")


def bend(folder: Path, **part: object) -> tuple[dict, np.ndarray]:
    """Report and (4, 3) deformed corners: the left end held, the right end turned by 30 degrees."""
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": "plate.obj", **part}],
        "fixed": [{"part": "plate", "vertices": [1, 2]}],
        "handles": [{"name": "end", "part": "plate", "vertices": [0, 3]}],
        "features": [{"name": "hole", "part": "plate", "vertices": list(range(4, 4 + AROUND))}],
        "pose": {
            "end": {
                "translation": [-6, 0, 25],
                "rotation": {"axis": [0, 1, 0], "degrees": -30},
            }
        },
    }
    (folder / "recipe.json").write_text(json.dumps(recipe))
    report = run(folder / "recipe.json", folder / "out")
    jsonschema.validate(report, report_schema())
    return report, read_part(folder / "out" / "plate.obj").mesh.points


def middle_of_hole(report: dict) -> np.ndarray:
    feature = report["features"][0]
    return np.array(feature["translation"])


def test_a_remeshed_plate_keeps_its_facets_its_rim_and_the_ids_of_its_file(tmp_path: Path):
    write_obj(tmp_path / "plate.obj", *coarse_plate())
    report, points = bend(tmp_path, remesh={"edge": 4.0})
    (part,), (hole,) = report["parts"], report["features"]
    fresh = part["preparation"]["remesh"]
    assert fresh["deviation"] < 1e-12
    assert fresh["kept_vertices"] == 4 + AROUND
    assert part["quality"]["before"]["worst_angle_degrees"] > 15.0
    assert part["quality"]["flipped"] == 0
    assert hole["vertices"] == AROUND
    assert hole["edge_error"] < report["tolerance"]
    # The edges between the ends of the file's own are held and moved as a whole.
    rest = coarse_plate()[0]
    assert points[1] == pytest.approx(rest[1])
    assert np.isclose(points[:, 0], -LENGTH / 2).sum() > 10


def test_halving_the_edge_length_changes_a_bent_plate_by_less_than_a_hundredth(tmp_path: Path):
    write_obj(tmp_path / "plate.obj", *coarse_plate())
    shifts = []
    for edge in (6.0, 3.0):
        report, _ = bend(tmp_path, remesh={"edge": edge})
        shifts.append(middle_of_hole(report))
    largest = report["parts"][0]["largest_displacement"]
    assert np.linalg.norm(shifts[0] - shifts[1]) < 0.01 * largest


def test_rims_go_to_their_circles_and_the_report_tells_how_far(tmp_path: Path):
    write_obj(tmp_path / "plate.obj", *coarse_plate())
    report, _ = bend(tmp_path, remesh={"edge": 4.0, "rims": "circle"})
    fresh = report["parts"][0]["preparation"]["remesh"]
    assert fresh["rims_on_circles"] == 1
    assert fresh["deviation"] < RADIUS * (1.0 - np.cos(np.pi / AROUND)) * 1.1


def test_a_weld_closes_what_is_cut_and_every_id_still_counts(tmp_path: Path):
    points, triangles = coarse_plate()
    cut = points[triangles.ravel()] + 1e-7 * np.arange(triangles.size)[:, None] / triangles.size
    soup = np.vstack([points, cut])
    write_obj(tmp_path / "plate.obj", soup, np.arange(triangles.size).reshape(-1, 3) + len(points))
    report, deformed = bend(tmp_path, weld=1e-5, remesh={"edge": 4.0})
    done = report["parts"][0]["preparation"]
    assert done["welded"] == triangles.size
    assert report["features"][0]["vertices"] == AROUND
    assert len(report["parts"]) == 1 and len(deformed) > 500


def test_what_cannot_be_prepared_is_bad_input(tmp_path: Path):
    write_obj(tmp_path / "plate.obj", *coarse_plate())
    with pytest.raises(RecipeError, match="million triangles"):
        bend(tmp_path, remesh={"edge": 1e-3})
    with pytest.raises(RecipeError, match="edge"):
        bend(tmp_path, remesh={"rims": "circle"})
    with pytest.raises(RecipeError, match="smaller"):
        bend(tmp_path, weld=1e6)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["summit_xls_chapas_inox_tapas", "summit_xl_covers"])
def test_plates_of_the_summit_deform_once_prepared(name: str, tmp_path: Path):
    """Set 05: split into components, one end held, the other lifted."""
    from sheetmorph import Session, _core
    from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh

    mesh = read_part(real_file(f"05-robotnik-summit-stl/{name}.stl")).mesh
    tolerance = 1e-6
    made, _ = prepared_mesh(_core, mesh, Wanted(tolerance, 0.02))
    assert made.preparation["remesh"]["flat_deviation"] < 1e-7
    labels = _core.components(_core.TriangleMesh(made.points, made.triangles))
    largest = np.bincount(labels[labels >= 0]).argmax()
    x = made.points[:, 0]
    own = labels == largest
    low, high = np.quantile(x[own], [0.02, 0.98])
    held = np.flatnonzero(~own | (x <= low)).tolist()
    lifted = np.flatnonzero(own & (x >= high)).tolist()
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "sheet"}],
        "fixed": [{"part": "sheet", "vertices": held}],
        "handles": [{"name": "end", "part": "sheet", "vertices": lifted}],
        "pose": {"end": {"translation": [0, 0, 0.02]}},
    }
    from sheetmorph import PartMesh

    plain = PartMesh(made.points, made.triangles)
    positions = Session(recipe, {"sheet": plain}).deform().positions["sheet"]
    assert np.isfinite(positions).all()
    assert 0.019 < np.abs(positions - made.points).max() < 0.06
