# SPDX-License-Identifier: LGPL-2.1-or-later
"""No command writes over a file that it reads, or that somebody else made."""

from __future__ import annotations

import json
import random
import shutil
from pathlib import Path

import pytest

from plates import plate, write_plate
import sheetmorph
from sheetmorph import OccupiedError, run
from sheetmorph.cli import main
from sheetmorph.files.ledger import Ledger


@pytest.fixture(autouse=True)
def own_ledger(tmp_path_factory, monkeypatch):
    """A ledger for each test alone."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A user's folder: a plate, its recipe, a study, a request, criteria, and a thesis."""
    made = plate()
    write_plate(made, tmp_path / "plate.obj", "obj")
    write_plate(made, tmp_path / "bent.stl", "binary.stl")
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": "plate.obj"}],
        "fixed": [{"part": "plate", "vertices": made.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": made.right}],
        "pose": {"tip": {"translation": [0, 0, 2]}},
        "poses": {"high": {"tip": {"translation": [0, 0, 4]}}},
    }
    study = {
        "sheetmorph_study": 1,
        "recipe": "recipe.json",
        "parameters": {"lift": {"path": "pose.tip.translation[2]", "range": [0, 10]}},
        "sampling": {"method": "latin hypercube", "count": 4, "seed": 1},
        "measure": {"tip": {"position": "tip"}},
    }
    files = {"recipe.json": recipe, "study.json": study, "in.json": {"lift": 3}}
    files["criteria.json"] = {"elements": {"min_angle": {"min": 1.0}}}
    for name, content in files.items():
        (tmp_path / name).write_text(json.dumps(content))
    (tmp_path / "thesis.txt").write_text("three years of work")
    return tmp_path


# With {} where an output goes.
COMMANDS = (
    ["run", "recipe.json", "-o", "out", "--quiet", "--report", "{}"],
    ["run", "recipe.json", "-o", "{folder}", "--quiet"],
    ["find", "plate.obj", "-o", "{}"],
    ["find", "bent.stl", "plate.obj", "-o", "{}"],
    ["resolve", "recipe.json", "--quiet", "-o", "{}"],
    ["flatten", "bent.stl", "--quiet", "-o", "{}"],
    ["flatten", "plate.obj", "--quiet", "-o", "{}"],
    ["init", "plate.obj", "--quiet", "-o", "{}"],
    ["doctor", "plate.obj", "--json", "{}"],
    ["find", "plate.obj", "--report", "{}"],
    ["copy", "plate.obj", "bent.stl", "-o", "{folder}"],
    ["certify", "recipe.json", "run", "--json", "{}"],
    ["certify", "recipe.json", "run", "--criteria", "criteria.json", "--page", "{}"],
    ["study", "study.json", "--quiet", "--evaluate", "in.json", "{}"],
    ["show", "recipe.json", "--quiet", "-o", "{}"],
)


ENDINGS = {"find": "json", "flatten": "dxf", "show": "png", "certify": "html", "study": "txt"}


@pytest.mark.parametrize("number", range(len(COMMANDS)))
def test_every_command_writes_where_nothing_stands(number: int, folder: Path, monkeypatch):
    monkeypatch.chdir(folder)
    assert main(["run", "recipe.json", "-o", "run", "--quiet"]) == 0
    before = contents(folder)
    command = COMMANDS[number]
    new = f"new.{ENDINGS.get(command[0], 'json')}"
    assert main([word.format(new, folder="new") for word in command]) == 0
    now = contents(folder)
    assert len(now) > len(before) and {name: now[name] for name in before} == before


def contents(folder: Path) -> dict[str, bytes]:
    """Every file below a folder."""
    files = (file for file in folder.rglob("*") if file.is_file())
    return {str(file.relative_to(folder)): file.read_bytes() for file in files}


@pytest.mark.parametrize("seed", range(5))
def test_a_random_command_with_its_output_aimed_at_any_input_changes_none(
    seed: int, folder: Path, monkeypatch, capsys
):
    draw = random.Random(seed)
    monkeypatch.chdir(folder)
    assert main(["run", "recipe.json", "-o", "run", "--quiet"]) == 0
    before = contents(folder)
    for _ in range(12):
        command = list(draw.choice(COMMANDS))
        target = draw.choice(sorted(before))
        if command[0] == "show":
            shutil.copy(folder / "thesis.txt", folder / "thesis.png")
            target = "thesis.png"
            before[target] = (folder / target).read_bytes()
        filled = [word.format(target, folder=draw.choice([".", "run/.."])) for word in command]
        status = main(filled)
        said = capsys.readouterr()
        assert "has a bug" not in said.err, (filled, said.err)
        now = contents(folder)
        assert {name: now.get(name) for name in before} == before, (filled, status)
        for name in now.keys() - before.keys():
            (folder / name).unlink()


def test_what_a_command_wrote_it_writes_again_until_somebody_changes_it(folder: Path, capsys):
    recipe, out = str(folder / "recipe.json"), folder / "out"
    ways = ["-o", str(out), "--quiet", "--report", str(folder / "report.json")]
    assert main(["run", recipe, *ways]) == 0
    assert main(["run", recipe, *ways, "--pose", "high"]) == 0
    (out / "plate.obj").write_text("v 0 0 0\n")
    assert main(["run", recipe, *ways]) == 2
    assert "plate.obj: it already exists, and SheetMorph did not write its" in (
        capsys.readouterr().err
    )
    assert (out / "plate.obj").read_text() == "v 0 0 0\n"
    assert main(["run", recipe, *ways, "--force"]) == 0
    assert (out / "plate.obj").read_text() != "v 0 0 0\n"


def test_macros_are_refused_too_unless_they_force(folder: Path):
    (folder / "out").mkdir()
    (folder / "out" / "plate.obj").write_text("mine")
    with pytest.raises(OccupiedError, match="plate.obj"):
        run(folder / "recipe.json", folder / "out")
    assert (folder / "out" / "plate.obj").read_text() == "mine"
    assert run(folder / "recipe.json", folder / "out", force=True)["certificate"]["passed"]
    (folder / "own.json").write_text("{}")
    morph = sheetmorph.open(folder / "plate.obj")
    with pytest.raises(OccupiedError):
        morph.save(folder / "own.json")
    morph.save(folder / "own.json", force=True)


def test_the_ledger_knows_a_file_until_it_changes_or_moves(tmp_path: Path):
    ledger = Ledger(tmp_path / "state" / "written.txt")
    file = tmp_path / "a file\nof two lines.obj"
    file.write_text("v 0 0 0\n")
    assert not ledger.has(file, "run")
    ledger.add([(file, "run")])
    assert Ledger(tmp_path / "state" / "written.txt").has(file, "run")
    assert not ledger.has(file, "find")
    assert not ledger.has(file.rename(tmp_path / "b.obj"), "run")
    file.write_text("v 0 0 1\n")
    assert not ledger.has(file, "run")


def test_the_ledger_forgets_its_older_half_and_survives_a_folder_it_cannot_write(
    tmp_path: Path, monkeypatch
):
    monkeypatch.setattr("sheetmorph.files.ledger._LARGEST", 2000)
    ledger = Ledger(tmp_path / "written.txt")
    files = [tmp_path / f"{k}.obj" for k in range(100)]
    for file in files:
        file.write_text("v 0 0 0\n")
        ledger.add([(file, "run")])
    assert ledger.has(files[-1], "run") and not ledger.has(files[0], "run")
    assert (tmp_path / "written.txt").stat().st_size < 4000
    Ledger(files[0] / "written.txt").add([(file, "run") for file in files])
