# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study makes variants of a recipe: sampled, certified, measured, told in one table."""

from __future__ import annotations

import json
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
from sheetmorph.certifying import certify, read_criteria
from sheetmorph.cli import main
from sheetmorph.pictures import drawing
from study_samples import contents, rows_of, write_recipe, write_study

LIFT = {"path": "pose.tip.translation[2]", "range": [0, 10]}
SIZE = {"path": "features.hole0.size", "values": [7.5, 8, 8.5]}


def study(folder: Path, *options: str, **keys) -> Path:
    """The folder of a study that was computed."""
    path = write_study(folder, **keys)
    assert main(["study", str(path), "-o", str(folder / "out"), "--quiet", *options]) == 0
    return folder / "out"


def test_every_variant_has_its_files_and_a_row(tmp_path: Path):
    out = study(tmp_path, measure={"tip": {"position": "tip", "axis": "z"}})
    rows = rows_of(out)
    assert list(rows[0]) == ["run", "lift", "tip", "status", "why"]
    assert [row["run"] for row in rows] == ["0", "1", "2", "3"]
    for row in rows:
        folder = out / f"{int(row['run']):06d}"
        assert row["status"] == "passed" and row["why"] == ""
        names = sorted(path.name for path in folder.iterdir())
        assert names == ["certificate.json", "parameters.json", "plate.obj"]
        told = json.loads((folder / "parameters.json").read_text())
        assert told["parameters"]["lift"] == float(row["lift"])
        assert float(row["tip"]) == pytest.approx(float(row["lift"]), abs=1e-12)
        proof = json.loads((folder / "certificate.json").read_text())
        assert proof["passed"] and proof["failures"] == []


def test_certificates_are_those_of_certify(tmp_path: Path):
    jsonschema = pytest.importorskip("jsonschema")
    out = study(tmp_path, parameters={"lift": {**LIFT, "steps": 2}}, sampling={}, certify="static")
    schema = Path(sheetmorph.__file__).parent / "certifying" / "certificate.schema.json"
    found = json.loads((out / "000001" / "certificate.json").read_text())
    jsonschema.validate(found, json.loads(schema.read_text()))
    recipe = json.loads((tmp_path / "recipe.json").read_text())
    recipe["pose"]["tip"]["translation"][2] = 10
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    single = certify(tmp_path / "recipe.json", out / "000001", read_criteria("static"))
    own = {key: found[key] for key in single if key != "inputs"}
    assert own == {key: value for key, value in single.items() if key != "inputs"}
    assert found["study"]["measures"] == {} and found["study"]["pose"] == recipe["pose"]


def test_elements_that_newly_fail_fail_a_variant(tmp_path: Path):
    criteria = {"elements": {"min_angle": {"min": 44.999}}}
    (tmp_path / "mine.json").write_text(json.dumps(criteria))
    lift = {"path": LIFT["path"], "values": [30]}
    out = study(tmp_path, parameters={"lift": lift}, sampling=None, certify="mine.json")
    (row,) = rows_of(out)
    assert row["status"] == "failed" and "newly fail the criteria" in row["why"]


def test_certificates_alone_are_of_files_all_the_same(tmp_path: Path):
    whole = contents(study(tmp_path))
    found = contents(study(tmp_path, write=["certificate"]))
    alone = {name: data for name, data in found.items() if ".kept" not in name}
    for name, data in alone.items():
        if name.endswith("certificate.json"):
            assert data == whole[name] and json.loads(data)["outputs"][0]["file"] == "plate.obj"
    assert not any(name.endswith(".obj") for name in alone)


def test_a_variant_is_what_run_makes_of_the_changed_recipe(tmp_path: Path):
    parameters = {"lift": LIFT, "angle": {"path": "pose.tip.rotation.degrees", "range": [-20, 0]}}
    out = study(tmp_path, parameters=parameters)
    row = rows_of(out)[2]
    recipe = json.loads((tmp_path / "recipe.json").read_text())
    pose = recipe["pose"]
    pose["tip"]["translation"][2] = float(row["lift"])
    pose["tip"]["rotation"]["degrees"] = float(row["angle"])
    sheetmorph.run(tmp_path / "recipe.json", tmp_path / "single", pose)
    single = (tmp_path / "single" / "plate.obj").read_bytes()
    assert (out / "000002" / "plate.obj").read_bytes() == single


def test_a_size_is_a_pose_and_makes_the_hole_as_wide(tmp_path: Path):
    out = study(
        tmp_path,
        parameters={"wide": SIZE},
        sampling=None,
        measure={"hole": {"diameter": "hole0"}, "other": {"diameter": "hole1"}},
    )
    rows = rows_of(out)
    assert [float(row["hole"]) for row in rows] == pytest.approx([7.5, 8.0, 8.5], abs=1e-9)
    assert [float(row["other"]) for row in rows] == pytest.approx([8.0] * 3, abs=1e-9)


def test_measures_are_what_the_files_hold(tmp_path: Path):
    out = study(
        tmp_path,
        parameters={"lift": LIFT, "sheet": {"range": [1, 2]}},
        measure={
            "corner": {"position": {"part": "plate", "near": [50, 10, 0]}},
            "far": {"distance": ["wall", "tip"]},
            "area": {"area": ["plate"]},
            "mass": {"mass": ["plate"], "thickness": "sheet", "density": 1e-5},
            "thin": {"expression": "mass / area * 1e5"},
            "angle": {"worst": "angle", "part": "plate"},
        },
    )
    for row in rows_of(out):
        mesh = sheetmorph.read_part(out / f"{int(row['run']):06d}" / "plate.obj").mesh
        rest = sheetmorph.read_part(tmp_path / "plate.obj").mesh.points
        corner = np.linalg.norm(rest - [50, 10, 0], axis=1).argmin()
        found = [float(row[f"corner.{axis}"]) for axis in "xyz"]
        assert found == pytest.approx(mesh.points[corner].tolist(), abs=1e-12)
        a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
        assert float(row["area"]) == pytest.approx(area, rel=1e-12)
        assert float(row["mass"]) == pytest.approx(area * float(row["sheet"]) * 1e-5, rel=1e-12)
        assert float(row["thin"]) == pytest.approx(float(row["sheet"]), rel=1e-12)


def test_poses_are_blended_by_their_shares(tmp_path: Path):
    parameters = {
        "up": {"blend": "up", "range": [0, 1]},
        "turn": {"blend": "turned", "values": [2]},
    }
    out = study(tmp_path, parameters=parameters, measure={"tip": {"position": "tip", "axis": "z"}})
    for row in rows_of(out):
        assert float(row["tip"]) == pytest.approx(12 + 12 * float(row["up"]), abs=1e-9)
        run = out / f"{int(row['run']):06d}" / "certificate.json"
        pose = json.loads(run.read_text())["study"]["pose"]
        assert pose["tip"]["rotation"]["degrees"] == pytest.approx(45.0)
        assert pose["tip"]["rotation"]["axis"] == pytest.approx([0, -1, 0])


def test_a_distance_and_a_direction_move_the_handle(tmp_path: Path):
    at = {"path": "pose.tip.translation", "distance_from": "wall", "range": [65, 75]}
    up = {"path": "pose.tip.translation", "direction": [0, 3, 4], "values": [0]}
    recipe = json.loads(write_recipe(tmp_path).read_text())
    recipe["pose"] = {}
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    measure = {"far": {"distance": ["wall", "tip"]}}
    out = study(tmp_path, parameters={"at": at, "up": up}, measure=measure)
    for row in rows_of(out):
        assert float(row["far"]) == pytest.approx(float(row["at"]), abs=1e-9)


@pytest.mark.parametrize("method", ["latin hypercube", "sobol", "halton"])
def test_samples_fill_the_ranges_and_are_the_same_again(tmp_path: Path, method: str):
    from sheetmorph.study import read_study
    from sheetmorph.study.sampling import samples_of

    parameters = {"a": {"range": [-1, 1]}, "b": {"range": [5, 9]}, "c": {"values": [1, 2, 3, 4]}}
    sampling = {"method": method, "count": 64, "seed": 5}
    found = read_study(write_study(tmp_path, parameters=parameters, sampling=sampling))
    samples = samples_of(found)
    assert samples == samples_of(found) and len(samples) == 64
    a = np.array([sample["a"] for sample in samples])
    assert a.min() >= -1 and a.max() <= 1
    assert np.histogram(a, 8, (-1, 1))[0].min() >= 4
    assert {sample["c"] for sample in samples} == {1, 2, 3, 4}


def test_a_full_grid_has_every_combination(tmp_path: Path):
    out = study(
        tmp_path,
        parameters={"lift": {**LIFT, "steps": 3}, "wide": SIZE},
        sampling={"method": "full grid"},
    )
    rows = [(float(row["lift"]), float(row["wide"])) for row in rows_of(out)]
    assert rows == [(x, y) for x in (0, 5, 10) for y in (7.5, 8, 8.5)]


def test_samples_of_a_csv_are_taken_as_they_are(tmp_path: Path):
    (tmp_path / "samples.csv").write_text("note,lift\nfirst,1.5\n\nsecond,20\n")
    out = study(tmp_path, sampling={"file": "samples.csv"})
    rows = rows_of(out)
    assert [row["lift"] for row in rows] == ["1.5", "20.0"]
    assert [row["status"] for row in rows] == ["passed", "refused"]
    assert rows[1]["why"] == "lift = 20 is outside 0 to 10"


def test_what_no_constraint_allows_is_refused_and_costs_nothing(tmp_path: Path):
    study(
        tmp_path,
        parameters={"lift": {**LIFT, "steps": 4}, "wide": SIZE},
        sampling={"method": "full grid"},
        constraints=["lift + 2 * wide <= 20"],
    )
    rows = rows_of(tmp_path / "out")
    for row in rows:
        possible = float(row["lift"]) + 2 * float(row["wide"]) <= 20
        assert row["status"] == ("passed" if possible else "refused")
    costs = json.loads((tmp_path / "out" / "costs.json").read_text())
    assert costs["computed"] == sum(row["status"] == "passed" for row in rows) < len(rows)


def test_what_breaks_a_criterion_fails_and_has_no_parts(tmp_path: Path):
    out = study(
        tmp_path,
        parameters={"lift": {**LIFT, "steps": 2}},
        sampling={"method": "full grid"},
        measure={"z": {"position": "tip", "axis": "z"}},
        criteria={"z": {"max": 5}},
    )
    low, high = rows_of(out)
    assert (low["status"], high["status"]) == ("passed", "failed")
    assert high["why"] == "z is 10 (at most 5 allowed)"
    assert not (out / "000001" / "plate.obj").exists()
    proof = json.loads((out / "000001" / "certificate.json").read_text())
    assert proof["failures"] == [high["why"]]


def test_what_the_kernel_refuses_is_a_row_that_says_why(tmp_path: Path):
    wide = {"path": "features.hole0.size", "values": [8, 19.9]}
    out = study(tmp_path, parameters={"wide": wide}, sampling=None)
    good, bad = rows_of(out)
    assert (good["status"], bad["status"]) == ("passed", "refused")
    assert "hole0" in bad["why"]
    assert sorted(path.name for path in (out / "000001").iterdir()) == ["parameters.json"]


def test_what_needs_other_preprocessing_gets_it(tmp_path: Path):
    parameters = {"along": {"path": "handles.tip.pivot[0]", "range": [40, 60]}}
    parameters |= {"kept": {"path": "fixed[0].vertices[0]", "values": [3, 4]}}
    recipe = json.loads(write_recipe(tmp_path).read_text())
    recipe["handles"][0]["pivot"] = [50, 0, 0]
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    out = study(tmp_path, parameters=parameters)
    assert {row["status"] for row in rows_of(out)} == {"passed"}


def test_pictures_and_the_page_are_whole(tmp_path: Path):
    out = study(tmp_path, write=["pictures"])
    for run in range(4):
        folder = out / f"{run:06d}"
        names = sorted(path.name for path in folder.iterdir())
        assert names == ["parameters.json", "picture.png"]
        assert (folder / "picture.png").read_bytes().startswith(b"\x89PNG")
    page = (out / "summary.html").read_text()
    assert page.count("iVBOR") == 4
    assert "http:" not in page.replace("http://www.w3.org/2000/svg", "") and "https:" not in page


def test_names_on_the_page_are_text_even_if_they_look_like_code(tmp_path: Path):
    evil = "</script><script>alert(1)</script>"
    lift = {"path": "pose.tip.translation[2]", "values": [1, 2]}
    out = study(tmp_path, parameters={evil: lift}, sampling=None)
    page = (out / "summary.html").read_text()
    assert page.count("<script>") == 1 and "\\u003cscript\\u003e" in page


def test_a_missing_program_costs_the_pictures_and_the_next_call_draws_them(tmp_path, monkeypatch):
    with monkeypatch.context() as without:
        without.setattr(drawing.shutil, "which", lambda _: None)
        out = study(tmp_path, write=["pictures"])
        assert [row["status"] for row in rows_of(out)] == ["passed"] * 4
        assert "Some are missing: no picture can be drawn; install xvfb." in page_of(out)
        before = contents(out)
        study(tmp_path, write=["pictures"])
        assert contents(out) == before and computed(out) == 0
    study(tmp_path, write=["pictures"])
    assert computed(out) == 4 and page_of(out).count("iVBOR") == 4
    assert "missing" not in page_of(out)


def test_a_killed_painter_costs_one_picture_and_no_variant(tmp_path: Path, monkeypatch, capsys):
    draw, drawn = drawing.Painter.draw, []

    def draw_or_die(painter: drawing.Painter, scene: object) -> bytes:
        drawn.append(scene)
        if len(drawn) == 2:
            painter.process.kill()
        return draw(painter, scene)

    monkeypatch.setattr(drawing.Painter, "draw", draw_or_die)
    out = study(tmp_path, write=["pictures"])
    assert [row["status"] for row in rows_of(out)] == ["passed"] * 4
    assert sorted(path.parent.name for path in out.glob("0*/picture.png")) == [
        "000000",
        "000002",
        "000003",
    ]
    assert "1 variant(s) without a picture: VTK could not draw" in capsys.readouterr().out


def page_of(out: Path) -> str:
    return (out / "summary.html").read_text()


def computed(out: Path) -> int:
    """Return how many variants the last call computed."""
    return int(json.loads((out / "costs.json").read_text())["computed"])


def test_decks_are_written_as_decks(tmp_path: Path):
    write_recipe(tmp_path, "nas")
    out = study(tmp_path, write=["decks", "certificate"])
    assert (out / "000003" / "plate.nas").is_file()


def test_a_second_call_computes_nothing_and_changes_nothing(tmp_path: Path):
    out = study(tmp_path)
    before = contents(out)
    assert study(tmp_path) == out
    assert contents(out) == before
    assert json.loads((out / "costs.json").read_text())["computed"] == 0


def test_more_samples_keep_what_was_computed(tmp_path: Path):
    sampling = {"method": "halton", "count": 3, "seed": 2}
    out = study(tmp_path, sampling=sampling)
    kept = contents(out)
    study(tmp_path, sampling={**sampling, "count": 5})
    assert json.loads((out / "costs.json").read_text())["computed"] == 2
    new = contents(out)
    assert all(new[name] == data for name, data in kept.items() if name.startswith("0"))


def test_a_changed_part_is_computed_again_and_a_moved_variant_is_not(tmp_path: Path):
    values = {"path": "pose.tip.translation[2]", "values": [1, 2, 3]}
    out = study(tmp_path, parameters={"lift": values}, sampling=None)
    third = (out / "000002" / "plate.obj").read_bytes()
    study(tmp_path, parameters={"lift": {**values, "values": [3, 4]}}, sampling=None)
    assert json.loads((out / "costs.json").read_text())["computed"] == 1
    assert (out / "000000" / "plate.obj").read_bytes() == third
    assert not (out / "000002").exists()
    part = tmp_path / "plate.obj"
    part.write_text(part.read_text() + "# another one\n")
    study(tmp_path, parameters={"lift": {**values, "values": [3, 4]}}, sampling=None)
    assert json.loads((out / "costs.json").read_text())["computed"] == 2


def test_processes_make_the_same_files(tmp_path: Path):
    keys = {
        "measure": {"far": {"distance": ["wall", "tip"]}},
        "write": ["parts", "certificate", "pictures"],
    }
    one = contents(study(tmp_path, **keys))
    shutil.rmtree(tmp_path / "out")
    two = contents(study(tmp_path, "--engine", "processes", "--workers", "2", **keys))
    assert one == two


def test_a_study_that_is_killed_goes_on_to_the_same_end(tmp_path: Path):
    parameters = {"lift": LIFT}
    sampling = {"method": "halton", "count": 40, "seed": 1}
    whole = contents(study(tmp_path, parameters=parameters, sampling=sampling))
    shutil.rmtree(tmp_path / "out")
    command = [sys.executable, "-m", "sheetmorph", "study", str(tmp_path / "study.json"), "--quiet"]
    command += ["-o", str(tmp_path / "out")]
    for after in (3, 17):
        with subprocess.Popen(command) as running:
            while len(list(tmp_path.glob("out/0*"))) < after and running.poll() is None:
                time.sleep(0.005)
            running.send_signal(signal.SIGKILL)
    assert subprocess.run(command, check=False, capture_output=True).returncode == 0
    assert contents(tmp_path / "out") == whole


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ({"sampling": {"method": "sobol"}}, "the count is missing"),
        ({"sampling": {"method": "csv"}}, "a CSV file needs the method csv"),
        ({"sampling": {"method": "dice", "count": 3}}, '"dice" is not a way of sampling'),
        ({"parameters": {}}, "parameters: "),
        ({"recipe": "none.json"}, "cannot be read"),
        ({"turns": 3}, 'unknown key "turns"'),
        (
            {"parameters": {"a": {"path": "pose.tap.size", "range": [0, 1]}}},
            'feature or point "tap"',
        ),
        ({"parameters": {"a": {"path": "features.slot.size", "range": [0, 1]}}}, 'no "slot"'),
        ({"parameters": {"a": {"path": "pose..tip", "range": [0, 1]}}}, "is not a path"),
        ({"parameters": {"a": {"path": "pose.tip", "range": [0, 1]}}}, "not to a number"),
        ({"parameters": {"a": {"path": "energy", "range": [0, 1]}}}, "energy: "),
        ({"parameters": {"a": {"range": [1, 0]}}}, "the first number is larger"),
        ({"parameters": {"a": {}}}, "it has no range"),
        ({"parameters": {"status": {"range": [0, 1]}}}, "use another name"),
        ({"parameters": {"a": {"blend": "down", "range": [0, 1]}}}, 'no pose "down"'),
        ({"constraints": ["lift <"]}, "is not a formula"),
        ({"constraints": ["lift + 1"]}, "compares nothing"),
        ({"constraints": ["__import__('os') < 1"]}, "something that a formula cannot have"),
        ({"constraints": ["lift.real < 1"]}, "something that a formula cannot have"),
        ({"constraints": ["height < 1"]}, 'an unknown name, "height"'),
        ({"measure": {"m": {}}}, "it measures nothing"),
        ({"measure": {"m": {"diameter": "slot"}}}, 'no form feature "slot"'),
        ({"measure": {"m": {"position": "nose"}}}, 'no region "nose"'),
        ({"measure": {"m": {"mass": ["plate"]}}}, "the thickness is missing"),
        ({"measure": {"m": {"gap": ["plate", "lid"]}}}, 'no part "lid"'),
        ({"criteria": {"beauty": {"min": 1}}}, 'no measure "beauty"'),
        ({"criteria": {"angle": {"least": 1}}}, 'unknown key "least"'),
    ],
)
def test_what_is_wrong_with_a_study_is_said_and_nothing_is_written(tmp_path, capsys, keys, said):
    path = write_study(tmp_path, **keys)
    assert main(["study", str(path), "-o", str(tmp_path / "out")]) == 2
    text = capsys.readouterr().err
    assert said in text and "Traceback" not in text
    assert not (tmp_path / "out").exists()


def test_what_stands_in_the_folder_already_is_not_thrown_away(tmp_path: Path, capsys):
    (tmp_path / "out" / "000001").mkdir(parents=True)
    (tmp_path / "out" / "000001" / "thesis.txt").write_text("years of work")
    path = write_study(tmp_path)
    assert main(["study", str(path), "-o", str(tmp_path / "out")]) == 2
    assert "contains files that this study did not write: thesis.txt" in capsys.readouterr().err
    assert (tmp_path / "out" / "000001" / "thesis.txt").read_text() == "years of work"
    assert main(["study", str(path), "-o", str(tmp_path)]) == 2


def test_runs_are_computed_block_by_block(tmp_path: Path):
    whole = contents(study(tmp_path))
    shutil.rmtree(tmp_path / "out")
    for block in ("2-3", "0-1"):
        study(tmp_path, "--runs", block)
    assert not (tmp_path / "out" / "summary.csv").exists()
    assert contents(study(tmp_path)) == whole
    assert json.loads((tmp_path / "out" / "costs.json").read_text())["computed"] == 0


def test_snakemake_gets_a_file_that_computes_the_study(tmp_path: Path):
    whole = contents(study(tmp_path))
    shutil.rmtree(tmp_path / "out")
    out = study(tmp_path, "--engine", "snakemake", "--workers", "2")
    assert (out / "Snakefile").is_file()
    if shutil.which("snakemake") is None:
        pytest.skip("snakemake is not installed: the Snakefile was written, not run")
    words = ["snakemake", "-s", str(out / "Snakefile"), "--cores", "2", "-q", "-d", str(tmp_path)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    made = contents(out)
    assert {name: made[name] for name in whole} == whole


def test_slurm_gets_an_array_and_a_job_behind_it(tmp_path: Path, monkeypatch):
    calls = tmp_path / "calls"
    fake = tmp_path / "bin" / "sbatch"
    fake.parent.mkdir()
    fake.write_text(f'#!/bin/sh\necho "$@" >> {calls}\necho 4711\n')
    fake.chmod(0o755)
    monkeypatch.setenv("PATH", f"{fake.parent}:/usr/bin:/bin")
    out = study(tmp_path, "--engine", "slurm", "--workers", "2")
    text = (out / "study.sbatch").read_text()
    assert "#SBATCH --array=0-1" in text and "first=(0 2)" in text and "last=(1 3)" in text
    assert "--dependency=afterany:4711" in calls.read_text()
    for task in ("0", "1"):
        environment = {"PATH": "/usr/bin:/bin", "SLURM_ARRAY_TASK_ID": task}
        subprocess.run(["bash", str(out / "study.sbatch")], check=True, env=environment)
    assert len(list(out.glob("0*/plate.obj"))) == 4


DOCUMENTS = Path(__file__).resolve().parents[2] / "resources" / "docs"


def test_the_examples_of_the_document_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    recipe, text = ((DOCUMENTS / name).read_text("utf-8") for name in ("recipe.md", "studies.md"))
    for name, kind, source in (
        ("recipe.json", "json", recipe),
        ("strip.obj", "obj", recipe),
        ("study.json", "json", text),
    ):
        block = re.search(rf"^```{kind}\n(.*?)^```$", source, re.DOTALL | re.MULTILINE)
        (tmp_path / name).write_text(block.group(1))
    assert main(["study", str(tmp_path / "study.json"), "-o", str(tmp_path / "out")]) == 0
    rows = rows_of(tmp_path / "out")
    assert len(rows) == 8 and {row["status"] for row in rows} >= {"passed"}
    monkeypatch.chdir(tmp_path)
    code = re.search(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE).group(1)
    names: dict[str, object] = {}
    exec(compile(code, "studies.md", "exec"), names)
    assert set(names["measures"]) == {"tip.x", "tip.y", "tip.z", "stretch"}
