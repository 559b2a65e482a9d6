# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP, IGES and BREP without FreeCAD: as parts of recipes, and through the command line."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from cad_samples import make_cad_samples
from sheetmorph import FileError, RecipeError, check, read_part, run, validate
from sheetmorph.files import output_name, suffixes
from test_real_files import real_file

SIZES = {"edge": 4.0, "deflection": 0.05, "angle": 20}


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of CAD files."""
    return make_cad_samples(tmp_path_factory.mktemp("cad"))


@pytest.fixture
def folder(samples: Path, tmp_path: Path) -> Path:
    """The same in a folder of the test's own."""
    for name in ("fixture.step", "plate.igs", "plate.brep"):
        shutil.copy(samples / name, tmp_path)
    return tmp_path


def on_cylinder(points: np.ndarray, foot: tuple[float, float], radius: float) -> np.ndarray:
    """Indices of the points on a cylinder along z."""
    away = np.hypot(points[:, 0] - foot[0], points[:, 1] - foot[1])
    return np.flatnonzero(np.abs(away - radius) < 1e-4)


def recipe_of(file: str, **part: object) -> dict:
    """A recipe that lifts one end of the plate in a file; the larger hole is a form feature."""
    return {
        "sheetmorph": 1,
        "parts": [{"file": file, **part}],
        "fixed": [],
        "handles": [],
        "features": [],
        "pose": {"tip": {"translation": [0, 0, 6]}},
    }


def save(recipe: dict, folder: Path) -> Path:
    """Write a recipe; returns its path."""
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe), "utf-8")
    return path


def with_regions(recipe: dict, points: np.ndarray, ids: np.ndarray, part: str) -> dict:
    """The recipe with both ends of the plate as regions and the larger hole as a feature."""
    ends = points[:, 0] < 1e-9, points[:, 0] > 60 - 1e-9
    hole = on_cylinder(points, (40, 20), 5)
    fixed, tip, rim = (ids[which].tolist() for which in (*ends, hole))
    return {
        **recipe,
        "fixed": [{"part": part, "vertices": fixed}],
        "handles": [{"name": "tip", "part": part, "vertices": tip}],
        "features": [{"name": "hole", "part": part, "vertices": rim}],
    }


@pytest.mark.parametrize("name", ["plate.igs", "plate.brep"])
def test_a_cad_file_is_a_part(folder: Path, name: str):
    file = read_part(folder / name, SIZES)
    part = file.model.parts[0]
    assert part.is_closed and part.skipped_faces == []
    assert part.deviation <= SIZES["deflection"]
    assert sorted(s.radius for s in part.surfaces if s.kind == "cylinder") == pytest.approx([3, 5])
    for foot, radius in (((15, 20), 3.0), ((40, 20), 5.0)):
        wall = on_cylinder(part.points, foot, radius)
        assert len(wall) >= 2 * 18
    assert "from the CAD surfaces" in file.notes[0]


def test_an_assembly_is_split_into_named_parts_with_ids_of_the_whole_file(folder: Path):
    recipe = recipe_of("fixture.step", split=True, mesh=SIZES)
    file = read_part(folder / "fixture.step", SIZES)
    assert list(file.bodies) == ["plate", "pin", "pin 2"]
    points = file.mesh.points
    ids = np.arange(len(points))
    only_plate = ids < len(file.model.parts[0].points)
    recipe = with_regions(recipe, points[only_plate], ids[only_plate], "fixture/plate")
    wall = on_cylinder(points, (15, 20), 3.0)
    sides = [wall[only_plate[wall]].tolist(), wall[~only_plate[wall]].tolist()]
    recipe["primary"] = "fixture/plate"
    names = ("fixture/plate", "fixture/pin")
    a, b = ({"part": name, "vertices": side} for name, side in zip(names, sides))
    recipe["contacts"] = [{"name": "fit", "type": "rigid", "a": a, "b": b}]
    report = run(save(recipe, folder), folder / "out", report=folder / "report.json")
    assert report["certificate"]["passed"]
    assert {part["file"]["name"] for part in report["parts"]} == {"fixture.obj"}
    assert [part["is_reached"] for part in report["parts"]] == [True, True, False]
    written = read_part(folder / "out" / "fixture.obj")
    assert written.mesh.triangles.tolist() == file.mesh.triangles.tolist()
    text = (folder / "out" / "fixture.obj").read_text()
    assert [line[2:] for line in text.splitlines() if line[0] == "o"] == list(file.bodies)
    tip = ids[only_plate & (points[:, 0] > 60 - 1e-9)]
    assert np.allclose(written.mesh.points[tip], points[tip] + [0, 0, 6], atol=1e-12)


def test_one_part_is_deformed_from_the_command_line(folder: Path):
    mesh = read_part(folder / "plate.brep", SIZES).mesh
    recipe = recipe_of("plate.brep", name="plate", mesh=SIZES)
    ids = np.arange(len(mesh.points))
    path = save(with_regions(recipe, mesh.points, ids, "plate"), folder)
    assert check(path) == []
    command = [sys.executable, "-m", "sheetmorph", "run", str(path), "-o", str(folder / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert "OpenCASCADE" not in done.stdout and "1 part written" in done.stdout.splitlines()[-1]
    written = read_part(folder / "out" / "plate.obj").mesh.points
    hole = on_cylinder(mesh.points, (40, 20), 5)
    gaps = [
        np.linalg.norm(p[hole][:, None] - p[hole][None], axis=2) for p in (mesh.points, written)
    ]
    assert np.abs(gaps[0] - gaps[1]).max() < 1e-10


def test_finer_sizes_give_more_triangles_nearer_to_the_surface(folder: Path):
    parts = [
        read_part(folder / "plate.brep", {"edge": edge, "angle": angle}).model.parts[0]
        for edge, angle in ((8, 40), (3, 10))
    ]
    assert len(parts[1].triangles) > 3 * len(parts[0].triangles)
    assert parts[1].deviation < parts[0].deviation / 4


@pytest.mark.parametrize("name", ["part.step", "part.stp", "part.igs", "part.iges", "part.brep"])
def test_a_file_that_is_no_cad_file_is_named(tmp_path: Path, name: str):
    for content in (b"", b"solid of nothing\n", bytes(range(256)) * 20):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(FileError) as caught:
            read_part(tmp_path / name)
        assert name in str(caught.value) and caught.value.what and caught.value.todo


def test_a_step_file_cut_short_is_named(folder: Path):
    path = folder / "fixture.step"
    path.write_bytes(path.read_bytes()[:3000])
    with pytest.raises(FileError) as caught:
        read_part(path)
    assert caught.value.todo


def test_faults_of_the_meshing_are_told_with_their_place(folder: Path):
    recipe = recipe_of("plate.brep", mesh={"edge": -1, "size": 3})
    with pytest.raises(RecipeError) as caught:
        validate(recipe, folder)
    places = [fault.where for fault in caught.value.faults]
    assert any("mesh" in place for place in places)
    shutil.copy(folder / "plate.brep", folder / "plate.obj")
    with pytest.raises(RecipeError) as caught:
        validate(recipe_of("plate.obj", mesh=SIZES), folder)
    assert "only CAD files are meshed" in str(caught.value)


def test_two_sources_of_one_output_clash(folder: Path):
    recipe = recipe_of("plate.brep", name="a", mesh=SIZES)
    recipe["parts"].append({"file": "plate.igs", "name": "b", "mesh": SIZES})
    with pytest.raises(RecipeError, match='"plate.obj" is already used'):
        validate(recipe, folder)


def test_the_endings_are_published():
    assert {".step", ".stp", ".iges", ".igs", ".brep", ".brp"} <= set(suffixes())
    assert output_name("a/b.STEP") == "b.obj" and output_name("a/b.ply") == "b.ply"


def test_a_real_assembly_is_closed_and_near_its_surfaces():
    sizes = {"edge": 10.0, "deflection": 0.3, "angle": 20}
    model = read_part(real_file("06-laser-cut-box/box_sides.step"), sizes).model
    assert len({part.name for part in model.parts}) == 10
    for part in model.parts:
        assert part.is_closed and part.skipped_faces == [], part.name
        assert part.deviation <= 1.5 * model.deflection, part.name
