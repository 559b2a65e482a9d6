# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a pose does that is likely not wanted is a warning: part, place, size and what to do."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from plates import plate, recipe_of, write_plate
from sheetmorph import PartMesh, RecipeError, Session, run
from sheetmorph.morph.running import CertificateError
from sheetmorph.measuring.strain import EdgeChanges, crushed
from sheetmorph.measuring.tears import Cuts

STRIP = plate(holes=1, cells=3)


def grid(columns: int, rows: int, step: float = 1.0) -> PartMesh:
    """A flat sheet of squares, cut into triangles."""
    x, y = np.meshgrid(np.arange(columns + 1), np.arange(rows + 1), indexing="ij")
    points = step * np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    a = (np.arange(columns)[:, None] * (rows + 1) + np.arange(rows)).ravel()
    b, c, d = a + rows + 1, a + rows + 2, a + 1
    return PartMesh(points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))


def ends(mesh: PartMesh, **entries: object) -> dict:
    """A recipe that holds the left end of a sheet and moves the right one."""
    x = mesh.points[:, 0]
    return {
        "sheetmorph": 1,
        "parts": [{"name": "sheet"}],
        "fixed": [{"part": "sheet", "vertices": np.flatnonzero(x < 0.5).tolist()}],
        "handles": [
            {"name": "end", "part": "sheet", "vertices": np.flatnonzero(x > x.max() - 0.5).tolist()}
        ],
        "pose": {"end": {"translation": [0, 0, 1]}},
        **entries,
    }


def warnings(recipe: dict, mesh: PartMesh) -> list[str]:
    result = Session(recipe, {"sheet": mesh}).deform()
    report = result.report()
    assert result.warnings() == report["warnings"] and set(report["warnings"]) <= set(
        report["notes"]
    )
    return report["warnings"]


def test_a_gentle_pose_warns_of_nothing():
    mesh = grid(20, 4)
    assert warnings(ends(mesh), mesh) == []


def test_edges_that_collapse_say_where_and_how_short():
    mesh = grid(20, 4)
    pose = {"end": {"translation": [-19.5, 0, 0]}}
    (told,) = [text for text in warnings(ends(mesh, pose=pose), mesh) if "collapse" in text]
    assert '"sheet"' in told and "to less than a tenth" in told and "move less" in told
    changes = EdgeChanges(mesh.points, mesh.triangles)
    result = Session(ends(mesh, pose=pose), {"sheet": mesh}).deform()
    shortest = changes.shortest(result.positions["sheet"])
    assert f"{changes.collapsed(result.positions['sheet'])} edges" in told
    assert f"from {shortest.before:.3g} to {shortest.after:.3g} mm" in told


def test_a_stretched_edge_says_how_long_it_was():
    mesh = grid(20, 4, 0.02)
    recipe = ends(mesh, pose={"end": {"translation": [0.6, 0, 0]}})
    x = mesh.points[:, 0]
    recipe["fixed"][0]["vertices"] = np.flatnonzero(x < 0.01).tolist()
    recipe["handles"][0]["vertices"] = np.flatnonzero(x > 0.39).tolist()
    (told,) = [text for text in warnings(recipe, mesh) if "changes its length" in text]
    assert '"sheet", 0.02 mm long' in told or '"sheet", 0.0283 mm long' in told
    assert "% at (" in told


def test_a_sheet_that_is_folded_over_and_one_that_passes_through_itself():
    mesh = grid(20, 4)
    result = Session(ends(mesh), {"sheet": mesh}).deform()
    x = mesh.points[:, 0]
    beyond = x > 10
    for height, word in ((0.1 * (x - 10), "over onto"), (0.3 * (15.2 - x), "penetrates itself")):
        places = mesh.points.copy()
        places[beyond, 0] = 20.3 - x[beyond]
        places[beyond, 2] = height[beyond]
        (told,) = replace(result, positions={"sheet": places}).warnings()
        assert f"{word} " in told and '"sheet"' in told and "turn it less" in told
        assert ("8 triangles" in told) == (word == "over onto") and " at (" in told
        assert ("pairs of triangles" in told) == (word == "penetrates itself")


def test_crushed_triangles_are_those_that_lose_their_height():
    mesh = grid(4, 2)
    flat = mesh.points.copy()
    flat[:, 1] = np.where(flat[:, 0] > 2.5, 0.0, flat[:, 1])
    a, b, c = (flat[mesh.triangles[:, k]] for k in range(3))
    expected = np.flatnonzero(np.linalg.norm(np.cross(b - a, c - a), axis=1) == 0.0).tolist()
    assert crushed(mesh, flat).tolist() == expected
    assert len(crushed(mesh, mesh.points)) == 0


@pytest.mark.parametrize("seed", range(6))
def test_a_cut_is_found_wherever_it_runs(seed: int):
    rng = np.random.default_rng(seed)
    mesh = grid(12, 4)
    column = int(rng.integers(3, 10))
    middle = mesh.points[mesh.triangles].mean(axis=1)[:, 0]
    seam = np.flatnonzero(mesh.points[:, 0] == column)
    triangles = mesh.triangles.copy()
    twin = {int(v): len(mesh.points) + k for k, v in enumerate(seam)}
    beyond = middle > column
    triangles[beyond] = np.vectorize(lambda v: twin.get(v, v))(triangles[beyond])
    noise = rng.normal(size=(len(seam), 3)) * 1e-8
    points = np.concatenate([mesh.points, mesh.points[seam] + noise])
    order = rng.permutation(len(points))
    place = np.argsort(order)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    cut = PartMesh((points @ turn.T + rng.uniform(-1e3, 1e3, 3))[order], place[triangles])
    recipe = ends(mesh)
    for entry in (recipe["fixed"][0], recipe["handles"][0]):
        entry["vertices"] = place[entry["vertices"]].tolist()
    recipe["pose"] = {"end": {"translation": (turn @ [0.0, 0.0, 3.0]).tolist()}}
    (told,) = [text for text in warnings(recipe, cut) if "is cut" in text]
    assert f"{len(seam)} vertices separate" in told and "by up to 3 mm" in told and '"weld"' in told
    assert Cuts(mesh).tear(mesh.points + [0, 0, 1]) is None


def test_a_part_that_no_motion_reaches_is_told_unless_it_is_fixed():
    mesh = grid(6, 2)
    recipe = ends(mesh, parts=[{"name": "sheet"}, {"name": "cover"}], primary="sheet")
    meshes = {"sheet": mesh, "cover": PartMesh(mesh.points + [0, 0, 5], mesh.triangles)}
    (told,) = Session(recipe, meshes).deform().warnings()
    assert 'no motion reaches "cover"' in told and "contact" in told
    recipe["fixed"].append({"part": "cover", "vertices": [0]})
    assert Session(recipe, meshes).deform().warnings() == []


def test_pieces_that_nothing_holds_are_told():
    one, other = grid(6, 2), grid(6, 2)
    points = np.concatenate([one.points, other.points + [0, 9, 0]])
    both = PartMesh(points, np.concatenate([one.triangles, other.triangles + len(one.points)]))
    recipe = ends(one)
    (told,) = warnings(recipe, both)
    assert '1 piece of "sheet" (21 vertices, one at (0, 9, 0))' in told


def test_a_strict_run_fails_with_the_words_of_the_warning(tmp_path: Path):
    write_plate(STRIP, tmp_path / "plate.obj", "obj")
    recipe = recipe_of(STRIP, "plate.obj")
    recipe["pose"] = {"tip": {"translation": [-18, 0, 0]}}
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    report = run(path, tmp_path / "out")
    assert report["warnings"]
    with pytest.raises(CertificateError) as caught:
        run(path, tmp_path / "strict", strict=True)
    assert all(text in str(caught.value) for text in report["warnings"])


def overlapping(count: int) -> tuple[dict, PartMesh]:
    """A fixed region and a handle that share vertices of a sheet."""
    mesh = grid(20, 4)
    recipe = ends(mesh)
    shared = recipe["handles"][0]["vertices"][:count]
    recipe["fixed"][0]["vertices"] += shared
    return recipe, mesh


@pytest.mark.parametrize("count", [1, 3, 4])
def test_vertices_that_are_fixed_and_moved_are_refused_by_name(count: int):
    recipe, mesh = overlapping(count)
    session = Session(recipe, {"sheet": mesh})
    with pytest.raises(RecipeError) as caught:
        session.deform()
    told = str(caught.value)
    assert "fixed region 'fixed0' and handle 'end' share " in told
    assert f"share {count} vert" in told and str(recipe["handles"][0]["vertices"][0]) in told
    with pytest.raises(RecipeError, match="share"):
        session.begin_drag(["end"]).deform({"end": {"translation": [0, 0, 1]}})
    # At rest, and turned about what is fixed, nothing contradicts.
    assert session.deform({}).warnings() == []
    pivot = mesh.points[recipe["handles"][0]["vertices"][0]].tolist()
    turn = {"rotation": {"axis": [0, 1, 0], "degrees": 10}, "pivot": pivot}
    assert session.deform({"end": turn}) is not None


def test_two_handles_that_share_vertices_are_refused_by_name():
    mesh = grid(20, 4)
    recipe = ends(mesh)
    recipe["handles"].append({**recipe["handles"][0], "name": "other"})
    with pytest.raises(RecipeError) as caught:
        Session(recipe, {"sheet": mesh})
    assert "handle 'end' and handle 'other' both move 5 vertices (" in str(caught.value)
