# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every error has faults with code, place, problem, remedy and objects, up to the JSON."""

from __future__ import annotations

import json
import pickle
import sys
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import sheetmorph as sm
from sheetmorph import Caution, Fault, SheetMorphError, Subject
from sheetmorph.base.errors import FailedError, fault_of, reason_of
from sheetmorph.base import pages
from sheetmorph.base.kernel import load_kernel
from sheetmorph.certifying import NotCertified
from sheetmorph.cli import main
from sheetmorph.decks.frames import FrameError
from sheetmorph.flat import NotFlat
from sheetmorph.pictures import PictureError
from sheetmorph.recipe import read_json
from sheetmorph.recipe.splitting import SplitError
from sheetmorph.reporting.report import report_schema
from sheetmorph.selecting import Question
from sheetmorph.selecting.chosen import SelectorError
from sheetmorph.study import run_study

WEAK = Fault("pose.tip", "it is wrong", "correct it", "torn", (Subject("handle", "tip"),), (3, 4))
INPUTS = [
    (sm.RecipeError([WEAK]), "pose.tip: it is wrong; correct it"),
    (sm.FileError("a.obj", "it is empty", "export it", 3), "a.obj, line 3: it is empty; export it"),
    (sm.OccupiedError("a.obj"), "a.obj: it already exists"),
    (sm.InputError("it is flat", "bend it"), "it is flat; bend it"),
    (SelectorError("no face", "add one", ("minus", 1)), "no face; add one"),
    (SplitError("no properties", "use components"), "no properties; use components"),
    (FrameError(3, "there is no system 3"), "there is no system 3; correct"),
    (Question("a hole", []), "a hole is gone: nothing like it exists"),
]
FAILURES = [
    (sm.KernelError("no kernel", "build it"), "no kernel; build it"),
    (PictureError("no picture", "install vtk"), "no picture; install vtk"),
    (NotFlat("too curved", "cut it", '"lid"'), '"lid": too curved; cut it'),
    (NotCertified({"failures": ["a", "b"]}), "not certified: a; b"),
    (FailedError("no memory"), "no memory"),
]


@pytest.mark.parametrize(
    ("error", "text", "base"),
    [(*one, ValueError) for one in INPUTS] + [(*one, RuntimeError) for one in FAILURES],
)
def test_an_error_has_faults_and_its_old_base(error: SheetMorphError, text: str, base: type):
    assert isinstance(error, SheetMorphError) and isinstance(error, base)
    assert str(error).startswith(text) and error.faults
    first = error.faults[0]
    assert (error.where, error.what, error.todo) == (first.where, first.what, first.todo)
    assert (error.code, error.objects, error.vertices) == (
        first.code,
        first.objects,
        first.vertices,
    )
    with pytest.raises(AttributeError):
        error.wrong  # noqa: B018


@pytest.mark.parametrize("error", [error for error, _ in INPUTS + FAILURES])
def test_an_error_comes_whole_from_another_process(error: SheetMorphError):
    same = pickle.loads(pickle.dumps(error))
    assert type(same) is type(error) and str(same) == str(error)
    assert list(same.faults) == list(error.faults) and vars(same) == vars(error)


def test_a_page_without_its_template_engine_is_refused_before_any_work(tmp_path: Path, monkeypatch):
    monkeypatch.setitem(sys.modules, "jinja2", None)
    pages._environment.cache_clear()
    with pytest.raises(FailedError, match="install python3-jinja2"):
        run_study(tmp_path / "no study.json", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_an_error_of_the_kernel_is_an_error_of_the_package():
    core = load_kernel()
    with pytest.raises(core.InvalidInput) as refused:
        core.TriangleMesh(np.zeros((3, 3)), np.array([[0, 1, 7]], dtype=np.int32))
    error = refused.value
    assert isinstance(error, sm.InputError) and isinstance(error, ValueError)
    assert str(error) == str(error.faults[0]) and error.code == "other" and error.what
    assert issubclass(core.SolverError, FailedError) and issubclass(core.Cancelled, RuntimeError)
    assert str(core.Cancelled("stopped")) == "stopped"


def test_other_errors_become_faults():
    assert fault_of(ValueError("no\n good"), "mend it") == Fault("recipe", "no good", "mend it")
    assert fault_of(sm.InputError("flat", ""), "bend it", "a") == Fault("a", "flat", "bend it")
    assert fault_of(sm.RecipeError([WEAK]), "other", "other") == WEAK
    assert reason_of(sm.RecipeError([WEAK, WEAK])) == f"{WEAK}; {WEAK}"
    assert reason_of(RuntimeError("no\nway")) == "no way"


def test_a_warning_carries_its_fault():
    warning = Caution("it opens", Subject("contact", "weld"), code="open contact", todo="move less")
    assert warning == "it opens: move less"
    placed = warning.within('pose "up"')
    assert placed == 'pose "up": it opens: move less' and placed.within("") == placed
    assert placed.fault.to_json() == {
        "code": "open contact",
        "where": 'pose "up"',
        "what": "it opens",
        "todo": "move less",
        "objects": [{"kind": "contact", "name": "weld"}],
        "vertices": [],
    }
    assert warning.after("now: ") == "now: it opens: move less"


# -- the command line


def write_recipe(folder: Path, **keys: object) -> str:
    (folder / "changed.json").write_text(json.dumps({**read_json(folder / "recipe.json"), **keys}))
    return "changed.json"


@pytest.mark.parametrize("command", ["check", "run"])
def test_a_command_prints_the_faults_of_a_recipe_as_json(folder: Path, capsys, command: str):
    recipe = write_recipe(folder, pose={"top": {"translation": [0, 0, 1]}})
    assert main([command, recipe, "--quiet", "--json", "-o", "out"] if command == "run" else
                [command, recipe, "--quiet", "--json"]) == 2  # fmt: skip
    told = capsys.readouterr()
    found = json.loads(told.out)
    (fault,) = found["faults"]
    assert not found["valid"] and fault["objects"] == [{"kind": "region", "name": "top"}]
    assert fault["where"].endswith("pose.top") and fault["todo"] and fault["what"] in told.err
    jsonschema.validate(fault, report_schema()["$defs"]["fault"])


def test_a_missing_file_is_a_fault_too(folder: Path, capsys):
    assert main(["check", "none.json", "--json"]) == 2
    (fault,) = json.loads(capsys.readouterr().out)["faults"]
    assert fault["where"] == "none.json" and fault["todo"] == "check the path and its rights"


def test_warnings_are_printed_with_code_and_remedy(folder: Path, capsys):
    recipe = write_recipe(folder, pose={"tip": {"translation": [300, 0, 0]}})
    assert main(["check", recipe, "--quiet", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["valid"] and found["warnings"] and found["notes"] == []
    assert {"stretched"} <= {one["code"] for one in found["cautions"]}
    for sentence, caution in zip(found["warnings"], found["cautions"]):
        assert caution["what"] in sentence and caution["todo"] in sentence and caution["todo"]
    assert main(["run", recipe, "-o", "out", "--quiet", "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["cautions"] == found["cautions"] and report["warnings"] == found["warnings"]
    jsonschema.validate(report, report_schema())
