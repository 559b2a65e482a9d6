# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of a part that say how its file is to be read: packed, placed, scaled, cured."""

from __future__ import annotations

import gzip
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sheetmorph
from plates import Plate, plate, write_plate
from sheetmorph import FileError, PartMesh, diagnose, read_part
from sheetmorph.finding import find_in_files
from sheetmorph.base.kernel import load_kernel
from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh
from sheetmorph.starting.doctor import diagnose_files


def recipe_of(made: Plate, part: dict[str, Any], lift: list[float]) -> dict[str, Any]:
    return {
        "sheetmorph": 1,
        "parts": [{"name": "plate", **part}],
        "fixed": [{"part": "plate", "vertices": made.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": made.right}],
        "features": "auto",
        "pose": {"tip": {"translation": lift}},
    }


def run_in(folder: Path, recipe: dict[str, Any]) -> dict[str, Any]:
    (folder / "recipe.json").write_text(json.dumps(recipe))
    return sheetmorph.run(folder / "recipe.json", folder / "out")


@pytest.mark.parametrize("form", ["obj", "ascii.ply", "binary.stl", "vtu"])
def test_a_packed_file_is_read_and_written_unpacked(form: str, tmp_path: Path):
    made = plate()
    plain = write_plate(made, tmp_path / f"plate.{form.split('.')[-1]}", form)
    packed = tmp_path / f"{plain.name}.gz"
    packed.write_bytes(gzip.compress(plain.read_bytes()))
    assert np.array_equal(read_part(packed).mesh.points, read_part(plain).mesh.points)
    report = run_in(tmp_path, recipe_of(made, {"file": packed.name}, [0, 0, 5]))
    assert [file.name for file in (tmp_path / "out").iterdir()] == [plain.name]
    assert report["certificate"]["passed"]
    assert find_in_files([packed])["parts"][0]["file"] == str(packed)


def test_a_packed_file_that_is_cut_short_says_so(tmp_path: Path):
    path = tmp_path / "plate.obj.gz"
    path.write_bytes(gzip.compress(b"v 0 0 0\n" * 100)[:-12])
    with pytest.raises(FileError, match="gzip cannot unpack it"):
        read_part(path)


TURN = {"axis": [0, 0, 1], "degrees": 90}


def test_a_placed_part_moves_as_if_drawn_there_and_is_written_in_its_own_coordinates(
    tmp_path: Path,
):
    made = plate()
    place = {"translation": [100.0, -20.0, 7.0], "rotation": TURN}
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    there = made.points @ turn.T + place["translation"]
    write_plate(made, tmp_path / "plate.obj", "obj")
    report = run_in(tmp_path, recipe_of(made, {"file": "plate.obj", "placement": place}, [0, 5, 5]))
    session = sheetmorph.Session(
        recipe_of(made, {}, [0, 5, 5]), {"plate": PartMesh(there, made.triangles)}
    )
    expected = (session.deform().positions["plate"] - place["translation"]) @ turn
    assert read_part(tmp_path / "out" / "plate.obj").mesh.points == pytest.approx(
        expected, abs=1e-9
    )
    assert report["parts"][0]["file"]["error"] < 1e-12
    held = read_part(tmp_path / "out" / "plate.obj").mesh.points[made.left]
    assert np.array_equal(held, made.points[made.left])
    centre = np.mean([entry["center"] for entry in report["found"]["features"]], axis=0)
    assert centre == pytest.approx(turn @ [20.0, 0.0, 0.0] + place["translation"], abs=1e-6)


def test_scale_alone_changes_no_triangle(tmp_path: Path):
    """T-junctions and doubled facets stay: only weld promises to cure them."""
    made = plate(scale=0.001)
    doubled = Plate(
        made.points, np.vstack([made.triangles, made.triangles[:5]]), made.left, made.right
    )
    write_plate(doubled, tmp_path / "plate.obj", "obj")
    report = run_in(tmp_path, recipe_of(made, {"file": "plate.obj", "scale": 1000}, [0, 0, 5]))
    done = report["parts"][0]["preparation"]
    assert (done["welded"], done["removed"], done["split"], done["turned"]) == (0, 0, 0, 0)
    assert report["parts"][0]["triangles"] == len(doubled.triangles)


def test_the_doctor_gives_one_part_in_mm_for_a_file_in_metres(tmp_path: Path):
    made = plate(scale=0.001)
    soup = made.points[made.triangles.ravel()]
    write_plate(
        Plate(soup, np.arange(len(soup)).reshape(-1, 3), [], []), tmp_path / "plate.obj", "obj"
    )
    (unsure,) = diagnose_files([tmp_path / "plate.obj"])["files"]
    assert "scale" not in unsure["part"] and "--unit m" in unsure["findings"][-1]["text"]
    (told,) = diagnose_files([tmp_path / "plate.obj"], unit="m")["files"]
    size = 1000.0 * told["size"]
    assert size / 400.0 < told["suggested_edge"] < size
    entry = told["part"]
    assert entry["scale"] == 1000.0 and entry["weld"] < 1e-3 * size
    recipe = recipe_of(made, {}, [0, 0, 5])
    recipe["parts"] = [{**entry, "remesh": {"edge": told["suggested_edge"]}, "name": "plate"}]
    recipe["fixed"][0]["vertices"] = np.flatnonzero(soup[:, 0] < -0.00999).tolist()
    recipe["handles"][0]["vertices"] = np.flatnonzero(soup[:, 0] > 0.04999).tolist()
    assert run_in(tmp_path, recipe)["certificate"]["passed"]


def test_a_diagnosis_of_a_mesh_has_the_part_without_a_file():
    made = plate()
    told = diagnose(PartMesh(made.points, made.triangles))
    assert "file" not in told["part"]


@pytest.mark.parametrize(
    ("name", "way"),
    [
        ("part.sldprt", "export STEP"),
        ("part.fcstd", "open it in FreeCAD"),
        ("part.3mf", "convert it to PLY or STL"),
        ("part.unv", "meshio convert"),
        ("parts.zip", "unpack it first"),
        ("part.dxf", "make a solid or a sheet from it"),
        ("part.3mf.gz", "convert it to PLY or STL"),
    ],
)
def test_a_format_that_is_not_read_is_refused_with_a_way_to_convert_it(
    name: str, way: str, tmp_path: Path
):
    (tmp_path / name).write_bytes(b"anything")
    with pytest.raises(FileError, match="unknown format") as refused:
        read_part(tmp_path / name)
    assert way in str(refused.value)


def test_a_sheet_of_narrow_bends_is_meshed_anew_in_proportion_to_the_file():
    """Doubled, too, as in the file whose cure never came to an end."""
    strips, length = 720, 60.0
    angles = np.linspace(0.0, 60.0 * np.pi, strips + 1)
    wave = 0.3 * np.column_stack([angles, 0.0 * angles, np.sin(angles)])
    points = np.vstack([wave, wave + (0.0, length, 0.0)])
    first = np.arange(strips)
    one = np.column_stack([first, first + 1, first + strips + 1])
    other = np.column_stack([first + 1, first + strips + 2, first + strips + 1])
    triangles = np.vstack([one, other, one[:50]])
    mesh = PartMesh(points, triangles)
    made, _ = prepared_mesh(load_kernel(), mesh, Wanted(weld=1e-4, edge=5.0))
    assert made.preparation["remesh"]["least_edge"] > 0.0
    assert len(made.triangles) < 20 * len(triangles)
