# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the documents of the package and the recipe show works as they show it."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import numpy as np
import pytest

import sheetmorph
import sheetmorph.decks
from sheetmorph.cli import main
from sheetmorph.base.kernel import load_kernel
from sheetmorph.reporting.report import report_schema

DOCUMENTS = Path(__file__).resolve().parents[2] / "resources" / "docs"


def blocks(name: str, language: str) -> list[str]:
    """The code blocks of a language in a document."""
    text = (DOCUMENTS / name).read_text("utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)


def test_the_examples_of_the_package_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    examples = blocks("package.md", "python")
    assert len(examples) >= 8
    names: dict[str, object] = {}
    for example in examples:
        exec(compile(example, "package.md", "exec"), names)
    assert (tmp_path / "deformed" / "strip.obj").is_file()


def test_the_example_of_the_recipe_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    (recipe,), (part,) = blocks("recipe.md", "json"), blocks("recipe.md", "obj")
    (tmp_path / "recipe.json").write_text(recipe)
    (tmp_path / "strip.obj").write_text(part)
    commands = blocks("recipe.md", "sh")[0].strip().split("\n")
    assert len(commands) == 2
    for command in commands:
        words = shlex.split(command)
        assert words[0] == "sheetmorph"
        assert main(words[1:]) == 0
    positions = sheetmorph.read_part("deformed/strip.obj").mesh.points
    assert positions[13] == pytest.approx([40, 10, 20])
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["features"][0]["edge_error"] < report["tolerance"]


def test_the_way_of_a_deck_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    (deck,), (recipe,) = blocks("decks.md", "python"), blocks("decks.md", "json")
    exec(compile(deck, "decks.md", "exec"), {})
    (tmp_path / "recipe.json").write_text(recipe)
    commands = [line for block in blocks("decks.md", "sh") for line in block.strip().split("\n")]
    assert len(commands) == 5
    for command in commands:
        words = shlex.split(command)
        assert words[0] == "sheetmorph" and main(words[1:]) == 0, command
    assert (tmp_path / "same" / "plate.bdf").read_bytes() == Path("plate.bdf").read_bytes()
    proof = json.loads((tmp_path / "proof.json").read_text())
    (part,), (told,) = proof["parts"], proof["decks"]
    assert proof["passed"] and part["material"]["name"] == "MAT1 1"
    assert told["left"] == [] and told["joints"]["count"] >= 1
    assert [card["card"] for card in told["stale"]] == ["CORD2R"]
    moved = sheetmorph.decks.read_deck(tmp_path / "morphed" / "plate.bdf")
    assert moved.points[moved.find(np.array([200]))[0], 2] > 0.5


def test_the_package_document_names_every_public_name():
    text = (DOCUMENTS / "package.md").read_text("utf-8")
    hidden = {"FeatureResult", "PartFile", "Result"}  # met as results, not made by the user
    assert [name for name in sheetmorph.__all__ if name not in text and name not in hidden] == []


def test_package_and_kernel_have_one_version():
    assert load_kernel().__version__ == sheetmorph.__version__
    assert report_schema()["properties"]["sheetmorph_report"]["const"] == 1


def test_the_kernel_computes_the_documented_logarithm():
    """(theta / 2) v of (2.6), angle kept beyond a full turn."""
    log = load_kernel().rotation_log([0.0, 0.0, 2.0], np.radians(400.0))
    assert log == pytest.approx([0.0, 0.0, np.radians(200.0)])
