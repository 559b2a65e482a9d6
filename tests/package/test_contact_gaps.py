# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gap of a contact: one number in report, table, certificate and study, and it is right."""

from __future__ import annotations

import gc
import json
from pathlib import Path

import numpy as np
import pytest

from plates import plate, recipe_of, write_plate
from sheetmorph import PartMesh, Session, read_part, run
from sheetmorph.certifying import NotCertified, certify, read_criteria
from sheetmorph.cli.summary import ending_of
from sheetmorph.measuring.gaps import Surface

PART = plate(holes=2, cells=3)
KINDS = ("control mesh", "tied", "rigid")
WAYS = ("local", "single", "whole")


def distances(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(k,) of points (k, 3) from the nearest of triangles (m, 3, 3), each with each."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    best = np.full(len(points), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):  # the sides
        side = q - p
        share = np.einsum("kmj,mj->km", points[:, None] - p, side) / (side**2).sum(axis=1)
        near = p + np.clip(share, 0.0, 1.0)[..., None] * side
        best = np.minimum(best, np.linalg.norm(points[:, None] - near, axis=2).min(axis=1))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    height = np.einsum("kmj,mj->km", points[:, None] - a, normals)
    foot = points[:, None] - height[..., None] * normals
    inside = np.ones(height.shape, bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("kmj,mj->km", foot - p, np.cross(normals, q - p)) >= 0.0
    return np.minimum(best, np.where(inside, np.abs(height), np.inf).min(axis=1))


def gap_change(recipe: dict, rest: dict, now: dict, triangles: np.ndarray) -> float:
    """The worst change of the distance from a vertex of either side to the other part."""
    (contact,) = recipe["contacts"]
    worst = 0.0
    for own, other in (("a", "b"), ("b", "a")):
        rows, part, beyond = contact[own]["vertices"], contact[own]["part"], contact[other]["part"]
        before, after = (distances(at[part][rows], at[beyond][triangles]) for at in (rest, now))
        worst = max(worst, float(np.abs(after - before).max()))
    return worst


def drawn_recipe(rng: np.random.Generator, kind: str, way: str) -> tuple[dict, np.ndarray]:
    """Two plates, the second one anywhere above the first, joined by vertices anywhere on both."""
    shift = np.array([rng.uniform(0.0, 25.0), rng.uniform(-5.0, 5.0), rng.uniform(0.3, 3.0)])
    recipe = recipe_of(PART, "plate.obj")
    recipe["parts"] = [{"name": "plate", "file": "plate.obj"}, {"name": "lid", "file": "lid.obj"}]
    recipe["primary"], recipe["propagation"] = "plate", {"type": way}
    place, reach = rng.uniform((10.0, -5.0), (30.0, 5.0)), rng.uniform(6.0, 14.0)
    sides = [
        np.flatnonzero(np.linalg.norm(points[:, :2] - place, axis=1) < reach).tolist()
        for points in (PART.points, PART.points + shift)
    ]
    if not all(sides):
        return drawn_recipe(rng, kind, way)
    a, b = ({"part": part, "vertices": side} for part, side in zip(("plate", "lid"), sides))
    recipe["contacts"] = [{"name": "weld", "type": kind, "a": a, "b": b}]
    turn = {"axis": rng.normal(size=3).tolist(), "degrees": float(rng.uniform(-20.0, 20.0))}
    recipe["features"] = []
    recipe["pose"] = {
        recipe["handles"][0]["name"]: {
            "translation": rng.uniform(-4.0, 4.0, 3).tolist(), "rotation": turn,
        }
    }  # fmt: skip
    return recipe, shift


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_gap_is_that_of_a_measure_by_brute_force(kind: str, way: str):
    rng = np.random.default_rng([KINDS.index(kind), WAYS.index(way)])
    for _ in range(4):
        recipe, shift = drawn_recipe(rng, kind, way)
        meshes = {
            "plate": PartMesh(PART.points, PART.triangles),
            "lid": PartMesh(PART.points + shift, PART.triangles),
        }
        result = Session(recipe, meshes).deform()
        (contact,) = result.contacts
        rest = {name: mesh.points for name, mesh in meshes.items()}
        expected = gap_change(recipe, rest, result.positions, PART.triangles)
        assert contact.gap_change == pytest.approx(expected, rel=1e-9, abs=1e-12)
        assert result.report()["contacts"][0]["gap_change"] == contact.gap_change


def test_a_session_keeps_gaps_at_rest_and_no_search_trees():
    recipe, shift = drawn_recipe(np.random.default_rng(3), "tied", "local")
    meshes = {
        "plate": PartMesh(PART.points, PART.triangles),
        "lid": PartMesh(PART.points + shift, PART.triangles),
    }
    session = Session(recipe, meshes)
    first, again = (session.deform().contacts[0].gap_change for _ in range(2))
    assert first == again > 0.0
    gap = session.contact_gap("weld")
    assert gap is session.contact_gap("weld")
    assert not [one for one in gc.get_objects() if isinstance(one, Surface)]


def certificate(recipe: Path, folder: Path) -> dict:
    """The certificate of a run, whether it passes or not."""
    try:
        return certify(recipe, folder, read_criteria("standard"))
    except NotCertified as error:
        return error.certificate


@pytest.mark.parametrize("suffix", ["obj", "nas", "binary.ply"])
@pytest.mark.parametrize("kind", KINDS)
def test_report_table_and_certificate_have_the_number_of_the_file(
    kind: str, suffix: str, tmp_path: Path
):
    rng = np.random.default_rng(KINDS.index(kind))
    recipe, shift = drawn_recipe(rng, kind, "local")
    lid = plate(holes=2, cells=3)
    lid.points = lid.points + shift
    for part, made in (("plate", PART), ("lid", lid)):
        write_plate(made, tmp_path / f"{part}.{suffix}", suffix)
    for entry in recipe["parts"]:
        entry["file"] = f"{entry['name']}.{suffix}"
    first = 101 if suffix == "nas" else 0
    for entry in (
        *recipe["fixed"], *recipe["handles"], *(recipe["contacts"][0][side] for side in "ab")
    ):  # fmt: skip
        entry["vertices"] = [first + vertex for vertex in entry["vertices"]]
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    report = run(path, tmp_path / "out")
    (told,) = report["contacts"]
    found = certificate(path, tmp_path / "out")
    assert found["contacts"][0]["worst_change"] == told["gap_change"]
    assert f"gap change {told['gap_change']:.2g} mm" in "\n".join(
        ending_of(report, "out", is_quiet=False)
    )
    for side in "ab":
        entry = recipe["contacts"][0][side]
        entry["vertices"] = [vertex - first for vertex in entry["vertices"]]
    rest, now = (
        {name: read_part(folder / f"{name}.{suffix}").mesh.points for name in ("plate", "lid")}
        for folder in (tmp_path, tmp_path / "out")
    )
    expected = gap_change(recipe, rest, now, PART.triangles)
    assert told["gap_change"] == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_a_feature_has_one_edge_error_in_report_and_certificate(tmp_path: Path):
    write_plate(PART, tmp_path / "plate.nas", "nas")
    recipe = recipe_of(PART, "plate.nas")
    for section in ("fixed", "handles", "features"):
        for entry in recipe[section]:
            entry["vertices"] = [101 + vertex for vertex in entry["vertices"]]
    recipe["features"][0]["size"] = 9.0
    recipe["pose"] = {
        recipe["handles"][0]["name"]: {"rotation": {"axis": [0, 1, 0.3], "degrees": 25}}
    }
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    report = run(path, tmp_path / "out")
    found = certificate(path, tmp_path / "out")
    told = {entry["name"]: entry["file_edge_error"] for entry in report["features"]}
    assert {entry["name"]: entry["edge_error"] for entry in found["features"]} == told
    assert 1e-6 < max(told.values()) < 1e-2
