# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deformed CAD parts written as CAD: the same faces on new surfaces, holes still cylinders."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import sheetmorph
from cad_samples import make_cad_samples
from sheetmorph import CertificateError, RecipeError, read_part, run
from sheetmorph.cli import main
from sheetmorph.reporting.report import report_schema

MESH = {"edge": 5.0, "deflection": 0.1, "angle": 20}


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of CAD files."""
    return make_cad_samples(tmp_path_factory.mktemp("cad"))


@pytest.fixture
def folder(samples: Path, tmp_path: Path) -> Path:
    """The same in a folder of the test's own."""
    for file in samples.glob("*.*"):
        if file.suffix in (".step", ".igs", ".brep"):
            shutil.copy(file, tmp_path)
    return tmp_path


def lifted(folder: Path, file: str, lift: float = 6.0, **part: object) -> Path:
    """A recipe that lifts one end of the plate in a file by so many mm; its holes stay round."""
    entry = {"name": "plate", "file": file, "mesh": MESH, **part}
    points = read_part(folder / file, MESH).mesh.points
    x, y = points[:, 0], points[:, 1]
    holes = {
        f"hole {k}": np.flatnonzero(np.abs(np.hypot(x - at, y - 20.0) - radius) < 1e-4)
        for k, (at, radius) in enumerate(((15.0, 3.0), (40.0, 5.0)))
    }
    recipe = {
        "sheetmorph": 1,
        "parts": [entry],
        "fixed": [{"part": "plate", "vertices": np.flatnonzero(x < 1e-6).tolist()}],
        "handles": [
            {"name": "tip", "part": "plate", "vertices": np.flatnonzero(x > 59.999).tolist()}
        ],
        "features": [
            {"name": name, "part": "plate", "vertices": vertices.tolist()}
            for name, vertices in holes.items()
        ],
        "pose": {"tip": {"translation": [0, 0, lift]}},
    }
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe), "utf-8")
    return path


def only_body(report: dict) -> dict:
    """The one body of the first part's written CAD file."""
    (body,) = report["parts"][0]["shape"]["bodies"]
    return body


@pytest.mark.parametrize(
    ("file", "write", "written"),
    [
        ("plate.brep", "step", "plate.step"),
        ("plate.brep", "brep", "plate.brep"),
        ("plate.igs", "step", "plate.step"),
        ("plate.brep", "iges", "plate.iges"),
    ],
)
def test_a_bent_plate_keeps_its_holes(folder: Path, file: str, write: str, written: str):
    report = run(lifted(folder, file, write=write), folder / "out")
    jsonschema.validate(report, report_schema())
    assert {path.name for path in (folder / "out").iterdir()} == {"plate.obj", written}
    body = only_body(report)
    assert (body["faces"], body["is_valid"]) == (8, True)
    assert body["is_closed"] or not body["was_closed"]
    assert sorted(one["after"] for one in body["cylinders"]) == pytest.approx([3.0, 5.0])
    assert max(one["error"] for one in body["cylinders"]) < 1e-12
    assert body["distance"]["value"] < 0.01
    assert body["gap"]["value"] < 0.0005
    shape = report["parts"][0]["shape"]
    assert (shape["file"], shape["format"]) == (written, write)
    assert shape["bytes"] == (folder / "out" / written).stat().st_size
    again = read_part(folder / "out" / written, MESH)
    assert again.mesh.points[:, 2].max() == pytest.approx(8.0, abs=0.5)


def test_a_hole_of_another_size_is_a_cylinder_of_that_size(folder: Path):
    recipe = json.loads(lifted(folder, "plate.brep", write="step").read_text())
    recipe["features"][1]["size"] = 12.0
    (folder / "recipe.json").write_text(json.dumps(recipe), "utf-8")
    body = only_body(run(folder / "recipe.json", folder / "out"))
    small, large = sorted(body["cylinders"], key=lambda one: one["after"])
    assert small["after"] == pytest.approx(3.0, abs=1e-12)
    assert (large["before"], large["wanted"]) == (5.0, pytest.approx(6.0, abs=1e-9))
    assert large["after"] == pytest.approx(6.0, abs=1e-9)
    assert body["is_valid"] and body["is_closed"]


def with_washer(folder: Path, wide: float) -> dict:
    """The recipe of a plate that is lifted, its larger hole held with all within so many mm."""
    recipe = json.loads(lifted(folder, "plate.brep", write="step").read_text())
    points = read_part(folder / "plate.brep", MESH).mesh.points
    near = np.flatnonzero(np.hypot(points[:, 0] - 40.0, points[:, 1] - 20.0) < wide)
    recipe["features"][1]["vertices"] = near.tolist()
    (folder / "recipe.json").write_text(json.dumps(recipe), "utf-8")
    return recipe


def test_a_washer_is_divided_from_its_face_and_stays_plane(folder: Path):
    recipe = with_washer(folder, 12.0)
    report = run(folder / "recipe.json", folder / "out")
    jsonschema.validate(report, report_schema())
    body = only_body(report)
    assert (body["faces"], body["washers"]) == (10, 2)
    assert body["is_valid"] and body["is_closed"]
    assert body["kept"] == 6  # the held end, both holes, both washers, the far end
    assert body["gap"]["value"] < 0.0005 and body["distance"]["value"] < 0.01
    (part,) = read_part(folder / "out" / "plate.step", MESH).model.parts
    planes = [(one.point, one.axis) for one in part.surfaces if one.kind == "plane"]
    held = np.array(recipe["features"][1]["vertices"])
    rest = read_part(folder / "plate.brep", MESH).mesh.points
    held = held[np.abs(rest[held, 2] - 1.0) > 0.99]  # not inside the wall
    deformed = read_part(folder / "out" / "plate.obj").mesh.points
    off = [np.abs((deformed[held] - point) @ axis) for point, axis in planes]
    assert np.max(np.min(off, axis=0)) < 1e-9


def test_a_thin_solid_is_as_thick_in_the_file_as_in_the_mesh(folder: Path):
    report = run(lifted(folder, "plate.brep", write="step", thin="auto"), folder / "out")
    jsonschema.validate(report, report_schema())
    thickness = only_body(report)["thickness"]
    assert thickness["thickness"] == pytest.approx(2.0)
    assert abs(thickness["largest_change"] - thickness["in_mesh"]) < 0.02


def test_a_rim_alone_is_no_washer(folder: Path):
    with_washer(folder, 5.1)
    body = only_body(run(folder / "recipe.json", folder / "out"))
    assert (body["faces"], body["washers"]) == (8, 0)
    assert body["is_valid"] and body["is_closed"]


def test_at_rest_every_face_is_kept(folder: Path):
    report = run(lifted(folder, "plate.brep", 0.0, write="step"), folder / "out")
    body = only_body(report)
    assert (body["kept"], body["fitted"]) == (8, 0)
    assert body["distance"]["value"] < 1e-9
    assert body["volume_after"] == pytest.approx(body["volume_before"], rel=1e-12)
    exact = 2.0 * (60.0 * 40.0 - np.pi * (3.0**2 + 5.0**2))
    assert body["volume_after"] == pytest.approx(exact, rel=5e-3)


def test_the_command_line_writes_step(folder: Path, capsys: pytest.CaptureFixture):
    recipe = lifted(folder, "plate.brep")
    assert main(["run", str(recipe), "-o", str(folder / "out"), "--step", "--quiet"]) == 0
    assert (folder / "out" / "plate.step").is_file()
    assert "plate.step: 4 faces kept, 4 fitted" in capsys.readouterr().out


def test_an_assembly_comes_back_as_one(folder: Path):
    entry = {"file": "fixture.step", "split": True, "mesh": MESH, "write": "step"}
    recipe = json.loads(lifted(folder, "plate.brep").read_text())
    points = read_part(folder / "fixture.step", MESH)
    names = [f"fixture/{name}" for name in points.bodies]
    recipe["parts"], recipe["primary"], recipe["features"] = [entry], names[0], []
    plate = np.unique(points.mesh.triangles[points.bodies["plate"]])
    x = points.mesh.points[plate, 0]
    recipe["fixed"] = [{"part": names[0], "vertices": plate[x < 1e-6].tolist()}]
    recipe["handles"] = [{"name": "tip", "part": names[0], "vertices": plate[x > 59.999].tolist()}]
    (folder / "assembly.json").write_text(json.dumps(recipe), "utf-8")
    report = run(folder / "assembly.json", folder / "out")
    again = read_part(folder / "out" / "fixture.step", MESH)
    assert list(again.bodies) == list(points.bodies)
    shapes = [part["shape"] for part in report["parts"]]
    assert [len(shape["bodies"]) for shape in shapes] == [1] * len(names)
    assert all(shape["bodies"][0]["is_valid"] for shape in shapes)
    moved = {part["name"]: part["shape"]["bodies"][0]["fitted"] for part in report["parts"]}
    assert [moved[name] for name in names[1:]] == [0, 0]


def test_what_misses_its_tolerance_is_not_written(folder: Path, capsys: pytest.CaptureFixture):
    recipe = lifted(folder, "plate.brep", write="step", write_tolerance=1e-6)
    arguments = ["run", str(recipe), "-o", str(folder / "out"), "--quiet"]
    report = folder / "report.json"
    assert main([*arguments, "--report", str(report)]) == 3
    told = capsys.readouterr().err
    assert 'the STEP of "plate"' in told and "faces" in told and "write_tolerance" in told
    assert not (folder / "out").exists()
    assert not json.loads(report.read_text())["certificate"]["passed"]


def with_a_vertex_off(folder: Path, off: float) -> Path:
    """The recipe of a plate, one vertex of its file so many mm away from its edges."""
    plate = folder / "plate.brep"
    text, count = re.subn(
        r"(Ve\n1e-07\n60 40 )2\n", rf"\g<1>{2.0 + off}\n", plate.read_text("utf-8")
    )
    assert count == 1
    recipe = lifted(folder, "plate.brep", write="step")
    plate.write_text(text, "utf-8")
    return recipe


def test_a_shape_that_is_nearly_valid_is_healed_and_told(folder: Path):
    report = run(with_a_vertex_off(folder, 0.004), folder / "out")
    jsonschema.validate(report, report_schema())
    body = only_body(report)
    assert body["is_valid"] and body["was_valid"] and body["faults_before"] == []
    assert re.match(r"face \d+: .*a vertex is off", body["healed"][0])
    assert 0.003 < body["healed_within"] < 0.01
    assert "it was healed within" in json.dumps(report)


def test_a_shape_that_is_not_valid_is_refused_with_face_and_reason(folder: Path):
    recipe = with_a_vertex_off(folder, 0.5)
    with pytest.raises(
        CertificateError, match=r"not a valid shape before .*face \d+: .*vertex is off"
    ):
        run(recipe, folder / "out")
    assert not (folder / "out").exists()


@pytest.mark.parametrize("stage", ["carrying", "writing", "reading it again", "measuring"])
def test_a_cancelled_run_leaves_no_file(stage: str, folder: Path):
    recipe = lifted(folder, "plate.brep", write="step")
    before = set(folder.iterdir())
    with pytest.raises(RuntimeError, match="cancel"):
        run(recipe, folder / "out", progress=lambda _, task: not task.startswith(stage))
    assert set(folder.iterdir()) == before


def test_ctrl_c_while_a_shape_is_carried_leaves_no_file(folder: Path):
    recipe = lifted(folder, "plate.brep", write="step")
    before = set(folder.iterdir())
    script = (
        "import sys, time, sheetmorph.cli.progress as told\n"
        "from sheetmorph.cli import main\n"
        "def tell(self, fraction, task):\n"
        "    if task.startswith('carrying'):\n"
        "        print('carrying', flush=True)\n"
        "        time.sleep(30)\n"
        "    return True\n"
        "told._Line.tell = tell\n"
        "sys.exit(main(['run', sys.argv[1], '-o', sys.argv[2]]))\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", script, str(recipe), str(folder / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(Path(sheetmorph.__file__).parent.parent)},
    )  # fmt: skip
    assert process.stdout.readline() == "carrying\n"
    process.send_signal(signal.SIGINT)
    _, error = process.communicate(timeout=60)
    assert (process.returncode, error) == (130, "interrupted: no part was written\n")
    assert set(folder.iterdir()) == before


def test_a_mesh_that_folds_is_refused(folder: Path):
    recipe = json.loads(lifted(folder, "plate.brep", write="step").read_text())
    recipe["pose"]["tip"] = {
        "translation": [-70, 0, 0],
        "rotation": {"axis": [1, 0, 0], "degrees": 170},
    }
    (folder / "recipe.json").write_text(json.dumps(recipe), "utf-8")
    with pytest.raises(CertificateError, match="its mesh folds"):
        run(folder / "recipe.json", folder / "out")
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("part", "text"),
    [
        ({"write": "dxf"}, "CAD format"),
        ({"write": "step", "write_tolerance": 0}, "a distance in mm"),
        ({"write": "step", "remesh": {"edge": 2.0}}, "another mesh than that"),
    ],
)
def test_what_cannot_be_written_is_told(folder: Path, part: dict, text: str):
    with pytest.raises(RecipeError, match=text):
        run(lifted(folder, "plate.brep", **part), folder / "out")


def test_a_mesh_is_no_shape(folder: Path):
    run(lifted(folder, "plate.brep"), folder / "mesh")
    recipe = json.loads((folder / "recipe.json").read_text())
    recipe["parts"] = [{"name": "plate", "file": "mesh/plate.obj", "write": "step"}]
    (folder / "recipe.json").write_text(json.dumps(recipe), "utf-8")
    with pytest.raises(RecipeError, match="is not a CAD file"):
        run(folder / "recipe.json", folder / "out")
    del recipe["parts"][0]["write"]
    (folder / "recipe.json").write_text(json.dumps(recipe), "utf-8")
    with pytest.raises(RecipeError, match="--step"):
        run(folder / "recipe.json", folder / "out", step=True)
