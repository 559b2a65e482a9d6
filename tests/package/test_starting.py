# SPDX-License-Identifier: LGPL-2.1-or-later
"""`init` writes a recipe that runs, of one file or several, and says what it proposes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
from plates import plate, write_plate
from sheetmorph.cli import main
from sheetmorph.recipe import read_json

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
REAL = [
    "01-riveted-oxygen-bottle-support/W1000BOstat.dat",
    "02-wingbox-skin-and-spars/wingbox_stitched_together-000.bdf",
    "07-deformation-classics/cactus.off",
    "08-isometric-roll-reference/plate4SD.ply",
]


def ran(files: list[str], folder: Path) -> dict:
    """The report of `init` and `run`."""
    recipe, report = folder / "recipe.json", folder / "report.json"
    assert main(["init", *files, "-o", str(recipe), "--quiet"]) == 0
    wanted = ["run", str(recipe), "-o", str(folder / "out"), "--report", str(report), "--quiet"]
    assert main(wanted) == 0
    return json.loads(report.read_text())


def test_a_plate_is_held_at_one_end_and_lifted_at_the_other(tmp_path: Path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_plate(plate(), tmp_path / "plate.obj", "obj")
    report = ran(["plate.obj"], tmp_path)
    recipe = read_json(tmp_path / "recipe.json")
    assert recipe["parts"] == [{"name": "plate", "file": "plate.obj"}]
    assert "// found: 3 round holes" in (tmp_path / "recipe.json").read_text()
    assert len(report["features"]) == 3 and report["certificate"]["passed"]
    rest = plate().points
    moved = sheetmorph.read_part(tmp_path / "out" / "plate.obj").mesh.points
    lift = recipe["pose"]["end"]["translation"]
    assert np.array_equal(moved[plate().left], rest[plate().left])
    assert moved[plate().right] == pytest.approx(rest[plate().right] + lift)
    assert np.linalg.norm(lift) == pytest.approx(0.05 * np.ptp(rest[:, 0]), rel=1e-3)


def test_several_files_are_parts_of_one_assembly(tmp_path: Path, capsys):
    (tmp_path / "meshes").mkdir()
    for name in ("one", "two"):
        write_plate(plate(), tmp_path / "meshes" / f"{name}.stl", "binary.stl")
    files = [str(tmp_path / "meshes" / f"{name}.stl") for name in ("one", "two")]
    report = ran(files, tmp_path)
    assert [part["name"] for part in report["parts"]] == ["one", "two"]
    assert read_json(tmp_path / "recipe.json")["parts"][0]["file"] == "meshes/one.stl"
    capsys.readouterr()
    assert main(["init", *files]) == 0
    assert '"primary": ' in capsys.readouterr().out


def test_init_writes_over_none_of_its_files(tmp_path: Path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    write_plate(plate(), tmp_path / "plate.obj", "obj")
    before = (tmp_path / "plate.obj").read_bytes()
    assert main(["init", "plate.obj", "-o", "plate.obj"]) == 2
    assert main(["init", "lid.obj", "-o", "recipe.json"]) == 2
    assert "lid.obj" in capsys.readouterr().err
    assert (tmp_path / "plate.obj").read_bytes() == before
    assert not (tmp_path / "recipe.json").exists()


@pytest.mark.parametrize("name", REAL)
def test_real_files_are_morphs_at_once(name: str, tmp_path: Path):
    if not DATA.is_dir():
        pytest.skip("the shared data is not beside the project")
    report = ran([str(DATA / name)], tmp_path)
    assert report["certificate"]["passed"]
    assert max(part["largest_displacement"] for part in report["parts"]) > 0.0
