# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m sheetmorph: exit status, messages, and that errors leave nothing behind."""

from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from plates import plate, save_recipe
import sheetmorph
from sheetmorph import Result, Session
from sheetmorph.cli import main
from sheetmorph.reporting.report import report_schema


def change(folder: Path, **entries: object) -> None:
    """Exchange entries of the recipe in a folder."""
    recipe = json.loads((folder / "recipe.json").read_text())
    save_recipe({**recipe, **entries}, folder)


def tree(folder: Path) -> dict[str, bytes]:
    """All files below a folder with their content, and the folders."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else b"folder"
        for path in folder.rglob("*")
    }


def test_run_writes_parts_and_report(folder: Path, capsys):
    status = main(["run", "recipe.json", "-o", "out", "--report", "report.json"])
    assert status == 0
    assert os.listdir(folder / "out") == ["plate.obj"]
    assert json.loads((folder / "report.json").read_text())["certificate"]["passed"] is True
    assert "1 part written; 3 form features rigid" in capsys.readouterr().out


def test_check_says_valid_and_writes_nothing(folder: Path, capsys):
    before = tree(folder)
    assert main(["check", "recipe.json"]) == 0
    assert capsys.readouterr().out == "recipe.json: valid\n"
    assert tree(folder) == before


def test_a_pose_file_replaces_the_pose(folder: Path):
    (folder / "pose.json").write_text(json.dumps({"tip": {"translation": [0, 0, 1]}}))
    assert main(["run", "recipe.json", "-o", "out", "--pose", "pose.json"]) == 0
    rest = sheetmorph.read_part("plate.obj").mesh.points
    deformed = sheetmorph.read_part("out/plate.obj").mesh.points
    right = plate().right
    assert deformed[right].tolist() == (rest[right] + [0, 0, 1]).tolist()


BAD_RUNS = [
    ({"margin": 1}, [], "margin: not available in this version"),
    ({"fixed": [{"part": "plate", "vertices": [10**6]}]}, [], "fixed[0].vertices"),
    ({"parts": [{"name": "plate", "file": "lid.obj"}]}, [], "the file does not exist"),
    ({"handles": [], "pose": {}, "fixed": []}, [], "there is no fixed region and no handle"),
    ({}, ["--pose", "missing.json"], "missing.json: cannot be read"),
    ({}, ["-o", "."], "would overwrite the source file"),
    ({}, ["-o", "plate.obj"], "plate.obj is not a folder"),
    ({}, ["--report", "out/plate.obj"], "is the file of a part"),
    ({}, ["--report", "no/such/folder/report.json"], "its folder does not exist"),
]


@pytest.mark.parametrize("bad", BAD_RUNS, ids=[message for *_, message in BAD_RUNS])
def test_bad_input_exits_with_2_and_writes_nothing(bad: tuple, folder: Path, capsys):
    entries, options, message = bad
    change(folder, **entries)
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "out", *options]) == 2
    error = capsys.readouterr().err
    assert message in error
    assert all("; " in line for line in error.strip().split("\n"))
    assert tree(folder) == before


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "recipe.json, line 1, column 2: not JSON"),
        ('{"sheetmorph": 1, "sheetmorph": 1}', 'the key "sheetmorph" appears twice'),
        ('{"sheetmorph": 1, "parts": [NaN]}', "not a number (NaN)"),
        ("[" * 100000, "not JSON"),
        ("", "not JSON"),
    ],
)
def test_a_file_that_is_not_json_is_bad_input(text: str, message: str, folder: Path, capsys):
    (folder / "recipe.json").write_text(text)
    assert main(["check", "recipe.json"]) == 2
    assert message in capsys.readouterr().err


def test_a_pose_of_the_recipe_is_chosen_by_its_name(folder: Path):
    recipe = json.loads((folder / "recipe.json").read_text())
    pose = recipe["pose"]
    name = next(iter(pose))
    recipe["poses"] = {"open": pose, "half": {name: {"translation": [0, 0, 5]}}}
    recipe["pose"] = {}
    (folder / "recipe.json").write_text(json.dumps(recipe))
    run = ["run", str(folder / "recipe.json"), "-o"]
    for chosen in ("open", "half"):
        assert main([*run, str(folder / chosen), "--pose", chosen]) == 0
    files = [next((folder / chosen).glob("*.*")).read_bytes() for chosen in ("open", "half")]
    assert files[0] != files[1]


def test_a_bad_pose_among_several_is_named(folder: Path, capsys):
    recipe = json.loads((folder / "recipe.json").read_text())
    recipe["poses"] = {"open": {"nobody": {}}}
    (folder / "recipe.json").write_text(json.dumps(recipe))
    assert main(["check", str(folder / "recipe.json")]) == 2
    assert "poses.open.nobody" in capsys.readouterr().err


def test_a_bad_pose_file_is_named(folder: Path, capsys):
    (folder / "pose.json").write_text(json.dumps({"tup": {}}))
    assert main(["run", "recipe.json", "-o", "out", "--pose", "pose.json"]) == 2
    assert capsys.readouterr().err.startswith("pose.json, pose.tup: there is no handle")
    assert not (folder / "out").exists()


def test_what_only_the_kernel_can_find_is_bad_input_too(folder: Path, capsys):
    part = plate()
    shared = [{"name": "both", "part": "plate", "vertices": [part.left[0], part.right[0]]}]
    change(folder, features=shared)
    assert main(["run", "recipe.json", "-o", "out"]) == 2
    error = capsys.readouterr().err
    assert "part 'plate'" in error and "touches both" in error
    assert error.count("\n") == 1
    assert not (folder / "out").exists()


def test_a_failed_certificate_exits_with_3_and_writes_the_report_only(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys
):
    monkeypatch.setattr("sheetmorph.reporting.report.tolerance", lambda size, arrays: 0.0)
    assert main(["run", "recipe.json", "-o", "out", "--report", "report.json"]) == 3
    assert "form features are not rigid" in capsys.readouterr().err
    assert not (folder / "out").exists()
    assert json.loads((folder / "report.json").read_text())["certificate"]["passed"] is False


def test_a_part_that_is_not_solved_to_its_end_exits_with_3_and_is_named(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys
):
    solve = Session.deform
    text = (
        "the positions of the sheet did not converge in 90 iterations (the last one still "
        "changed 3 mm)"
    )

    def give_up(self: Session, *arguments: Any, **options: Any) -> Result:
        found = solve(self, *arguments, **options)
        assert found.unsettled == {}
        return replace(found, unsettled={"plate": text})

    monkeypatch.setattr(Session, "deform", give_up)
    assert main(["run", "recipe.json", "-o", "out", "--report", "report.json"]) == 3
    error = capsys.readouterr().err
    assert f'"plate": {text}' in error
    assert error.count("\n") == 1 and "not rigid" not in error
    assert not (folder / "out").exists()
    report = json.loads((folder / "report.json").read_text())
    jsonschema.validate(report, report_schema())
    assert report["parts"][0]["unsettled"] == text
    assert len(report["certificate"]["failures"]) == 1


def test_a_full_disk_leaves_no_folder_and_no_half_file(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys
):
    def save_half(self: object, path: Path, positions: object) -> None:
        path.write_bytes(b"half")
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr("sheetmorph.files.text.TextPartFile.save", save_half)
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "out"]) == 2
    assert "No space left on device" in capsys.readouterr().err
    assert tree(folder) == before


def run_module(*arguments: str, path: str | None = None) -> subprocess.CompletedProcess:
    """The module in a process of its own; path: PYTHONPATH instead of the tests'."""
    package = str(Path(sheetmorph.__file__).parent.parent)
    command = [sys.executable, "-m", "sheetmorph", *arguments]
    environment = {**os.environ, "PYTHONPATH": path or package}
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60)


def test_the_module_runs_by_itself(folder: Path):
    found = run_module("run", "recipe.json", "-o", "out")
    assert (found.returncode, found.stderr) == (0, "")
    assert run_module("--version").stdout == f"sheetmorph {sheetmorph.__version__}\n"
    told = run_module("--help").stdout
    assert all(f"\n    {name} " in told for name in ("init", "show", "check", "run", "find"))
    assert run_module("run", "recipe.json").returncode == 2
    assert run_module().returncode == 2


def copied_package(folder: Path, kernel: str | None) -> str:
    """The package without its kernel, or with a `_core.py` in its place; its PYTHONPATH."""
    source = Path(sheetmorph.__file__).parent
    target = folder / "path" / "sheetmorph"
    for file in source.rglob("*"):
        if file.suffix in (".py", ".json"):
            copy = target / file.relative_to(source)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(file.read_bytes())
    if kernel is not None:
        (target / "_core.py").write_text(kernel)
    return str(folder / "path")


@pytest.mark.parametrize(
    ("kernel", "reason"),
    [
        (None, "cannot be loaded"),
        ("raise ImportError('undefined symbol')", "cannot be loaded (undefined symbol)"),
        ("KERNEL_API = 0", "has interface 0, but this package needs 1"),
    ],
)
def test_a_missing_or_broken_kernel_is_one_sentence(kernel, reason: str, folder: Path, tmp_path):
    path = copied_package(tmp_path, kernel)
    assert run_module("check", "recipe.json", path=path).returncode == 0
    found = run_module("run", "recipe.json", "-o", "out", path=path)
    assert found.returncode == 2
    assert reason in found.stderr and found.stderr.count("\n") == 1
    assert "./sheetmorph build" in found.stderr
    assert not (folder / "out").exists()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_while_writing_leaves_nothing(number: int, folder: Path):
    script = (
        "import sys, time, pathlib, sheetmorph.morph.running as running\n"
        "from sheetmorph.cli import main\n"
        "write = running._put_report\n"
        "def slow(*arguments):\n"
        "    write(*arguments)\n"
        "    print('written', flush=True)\n"
        "    time.sleep(30)\n"
        "running._put_report = slow\n"
        "sys.exit(main(['run', 'recipe.json', '-o', 'out', '--report', 'report.json']))\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(sheetmorph.__file__).parent.parent)}
    before = tree(folder)
    process = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        env=environment, text=True,
    )  # fmt: skip
    assert process.stdout.readline() == "written\n"
    time.sleep(0.05)
    process.send_signal(number)
    _, error = process.communicate(timeout=30)
    assert process.returncode == 130
    assert error == "interrupted: no part was written\n"
    assert tree(folder) == before
