# SPDX-License-Identifier: LGPL-2.1-or-later
"""`init` and `run` make a morph of every public file with a surface, and `check` passes what runs:
`./sheetmorph test real`."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import recipes
from sheetmorph.cli import main
from sheetmorph.base.errors import FileError
from sheetmorph.files import read_part

# What is no mesh beside the files: licences, lists of where they come from.
ASIDE = ("LICENSES", "MANIFEST.json", "README.md")


def public_files() -> list[str]:
    """All of them, by their paths below the data; none where the data is not at hand."""
    folder = recipes.data_folder()
    if folder is None:
        return []
    files = [path.relative_to(folder) for path in folder.rglob("*") if path.is_file()]
    return sorted(str(path) for path in files if not set(ASIDE) & set(path.parts))


@pytest.mark.skipif(recipes.data_folder() is None, reason=recipes.ABSENT)
def test_there_are_files():
    assert len(public_files()) > 190


@pytest.mark.parametrize("name", public_files())
def test_a_file_is_a_morph_at_once_or_told_why_not(name, tmp_path, capsys, record_property):
    path = recipes.data_folder() / name
    recipe, told = tmp_path / "recipe.json", tmp_path / "report.json"
    status = main(["init", str(path), "-o", str(recipe), "--quiet"])
    said = capsys.readouterr().err.strip()
    refusal = why_not(path)
    if refusal:
        record_property("refused", refusal)
        assert status == 2 and said == refusal and not recipe.exists()
        return
    assert status == 0, said
    assert main(["check", str(recipe)]) == 0, capsys.readouterr().err
    wanted = ["run", str(recipe), "-o", str(tmp_path / "out"), "--report", str(told), "--quiet"]
    assert main(wanted) == 0, capsys.readouterr().err
    report = json.loads(told.read_text("utf-8"))
    moved = max(part["largest_displacement"] for part in report["parts"])
    record_property("moved", moved)
    assert moved > 0.0 and report["certificate"]["passed"]
    assert all(region["vertices"] for region in report["regions"])


def why_not(path: Path) -> str:
    """What the reader says of a file that holds no surface; nothing if there is one."""
    try:
        read_part(path)
    except FileError as error:
        return str(error)
    return ""
