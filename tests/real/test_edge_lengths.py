# SPDX-License-Identifier: LGPL-2.1-or-later
"""A recipe in words means the same at every edge length: `./sheetmorph test real`."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import recipes
from sheetmorph import PartMesh, _core
from sheetmorph.cli import main
from sheetmorph.files import read_part
from sheetmorph.recipe.splitting import part_of

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "in_words"
FILE = "03-laser4diy-enclosure/Enclosure_v3_v9.step"
EDGES = (12.0, 6.0, 3.0)  # mm

Shape = dict[str, tuple[PartMesh, np.ndarray]]  # mesh at rest and deformed points, by part


@pytest.fixture(scope="module")
def runs(tmp_path_factory) -> dict[float, tuple[dict, Shape]]:
    """The report and the shapes of what moved, at each edge length."""
    if recipes.data_folder() is None:
        pytest.skip(recipes.ABSENT)
    folder = tmp_path_factory.mktemp("chamber")
    (folder / Path(FILE).name).symlink_to(recipes.data_folder() / FILE)
    recipe = json.loads((EXAMPLES / "laser_chamber.json").read_text("utf-8"))
    found = {}
    for edge in EDGES:
        recipe["parts"][0]["mesh"]["edge"] = edge
        (folder / "recipe.json").write_text(json.dumps(recipe), encoding="utf-8")
        found[edge] = run(folder, recipe["parts"][0]["mesh"])
    return found


def run(folder: Path, meshing: dict) -> tuple[dict, Shape]:
    """`run` of the recipe in a folder: its report, and what it wrote of the parts that moved."""
    told, out = folder / "report.json", folder / "out"
    wanted = ["run", str(folder / "recipe.json"), "-o", str(out), "--report", str(told), "--quiet"]
    assert main(wanted) == 0
    report = json.loads(told.read_text("utf-8"))
    rest = read_part(folder / Path(FILE).name, meshing)
    points = read_part(out / Path(FILE).with_suffix(".obj").name).mesh.points
    shutil.rmtree(out)
    shapes = {}
    for part in report["parts"]:
        if part["largest_displacement"] > 0.0:
            name = part["name"].partition("/")[2]
            mesh, vertices = part_of(rest.mesh, rest.bodies[name], name)
            shapes[name] = (mesh, points[vertices])
    return report, shapes


def test_every_region_has_the_same_area(runs, record_property):
    for same in zip(*(report["regions"] for report, _ in runs.values())):
        areas = [region["area"] for region in same]
        record_property(f"{same[0]['name']}, {same[0]['part']}: mm^2", areas)
        assert np.ptp(areas) <= 0.03 * min(areas), (same[0]["name"], areas)
        assert max(region["distance"] for region in same) < 0.01


def test_every_shape_is_the_same(runs, record_property):
    fine = runs[3.0][1]
    assert len(fine) == 3
    largest = max(np.abs(points - mesh.points).max() for mesh, points in fine.values())
    for edge in (12.0, 6.0):
        for name, (mesh, points) in runs[edge][1].items():
            off = differences(mesh, points, fine[name])
            record_property(f"{name} at {edge:g} mm: largest difference", off.max() / largest)
            assert off.max() <= 0.005 * largest, (edge, name, off.max(), largest)


def differences(mesh: PartMesh, points: np.ndarray, other: tuple[PartMesh, np.ndarray]):
    """(n,) how far the vertices of a deformed mesh are from where another mesh has their places."""
    rest, moved = other
    tree = _core.PickingTree(rest.points, rest.triangles)
    off = np.zeros(len(points))
    for k, point in enumerate(mesh.points):
        hit = tree.nearest_point(point)
        corners = rest.triangles[hit.triangle]
        there = np.asarray(hit.barycentric) @ (moved[corners] - rest.points[corners])
        off[k] = np.linalg.norm(points[k] - mesh.points[k] - there)
    return off
