# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real assemblies and meshes follow their handles, where they are at hand beside the repository."""

from __future__ import annotations

import json
import sys
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "real"))

import rear_wing  # noqa: E402
import recipes  # noqa: E402
import riveted_support  # noqa: E402
import selection  # noqa: E402
from sheetmorph import Session, _core, run  # noqa: E402
from sheetmorph.morph.running import CertificateError  # noqa: E402

pytestmark = pytest.mark.skipif(recipes.data_folder() is None, reason=recipes.ABSENT)
ALONE = ["shelf", "bracket", "end plate", "bar", "cylinder", "bumpy_plane"]
WHOLE = ["support", "wing"]
# Parts of the support that hang on the end of the shelf that stays.
AT_THE_FIXED_END = [f"W1000BOstat/{number}" for number in (2, 5, 6, 7, 8, 9)]
# Largest gap change of a contact, as a share of its region's size.
GAPS = {"control mesh": 0.02, "tied": 0.001, "rigid": 1e-12}


@lru_cache(maxsize=None)
def deformed(name: str):
    """The result of a recipe in its own pose, exact."""
    return result_of(recipes.make(name))


def result_of(recipe: dict):
    """The result of a recipe in its own pose, exact."""
    meshes = selection.read_meshes(recipe["parts"], recipes.data_folder())
    return Session(recipe, meshes).deform()


def displacement(result, part: str) -> float:
    """Farthest way of a vertex of a part, mm."""
    rest = result.session.meshes[part].points
    return float(np.linalg.norm(result.positions[part] - rest, axis=1).max())


@pytest.mark.parametrize("name", ALONE + WHOLE)
def test_features_stay_rigid_and_no_triangle_flips(name: str):
    report = deformed(name).report()
    assert report["certificate"]["passed"]
    worst = max((entry["edge_error"] for entry in report["features"]), default=0.0)
    assert worst <= report["tolerance"]
    assert sum(part["quality"]["flipped"] for part in report["parts"]) == 0


@pytest.mark.parametrize("name", ALONE + WHOLE)
def test_handles_are_met_and_fixed_regions_stay(name: str):
    result, recipe = deformed(name), recipes.make(name)
    for entry in recipe["fixed"]:
        mesh = result.session.meshes[entry["part"]]
        held = mesh.find(entry["vertices"])[0]
        assert np.array_equal(result.positions[entry["part"]][held], mesh.points[held])
    handle = recipe["handles"][0]
    mesh = result.session.meshes[handle["part"]]
    moved = mesh.find(handle["vertices"])[0]
    shift = (result.positions[handle["part"]][moved] - mesh.points[moved]).mean(axis=0)
    wanted = recipe["pose"][handle["name"]]["translation"]
    assert np.allclose(shift, wanted, rtol=0.0, atol=1e-9 * result.session.size)


@pytest.mark.parametrize("name", ["shelf", "bracket", "support"])
def test_round_holes_stay_round(name: str):
    result = deformed(name)
    count = 0
    for part, positions in result.positions.items():
        mesh = result.session.meshes[part]
        if part in result.session.unreached:
            continue
        for hole in _core.round_holes(_core.TriangleMesh(mesh.points, mesh.triangles), 0.02):
            before = _core.fit_circle(mesh.points[hole.rim])
            after = _core.fit_circle(positions[hole.rim])
            assert abs(after.radius - before.radius) < 1e-9 * result.session.size
            assert abs(after.residual - before.residual) < 1e-9 * result.session.size
            count += 1
    assert count == {"shelf": 13, "bracket": 3, "support": 16}[name]


def test_a_part_without_contacts_moves_alone():
    result = deformed("shelf")
    others = [part for part in result.session.parts if part != riveted_support.SHELF]
    assert result.session.unreached == others and len(others) == 11
    assert max(displacement(result, part) for part in others) == 0.0


def test_the_support_touches_where_its_readme_says():
    found = recipes.make("support")["contacts"]
    pairs = {(entry["a"]["part"], entry["b"]["part"]) for entry in found}
    assert len(pairs) == 20
    assert 22 <= len(found) <= 24


@pytest.mark.parametrize("name", WHOLE)
def test_every_part_follows_the_end_it_is_joined_to(name: str):
    result = deformed(name)
    assert result.session.unreached == []
    motion = next(iter(recipes.make(name)["pose"].values()))["translation"]
    for part in result.session.parts:
        if part in AT_THE_FIXED_END:
            assert displacement(result, part) < 1.0
        else:
            assert displacement(result, part) > 0.9 * np.linalg.norm(motion)


@pytest.mark.parametrize("maker", [riveted_support.support, rear_wing.wing])
@pytest.mark.parametrize("kind", ["control mesh", "tied"])
def test_contacts_stay_closed_as_well_as_their_type_promises(maker, kind: str):
    result = result_of(maker(recipes.data_folder(), kind))
    assert result.session.unreached == []
    for contact in result.contacts:
        assert contact.gap_change <= GAPS[kind] * contact.region_size, contact.name


def test_bolted_wings_keep_their_section():
    result = deformed("wing")
    for contact in result.contacts:
        assert contact.gap_change <= GAPS["rigid"] * result.session.size, contact.name
    mesh = result.session.meshes["flap"]
    edges = mesh.triangles[:, :2]
    before = np.linalg.norm(np.diff(mesh.points[edges], axis=1), axis=2)
    after = np.linalg.norm(np.diff(result.positions["flap"][edges], axis=1), axis=2)
    assert np.abs(after / before - 1.0).max() < 0.01


def test_rigid_seams_that_hang_together_are_one_body_and_what_they_tear_is_told():
    """The stringers are riveted along the whole shelf: as rigid bodies they cannot bend."""
    report = result_of(riveted_support.support(recipes.data_folder(), "rigid")).report()
    assert report["certificate"]["passed"] and report["unreached"] == []
    assert max(contact["deviation"] for contact in report["contacts"]) < 1e-9
    torn = [text for text in report["warnings"] if "changes its length" in text]
    assert any('an edge of "W1000BOstat/1", ' in text for text in torn)


@pytest.mark.parametrize("name", WHOLE)
def test_the_command_line_writes_what_the_files_can_hold(name: str, tmp_path: Path):
    path = tmp_path / "recipe.json"
    recipe = recipes.make(name)
    if name == "support":
        # Its pose pulls bars between two brackets apart, which the run tells.
        path.write_text(json.dumps(recipe), encoding="utf-8")
        with pytest.raises(CertificateError, match="RBE2 27500 came apart by 13.6 mm"):
            run(path, tmp_path / "out")
        assert not (tmp_path / "out").exists()
        recipe["parts"][0]["joints"] = {"broken": "tell"}
    path.write_text(json.dumps(recipe), encoding="utf-8")
    report = run(path, tmp_path / "out")
    assert report["certificate"]["passed"] and report["unreached"] == []
    # 8 characters of a deck: 3482.17 is good for 0.005 mm; float32 of an STL for 4e-5 mm.
    limit = {"support": 0.02, "wing": 1e-4}[name]
    assert max(part["file"]["error"] for part in report["parts"]) < limit
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == sorted(
        {Path(entry["file"]).name for entry in recipes.make(name)["parts"]}
    )
