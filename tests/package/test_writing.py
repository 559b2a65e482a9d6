# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing that is read is written over; files appear all together or not at all."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from plates import plate, recipe_of, save_recipe, write_plate
import sheetmorph
from sheetmorph.cli import main
from sheetmorph.base.errors import FileError
from sheetmorph.files import FileSet


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with plate.obj, recipe.json and pose.json; the working folder of the test."""
    part = plate()
    write_plate(part, tmp_path / "plate.obj", "obj")
    save_recipe(recipe_of(part, "plate.obj"), tmp_path)
    (tmp_path / "pose.json").write_text(json.dumps({"tip": {"translation": [0, 0, 1]}}))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def tree(folder: Path) -> dict[str, bytes]:
    """All files below a folder with their content, and the folders."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else b"folder"
        for path in folder.rglob("*")
    }


REFUSED = [
    ("recipe.json", "is read by this run"),
    ("../{name}/pose.json", "is read by this run"),
    ("soft.json", "is read by this run"),
    ("hard.json", "is read by this run"),
    ("plate.obj", "is read by this run"),
    ("out/../plate.obj", "is read by this run"),
    ("out/plate.obj", "is the file of a part"),
    ("out", "is the folder of the parts"),
    ("taken", "it is a folder"),
    ("pipe", "it is a device or a pipe"),
    ("out/deeper/report.json", "its folder does not exist"),
]


@pytest.mark.parametrize(("report", "message"), REFUSED)
def test_a_report_never_replaces_what_is_read(report: str, message: str, folder: Path, capsys):
    (folder / "soft.json").symlink_to("recipe.json")
    os.link(folder / "pose.json", folder / "hard.json")
    (folder / "taken").mkdir()
    pipe = folder / "pipe"
    if report == "pipe":
        os.mkfifo(pipe)
    before = None if report == "pipe" else tree(folder)
    report = report.format(name=folder.name)
    arguments = ["run", "recipe.json", "-o", "out", "--pose", "pose.json", "--report", report]
    assert main(arguments) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1
    assert not (folder / "out").exists()
    assert before is None or tree(folder) == before


def test_parts_never_replace_a_source_behind_a_link(folder: Path, capsys):
    (folder / "out").mkdir()
    (folder / "out" / "plate.obj").symlink_to(folder / "plate.obj")
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "out"]) == 2
    assert "would overwrite the source file" in capsys.readouterr().err
    assert tree(folder) == before


def test_a_folder_in_the_place_of_a_part_is_found_before_anything_is_written(folder: Path, capsys):
    (folder / "out" / "plate.obj").mkdir(parents=True)
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "out", "--report", "report.json"]) == 2
    assert "it is a folder" in capsys.readouterr().err
    assert tree(folder) == before


def test_a_report_may_stand_in_the_new_folder_of_the_parts(folder: Path):
    assert main(["run", "recipe.json", "-o", "new/out", "--report", "new/out/report.json"]) == 0
    assert sorted(os.listdir(folder / "new" / "out")) == ["plate.obj", "report.json"]


def test_folders_made_for_a_failed_run_are_removed(folder: Path, monkeypatch):
    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("sheetmorph.files.atomic.os.replace", fail)
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "a/b/c"]) == 2
    assert tree(folder) == before


def files_of(folder: Path, names: list[str]) -> FileSet:
    """A set with a new text in every file."""
    files = FileSet(force=True)
    for name in names:
        files.temporary_for(folder / name).write_text(f"new {name}")
    return files


@pytest.mark.parametrize("links", [True, False])
@pytest.mark.parametrize("failing", [1, 2, 3])
def test_a_rename_that_fails_half_way_is_taken_back(failing, links, tmp_path, monkeypatch):
    (tmp_path / "b").write_text("old b")
    (tmp_path / "c").write_text("old c")
    before = tree(tmp_path)
    replace, calls = os.replace, []

    def fail_once(source: Path, target: Path) -> None:
        calls.append(target)
        if len(calls) == failing:
            raise OSError(5, "Input/output error", str(source))
        replace(source, target)

    def no_link(*_: object, **__: object) -> None:
        raise OSError(95, "Operation not supported")

    monkeypatch.setattr("sheetmorph.files.atomic.os.replace", fail_once)
    if not links:
        monkeypatch.setattr("sheetmorph.files.atomic.os.link", no_link)
    with pytest.raises(FileError) as caught, files_of(tmp_path, ["a", "b", "c"]) as files:
        files.commit()
    assert caught.value.path == tmp_path / "abc"[failing - 1]
    assert caught.value.what == "it cannot be written (Input/output error)"
    assert files.committed is False
    assert tree(tmp_path) == before


def test_old_files_are_replaced_and_no_backup_stays(tmp_path: Path):
    (tmp_path / "b").write_text("old b")
    with files_of(tmp_path, ["a", "b"]) as files:
        files.commit()
    assert files.committed
    assert tree(tmp_path) == {"a": b"new a", "b": b"new b"}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_between_two_renames_waits_and_the_message_is_true(
    number: int, folder: Path, monkeypatch, capsys
):
    replace, calls = os.replace, []

    def interrupted(source: Path, target: Path) -> None:
        replace(source, target)
        calls.append(target)
        if len(calls) == 1:
            signal.raise_signal(number)

    monkeypatch.setattr("sheetmorph.files.atomic.os.replace", interrupted)
    before = set(tree(folder))
    assert main(["run", "recipe.json", "-o", "out", "--report", "report.json"]) == 130
    assert capsys.readouterr().err == "interrupted: all files were written\n"
    assert set(tree(folder)) - before == {"out", "out/plate.obj", "report.json"}


def run_shell(line: str) -> subprocess.CompletedProcess:
    """A shell line in which $RUN is the command line."""
    package = str(Path(sheetmorph.__file__).parent.parent)
    environment = {**os.environ, "PYTHONPATH": package, "RUN": f"{sys.executable} -m sheetmorph"}
    return subprocess.run(
        ["bash", "-c", line], capture_output=True, text=True, env=environment, timeout=60
    )


@pytest.mark.parametrize(
    ("redirection", "message"),
    [(">/dev/full", "done, but stdout cannot be written"), (">&-", ""), ("| true", "")],
)
def test_a_full_or_closed_stdout_makes_no_success_a_failure(redirection, message, folder: Path):
    found = run_shell(f"set -o pipefail; $RUN run recipe.json -o out {redirection}")
    assert found.returncode == 0
    assert found.stderr.startswith(message) and found.stderr.count("\n") == bool(message)
    assert (folder / "out" / "plate.obj").is_file()


def test_what_cannot_be_read_back_is_told_with_its_own_name(folder: Path, monkeypatch, capsys):
    def corrupt(self: object, path: Path, positions: object) -> None:
        path.write_text("v 0 0\n")

    monkeypatch.setattr("sheetmorph.files.text.TextPartFile.save", corrupt)
    assert main(["run", "recipe.json", "-o", "out"]) == 2
    error = capsys.readouterr().err
    assert error.startswith("out/plate.obj") and ".tmp" not in error
    assert not (folder / "out").exists()


def test_an_unexpected_error_is_a_sentence_that_names_it(folder: Path, monkeypatch, capsys):
    def fail(*_: object) -> None:
        raise KeyError("nobody thought of this")

    monkeypatch.setattr("sheetmorph.morph.running.prepare", fail)
    assert main(["run", "recipe.json", "-o", "out"]) == 3
    error = capsys.readouterr().err
    assert "KeyError: 'nobody thought of this'" in error and "please report" in error
    assert "no part was written" in error and error.count("\n") == 1


def save_reader(folder: Path, name: str, file: str) -> None:
    """A recipe in a folder that reads a mesh file."""
    recipe = recipe_of(plate(), file)
    (folder / name).write_text(json.dumps(recipe))


@pytest.mark.parametrize("name", ["recipe.json", "recipe-2.json", "mirror.JSON"])
@pytest.mark.parametrize("spelling", ["plate.obj", "./plate.obj", "../out/plate.obj", "linked.obj"])
def test_what_a_recipe_beside_it_reads_is_not_written_over(name, spelling, folder: Path, capsys):
    out = folder / "out"
    out.mkdir()
    (out / "plate.obj").write_bytes((folder / "plate.obj").read_bytes())
    (out / "linked.obj").symlink_to("plate.obj")
    save_reader(out, name, spelling)
    before = tree(folder)
    assert main(["run", "recipe.json", "-o", "out", "--report", "report.json", "--force"]) == 2
    error = capsys.readouterr().err
    assert error.startswith("out/plate.obj") and error.count("\n") == 1
    assert f'"{name}" next to it reads this file' in error
    assert tree(folder) == before


@pytest.mark.parametrize(
    "text", ["no recipe", "[1]", '{"parts": [{"file": "plate.obj"}]}', '{"sheetmorph": 1}', "\xff"]
)
def test_what_is_no_recipe_protects_nothing(text: str, folder: Path):
    (folder / "out").mkdir()
    (folder / "out" / "plate.obj").write_text("an earlier result")
    (folder / "out" / "notes.json").write_bytes(text.encode("latin-1"))
    assert main(["run", "recipe.json", "-o", "out", "--force"]) == 0
    assert (folder / "out" / "plate.obj").read_text() != "an earlier result"


def test_a_recipe_that_is_replaced_with_its_meshes_protects_nothing(tmp_path: Path):
    (tmp_path / "plate.obj").write_text("old")
    save_reader(tmp_path, "recipe.json", "plate.obj")
    with files_of(tmp_path, ["plate.obj", "recipe.json"]) as files:
        files.commit()
    assert (tmp_path / "plate.obj").read_text() == "new plate.obj"


def test_the_same_content_may_be_written_again(tmp_path: Path):
    (tmp_path / "plate.obj").write_text("new plate.obj")
    save_reader(tmp_path, "recipe.json", "plate.obj")
    with files_of(tmp_path, ["plate.obj", "second.json"]) as files:
        files.commit()
    assert (tmp_path / "second.json").is_file()
