# SPDX-License-Identifier: LGPL-2.1-or-later
"""The suite `mutants` plants what it says, and its score is honest."""
import importlib.util
import sys
from types import SimpleNamespace

import pytest
from source_tree import ROOT

FOLDER = ROOT / "tests" / "mutants"


@pytest.fixture(scope="module")
def runner():
    sys.path.insert(0, str(FOLDER))
    try:
        spec = importlib.util.spec_from_file_location("run_mutants", FOLDER / "run_mutants.py")
        module = importlib.util.module_from_spec(spec)
        sys.modules["run_mutants"] = module
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(FOLDER))
    return module


def test_there_are_a_hundred_mutations_and_all_can_be_planted(runner):
    assert len(runner.MUTATIONS) >= 100
    planted = {(mutation.file, mutation.applied()) for mutation in runner.MUTATIONS}
    assert len(planted) == len(runner.MUTATIONS)


def test_a_mutation_whose_text_has_gone_is_a_failure(runner):
    stale = runner.Mutation("base/rotation.cpp", "what nobody wrote", "", "*")
    with pytest.raises(ValueError, match="occurs 0 times"):
        stale.applied()
    laboratory = SimpleNamespace(_digests={stale.program: b""})
    assert runner.Laboratory.judge(laboratory, 0, stale).kind == "unsound"


def test_every_mutation_runs_tests_that_exist(runner):
    named = {}
    for path in (ROOT / "tests" / "core").rglob("*_test.cpp"):
        layer = path.relative_to(ROOT / "tests" / "core").parts[0]
        named[layer] = named.get(layer, "") + path.read_text("utf-8")
    for mutation in runner.MUTATIONS:
        layer = mutation.layer or mutation.file.split("/")[0]
        for suite in mutation.tests.split(":"):
            name = suite.split(".")[0].strip("*")
            assert name in named[layer], mutation.label


@pytest.mark.parametrize(
    ("killed", "survived", "unsound", "status"),
    [(95, 5, 0, 0), (94, 6, 0, 1), (99, 0, 1, 1), (0, 0, 0, 1)],
)
def test_the_score_fails_below_95_and_if_something_was_not_tested(
    runner, killed, survived, unsound, status
):
    kinds = ["killed"] * killed + ["survived"] * survived + ["unsound"] * unsound
    mutation = runner.Mutation("base/rotation.cpp", "old", "new", "*")
    assert runner.score([(mutation, runner.Verdict(kind, "")) for kind in kinds]) == status


def test_the_output_names_the_survivors_and_the_score_of_every_folder(runner, capsys):
    judged = [
        (runner.Mutation("base/rotation.cpp", "a", "b", "*"), runner.Verdict("killed", "")),
        (runner.Mutation("base/rates.cpp", "c", "d", "*"), runner.Verdict("survived", "")),
        (runner.Mutation("pick/sight.cpp", "e", "f", "*"), runner.Verdict("killed", "")),
    ]
    assert runner.score(judged) == 1
    said = capsys.readouterr().out
    for line in (
        "1 of   2 killed in base",
        "1 of   1 killed in pick",
        "survived: base/rates.cpp: d",
    ):
        assert line in said


# They choose instructions of the processor, and have no number of an answer.
WITHOUT_NUMBERS = {"base/instructions"}


def test_every_folder_of_the_kernel_has_mutations(runner):
    folders = {
        path.parent.relative_to(runner.KERNEL).as_posix() for path in runner.KERNEL.rglob("*.cpp")
    }
    mutated = {mutation.folder for mutation in runner.MUTATIONS}
    assert folders - mutated == WITHOUT_NUMBERS


@pytest.mark.parametrize(
    ("status", "said", "kind", "reason"),
    [
        (0, "[  PASSED  ] 3 tests.", "survived", "all tests passed"),
        (1, "[  FAILED  ] Rotation.Turns (3 ms)\n", "killed", "Rotation.Turns"),
        (-11, "", "killed", "ended with -11"),
        (None, "", "killed", "the tests never ended"),
    ],
)
def test_the_verdict_says_how_a_mutation_was_noticed(runner, status, said, kind, reason):
    verdict = runner.verdict_of(runner.Ended(status, said, 1.0), 2.0)
    assert (verdict.kind, verdict.reason) == (kind, reason)
