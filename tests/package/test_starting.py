# SPDX-License-Identifier: LGPL-2.1-or-later
"""`init` writes a recipe that runs, of one file or several, and says what it proposes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
from sheet_meshes import circle, flat, lifted, polygon
from sheetmorph.cli import main
from sheetmorph.recipe.reading import read_json

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
REAL = [
    "01-riveted-oxygen-bottle-support/W1000BOstat.dat",
    "02-wingbox-skin-and-spars/wingbox_stitched_together-000.bdf",
    "07-deformation-classics/cactus.off",
    "08-isometric-roll-reference/plate4SD.ply",
]


def holed(path: Path, shift: float = 0.0) -> np.ndarray:
    """Writes a sheet of 120 x 60 mm with three round holes; its vertices (n, 3)."""
    outline = polygon([(0, 0), (120, 0), (120, 60), (0, 60)], 3.0)
    rims = [circle((x, 30.0), 6.0, 24) for x in (30.0, 60.0, 90.0)]
    flat_points, triangles = flat(outline, rims, 3.0)
    points = lifted(flat_points, shift)
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()]
    path.write_text("\n".join(lines) + "\n")
    return points


def ran(files: list[str], folder: Path) -> dict:
    """The report of `init` and `run`."""
    recipe, report = folder / "recipe.json", folder / "report.json"
    assert main(["init", *files, "-o", str(recipe), "--quiet"]) == 0
    wanted = ["run", str(recipe), "-o", str(folder / "out"), "--report", str(report), "--quiet"]
    assert main(wanted) == 0
    return json.loads(report.read_text())


def test_a_sheet_is_held_at_one_end_and_lifted_at_the_other(tmp_path: Path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    rest = holed(tmp_path / "sheet.obj")
    report = ran(["sheet.obj"], tmp_path)
    recipe = read_json(tmp_path / "recipe.json")
    assert recipe["parts"] == [{"name": "sheet", "file": "sheet.obj"}]
    assert "// found: 3 round holes" in (tmp_path / "recipe.json").read_text()
    assert len(report["features"]) == 3 and report["certificate"]["passed"]
    moved = sheetmorph.read_part(tmp_path / "out" / "sheet.obj").mesh.points
    lift = np.array(recipe["pose"]["end"]["translation"])
    left, right = rest[:, 0] <= 6.0, rest[:, 0] >= 114.0
    assert np.array_equal(moved[left], rest[left])
    assert moved[right] == pytest.approx(rest[right] + lift)
    assert lift.tolist() == [0.0, 0.0, 6.0]


def test_several_files_are_parts_of_one_assembly(tmp_path: Path, capsys):
    (tmp_path / "meshes").mkdir()
    files = [str(tmp_path / "meshes" / f"{name}.obj") for name in ("one", "two")]
    for number, file in enumerate(files):
        holed(Path(file), 1.5 * number)
    report = ran(files, tmp_path)
    assert [part["name"] for part in report["parts"]] == ["one", "two"]
    assert {contact["type"] for contact in report["contacts"]} >= {"rigid"}
    assert read_json(tmp_path / "recipe.json")["parts"][0]["file"] == "meshes/one.obj"
    capsys.readouterr()
    assert main(["init", *files]) == 0
    assert '"primary": ' in capsys.readouterr().out


def test_init_writes_over_none_of_its_files(tmp_path: Path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    holed(tmp_path / "plate.obj")
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
