# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people script against: modules under their old names, and the public face."""

from __future__ import annotations

import importlib
import subprocess
import sys

import pytest

import sheetmorph
from sheetmorph.old_names import MOVED

# Modules that the manual, examples, macros or the workbench name, with what they take from them.
NAMED = {
    "sheetmorph.cad": ["read_cad", "read_brep", "write_cad"],
    "sheetmorph.certifying": ["certify", "read_criteria", "Targets"],
    "sheetmorph.cli": ["main", "parser"],
    "sheetmorph.decks": ["read_deck", "sheet_of", "Deck"],
    "sheetmorph.errors": ["RecipeError", "FileError", "KernelError", "Fault", "Caution"],
    "sheetmorph.files": ["read_part", "PartFile", "FileSet"],
    "sheetmorph.finding": ["find", "find_in_files", "FindPart", "FindOptions", "find_schema"],
    "sheetmorph.finding.options": ["KINDS"],
    "sheetmorph.flat": ["flat_patterns", "KTable"],
    "sheetmorph.joint_files": ["read_joint_file"],
    "sheetmorph.morph": ["Morph", "Session"],
    "sheetmorph.pictures": ["draw", "scene_of_answer", "scene_of_recipe"],
    "sheetmorph.recipe": ["read_json", "schema"],
    "sheetmorph.recipe.splitting": ["split_triangles"],
    "sheetmorph.report": ["report_schema", "make_report"],
    "sheetmorph.running": ["run", "check", "resolve", "CertificateError"],
    "sheetmorph.selecting": ["PartShape", "Selector", "selected"],
    "sheetmorph.session": ["Session", "Result", "Drag"],
    "sheetmorph.starting": ["starting_recipe"],
    "sheetmorph.study": ["Evaluator", "run_study", "Ways", "study_schema"],
}


@pytest.mark.parametrize("old", sorted(MOVED))
def test_a_module_that_moved_is_found_under_its_old_name(old):
    new = importlib.import_module(f"sheetmorph.{MOVED[old]}")
    assert importlib.import_module(f"sheetmorph.{old}") is new
    assert new.__name__ == f"sheetmorph.{MOVED[old]}" == new.__spec__.name


@pytest.mark.parametrize("module", sorted(NAMED))
def test_a_module_that_the_manual_names_has_what_is_taken_from_it(module):
    found = importlib.import_module(module)
    assert [name for name in NAMED[module] if not hasattr(found, name)] == []


def test_an_old_name_is_an_attribute_of_the_package_too():
    lines = "import sheetmorph\nassert sheetmorph.errors.RecipeError is sheetmorph.RecipeError\n"
    done = subprocess.run([sys.executable, "-c", lines], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_name_that_never_was_is_refused():
    with pytest.raises(ModuleNotFoundError, match="sheetmorph.wrong"):
        importlib.import_module("sheetmorph.wrong")
    with pytest.raises(AttributeError, match="wrong"):
        sheetmorph.wrong  # noqa: B018


def test_completion_shows_the_public_face():
    assert set(dir(sheetmorph)) == {*sheetmorph.__all__, "__version__"}
    assert all(hasattr(sheetmorph, name) for name in dir(sheetmorph))


@pytest.mark.parametrize("function", [sheetmorph.run, sheetmorph.check, sheetmorph.resolve])
def test_the_recipe_may_have_its_old_keyword(function, tmp_path):
    others = {} if function is sheetmorph.resolve else {"out_dir": tmp_path / "out"}
    with pytest.raises(sheetmorph.RecipeError, match="no.json"):
        function(recipe_path=tmp_path / "no.json", **others)
