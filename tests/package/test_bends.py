# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bends of sheet metal: found with radius and angle, offered, and rigid features once taken."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cad_samples import make_cad_samples
from sheet_meshes import flat, folded, folded_solid, rounded, thickened
from sheetmorph import PartMesh, Session, _core
from sheetmorph.finding import FindPart, find, find_in_files


def bends_of(points: np.ndarray, triangles: np.ndarray) -> list[dict[str, Any]]:
    """The bends found on a mesh."""
    found = find([FindPart("sheet", PartMesh(points, triangles.astype(np.int32)))])
    return [entry for entry in found.features if entry["kind"] == "bend"]


def runs(*bends: tuple[float, float]) -> list[tuple[float, float]]:
    """Flats of 40 mm between bends of (radius, degrees)."""
    arcs = [(radius * np.radians(abs(degrees)), degrees) for radius, degrees in bends]
    return [(40.0, 0.0), *(run for arc in arcs for run in (arc, (40.0, 0.0)))]


@pytest.mark.parametrize("degrees", [30.0, 90.0, 135.0])
@pytest.mark.parametrize("radius", [3.0, 8.0])
def test_a_bend_of_an_open_sheet_is_found(radius: float, degrees: float):
    points, triangles, run = folded(runs((radius, degrees)), 60.0, 5.0)
    (bend,) = bends_of(points, triangles)
    assert bend["radius"] == pytest.approx(radius, rel=1e-6)
    assert bend["angle"] == pytest.approx(np.radians(degrees), rel=1e-6)
    assert np.abs(bend["axis"]) == pytest.approx([0.0, 1.0, 0.0], abs=1e-6)
    assert bend["length"] == pytest.approx(60.0) and "depth" not in bend
    assert set(np.flatnonzero(run == 1)) <= set(bend["vertices"])


@pytest.mark.parametrize("degrees", [30.0, -90.0, 135.0])
@pytest.mark.parametrize("radius", [4.0, 9.0])
def test_both_skins_of_a_thin_solid_are_one_bend(radius: float, degrees: float):
    # At 5 mm the last bits decide whether a flat takes the first facet of the arc of 30 degrees.
    points, triangles = folded_solid(runs((radius, degrees)), 60.0, 3.0, 1.5)
    assert _core.diagnose(_core.TriangleMesh(points, triangles), 1e-6).open_edges == 0
    (bend,) = bends_of(points, triangles)
    inner = radius - 1.5 if degrees > 0 else radius  # the sheet is thick towards its left
    assert bend["radius"] == pytest.approx(inner, rel=1e-6)
    assert bend["angle"] == pytest.approx(np.radians(abs(degrees)), rel=1e-6)
    assert bend["depth"] == pytest.approx(1.5, rel=1e-6)
    away = np.linalg.norm((points[bend["vertices"]] - bend["center"])[:, [0, 2]], axis=1)
    assert set(np.round(away, 6)) == {round(inner, 6), round(inner + 1.5, 6)}


def test_every_bend_of_a_folded_sheet_is_found_and_nothing_else():
    hat = runs((6.0, 90.0), (6.0, -90.0), (6.0, -45.0), (6.0, 45.0))
    assert len(bends_of(*folded(hat, 80.0, 5.0)[:2])) == 4
    turns = [entry["angle"] for entry in bends_of(*folded_solid(hat, 80.0, 5.0, 2.0))]
    assert sorted(np.degrees(turns)) == pytest.approx([45.0, 45.0, 90.0, 90.0])


def test_round_corners_and_ends_of_slots_are_no_bends():
    outline = rounded((50, 30), (100, 60), 12, 3.0)
    slot = rounded((50, 30), (40, 16), 8, 2.0)
    points, triangles = flat(outline, [slot], 4.0)
    solid = thickened(points, triangles, [len(outline), len(slot)], 2.0)
    assert bends_of(*solid) == []
    tube = folded([(40.0, 0.0), (2.0 * np.pi * 10.0 * 0.9, 324.0), (40.0, 0.0)], 60.0, 5.0)
    assert bends_of(*tube[:2]) == []


def test_a_bend_of_a_cad_file_is_exact(tmp_path: Path):
    folder = make_cad_samples(tmp_path)
    found = find_in_files([folder / "bend.step"], meshing={"angle": 20.0})["features"]
    (bend,) = (entry for entry in found if entry["kind"] == "bend")
    assert bend["radius"] == pytest.approx(3.0, abs=1e-12)
    assert bend["depth"] == pytest.approx(2.0, abs=1e-12)
    assert bend["angle"] == pytest.approx(np.pi / 2.0, abs=1e-9)
    assert bend["length"] == pytest.approx(50.0, abs=1e-9)


def recipe_with(features: Any, points: np.ndarray) -> dict[str, Any]:
    """A folded sheet held at its low end, its far end pulled aside."""
    start = np.flatnonzero(points[:, 0] < 1e-6).tolist()
    tip = np.flatnonzero(points[:, 2] > points[:, 2].max() - 1e-6).tolist()
    return {
        "sheetmorph": 1,
        "parts": [{"name": "sheet", "thin": "auto"}],
        "fixed": [{"part": "sheet", "vertices": start}],
        "handles": [{"name": "tip", "part": "sheet", "vertices": tip}],
        "features": features,
        "pose": {"tip": {"translation": [12.0, 0.0, -6.0]}},
    }


def test_a_bend_keeps_its_angle_as_a_feature_and_is_taken_only_when_asked_for():
    points, triangles = folded_solid(runs((8.0, 90.0)), 60.0, 5.0, 1.5)
    mesh = {"sheet": PartMesh(points, triangles.astype(np.int32))}
    (bend,) = bends_of(points, triangles)
    usual = Session(recipe_with("auto", points), mesh)
    assert usual.deform().features == []
    asked = Session(recipe_with({"auto": {"kinds": ["bend"]}}, points), mesh).deform()
    (feature,) = asked.features
    rest, moved = points[bend["vertices"]], asked.positions["sheet"][bend["vertices"]]
    rigid = feature.centre + feature.translation + (rest - feature.centre) @ feature.rotation.T
    assert np.abs(rigid - moved).max() < 1e-9
    given = Session(recipe_with([bend], points), mesh).deform()  # as `find` prints it
    assert np.allclose(given.positions["sheet"], asked.positions["sheet"], atol=1e-9)
    free = usual.deform().positions["sheet"][bend["vertices"]]
    centre = rest.mean(axis=0)
    shape = np.linalg.svd((rest - centre).T @ (free - free.mean(axis=0)))
    turn = shape[0] @ shape[2]
    assert np.abs((rest - centre) @ turn - (free - free.mean(axis=0))).max() > 0.05
