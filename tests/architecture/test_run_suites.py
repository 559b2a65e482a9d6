# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runner behind `./sheetmorph test` counts honestly: what is missing or silent has failed."""
import importlib.util
import json
import sys
import threading

import pytest
from source_tree import ROOT


FAILURES = (
    "FAIL: test_a (m.T.test_a) [1]\nFAIL: test_a (m.T.test_a) [2]\nERROR: test_b (m.T.test_b)\n"
)


@pytest.fixture(scope="module")
def runner():
    spec = importlib.util.spec_from_file_location("run_suites", ROOT / "tests" / "run_suites.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["run_suites"] = module
    spec.loader.exec_module(module)
    return module


def test_a_report_is_counted(runner, tmp_path):
    report = tmp_path / "report.xml"
    report.write_text(
        '<testsuite><testcase/><testcase><failure/></testcase><testcase status="notrun"/>'
        "<testcase><skipped/></testcase></testsuite>"
    )
    assert runner.read_junit(report, "empty") == runner.Count(1, 1, 2)


def test_a_missing_or_empty_report_is_a_failure(runner, tmp_path):
    report = tmp_path / "report.xml"
    assert runner.read_junit(report, "none").failed == 1
    report.write_text("<testsuite></testsuite>")
    assert runner.read_junit(report, "empty").failed == 1


@pytest.mark.parametrize(
    ("code", "output", "expected"),
    [
        (0, "...\nRan 12 tests in 1s\n\nOK (skipped=2)\n", (10, 0, 2)),
        (1, FAILURES + "Ran 12 tests in 1s\n\nFAILED (failures=2, errors=1)\n", (10, 2, 0)),
        (1, "Ran 12 tests in 1s\n\nFAILED (failures=1)\n", (0, 1, 0)),
        (139, "Ran 12 tests in 1s\n\nOK\n", (0, 1, 0)),
        (0, "Ran 0 tests in 0s\n\nOK\n", (0, 1, 0)),
        (0, "malloc(): invalid size\n", (0, 1, 0)),
    ],
)
def test_what_freecad_says_is_counted(runner, code, output, expected):
    assert runner.read_unittest(code, output) == runner.Count(*expected)


@pytest.mark.parametrize(
    ("code", "output", "expected"),
    [
        (0, "PASS a\ngui: 12 passed, 0 failed, 1 skipped\n", (12, 0, 1)),
        (1, "gui: 12 passed, 1 failed, 0 skipped\n", (12, 1, 0)),
        (1, "gui: 12 passed, 0 failed, 0 skipped\n", (12, 1, 0)),
        (0, "gui: 0 passed, 0 failed, 0 skipped\n", (0, 1, 0)),
        (0, "gui: 3 passed, 0 failed, 0 skipped, 2 only at the second try\n", (3, 0, 0, 2)),
        (0, "", (0, 1, 0)),
    ],
)
def test_the_gui_tests_closing_line_is_counted(runner, code, output, expected):
    assert runner.read_closing_line(code, output) == runner.Count(*expected)


def test_the_closing_line_adds_up(runner):
    counts = {"core": runner.Count(3, 0, 1), "gui": runner.Count(2, 1, 0)}
    assert runner.closing_line(counts) == (
        "sheetmorph test: 5 passed, 1 failed, 1 skipped (core 3, gui 2)"
    )


def test_what_needed_a_second_try_is_in_the_closing_line(runner):
    counts = {"gui": runner.Count(5, 0, 0, 2)}
    assert runner.closing_line(counts) == (
        "sheetmorph test: 5 passed, 0 failed, 0 skipped, 2 only at the second try (gui 5)"
    )


def test_an_unknown_suite_is_refused(runner, tmp_path):
    with pytest.raises(SystemExit) as error:
        runner.main(["--build", str(tmp_path), "everything"])
    assert error.value.code == 2


def test_the_gui_tests_run_beside_the_others_and_are_told_in_their_place(
    runner, tmp_path, monkeypatch
):
    others_have_run = threading.Event()

    def gui(_):
        assert others_have_run.wait(60.0)
        return runner.Count(2)

    def style(_):
        others_have_run.set()
        return runner.Count(1)

    monkeypatch.setattr(runner.Suites, "gui", gui)
    monkeypatch.setattr(runner.Suites, "style", style)
    counts = runner.run_all(runner.Suites(tmp_path), ["gui", "style"])
    assert list(counts.items()) == [("gui", runner.Count(2)), ("style", runner.Count(1))]


def test_sanitize_counts_every_part_and_a_dead_interpreter_as_a_failure(
    runner, tmp_path, monkeypatch
):
    written = {"sanitize-core": "<testcase/>", "sanitize-threads": "<testcase/><testcase/>"}
    seen = {}

    def call(self, command, **settings):
        name = next(part for part in command if "sanitize-" in part).split("/")[-1]
        name = name.removesuffix(".xml")
        seen[name] = settings
        if name in written:
            (self.results / f"{name}.xml").write_text(f"<testsuite>{written[name]}</testsuite>")
        return 0, ""

    monkeypatch.setattr(runner.Suites, "_call", call)
    assert runner.Suites(tmp_path).sanitize() == runner.Count(3, 2, 0)
    assert "halt_on_error=1" in seen["sanitize-threads"]["TSAN_OPTIONS"]
    assert "libasan" in seen["sanitize-bindings"]["LD_PRELOAD"].split()[0]
    assert "detect_leaks=1" in seen["sanitize-core"]["ASAN_OPTIONS"]


def test_the_python_tests_that_are_sanitized_exist(runner):
    paths = [path for group in runner.SANITIZED_PYTEST.values() for path in group]
    assert paths and [path for path in paths if not (ROOT / path).exists()] == []


def test_the_sanitized_builds_keep_assertions(runner):
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    kinds = {preset["name"]: preset for preset in presets}
    assert kinds["sanitize"]["cacheVariables"]["CMAKE_BUILD_TYPE"] == "Debug"
    folders = {kinds[name]["binaryDir"] for name in ("asan", "tsan")}
    assert folders == {f"${{sourceDir}}/build/sanitize/{name}" for name in ("address", "thread")}
    assert kinds["asan"]["inherits"] == kinds["tsan"]["inherits"] == "sanitize"
