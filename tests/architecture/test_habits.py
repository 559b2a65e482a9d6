# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every source says its licence, is finished, hides no error and holds no state; tests claim."""
import habits
import pytest
from source_tree import PACKAGE, ROOT, WORKBENCH, faults_in, files

CODE = files(".py", ".h", ".cpp", ".sh", ".FCMacro") + [
    *[path for path in files() if path.name == "CMakeLists.txt"],
    ROOT / "sheetmorph",
    ROOT / ".ci" / "run",
]
TESTS = [path for path in files(".py") if path.name.startswith("test_")]
CPP_TESTS = files(".cpp", below=ROOT / "tests")


def in_text(find):
    """The same search, from a file."""
    return lambda path: find(path.read_text())


def test_sources_are_licensed_and_finished():
    assert faults_in(CODE, in_text(habits.text_faults)) == {}


def test_python_sources_hold_no_state_and_hide_no_error():
    assert faults_in(files(".py"), in_text(habits.python_faults)) == {}


def test_python_tests_make_a_claim():
    assert faults_in(TESTS, in_text(habits.python_tests_without_claim)) == {}


def test_gui_tests_wait_for_conditions():
    below = files(".py", below=ROOT / "tests" / "gui")
    assert below and faults_in(below, in_text(habits.timed_waits)) == {}


def test_the_workbench_reads_no_signals_of_qt():
    below = files(".py", below=ROOT / "Mod" / "SheetMorph")
    assert below and faults_in(below, in_text(habits.signals_read)) == {}


def test_a_method_takes_the_values_that_its_signal_sends():
    below = files(".py", below=ROOT / "Mod" / "SheetMorph")
    assert faults_in(below, in_text(habits.wrong_slots)) == {}


def test_no_name_hides_a_builtin():
    code = [*files(".py", below=PACKAGE), *files(".py", below=WORKBENCH)]
    assert faults_in(code, in_text(habits.hidden_builtins)) == {}


def test_a_name_that_hides_a_builtin_is_noticed():
    for text in ("open = 1\n", "def f():\n    for id in (1,):\n        pass\n", "def max(): ...\n"):
        assert len(habits.hidden_builtins(text)) == 1
    fields = "class A:\n    type: str = ''\n    hash = 1\n    def open(self): ...\n"
    assert habits.hidden_builtins(fields) == []


def test_cpp_tests_make_a_claim():
    assert faults_in(CPP_TESTS, in_text(habits.cpp_tests_without_claim)) == {}


def test_a_missing_licence_line_is_noticed():
    assert habits.text_faults("import os\n") == ["the SPDX line is missing"]


def test_work_left_open_is_noticed():
    text = f"# {habits.SPDX}\n# TO" + "DO later\nraise " + habits.UNFINISHED + "\n"
    assert len(habits.text_faults(text)) == 2


@pytest.mark.parametrize(
    "text",
    [
        "def f():\n    global a\n    a = 1\n",
        "try:\n    f()\nexcept:\n    pass\n",
        "assert " + "True\n",
        "from typing import " + "runtime_checkable\n",
    ],
)
def test_a_bad_python_habit_is_noticed(text):
    assert len(habits.python_faults(text)) == 1


def test_a_signal_that_is_read_is_noticed():
    text = "def f(form):\n    form.reset.clicked.connect(f)\n    form.session.over.connect(f)\n"
    assert len(habits.signals_read(text)) == 1


def test_a_wrong_slot_is_noticed():
    methods = "class A:\n    def none(self): ...\n    def one(self, value): ...\n"
    calls = 'connect(box, "{}", self.{})\n'
    for signal, name in (("clicked()", "none"), ("clicked(bool)", "one")):
        assert habits.wrong_slots(methods + calls.format(signal, name)) == []
    for signal, name in (("clicked()", "one"), ("clicked(bool)", "none")):
        assert habits.wrong_slots(methods + calls.format(signal, name)) == [
            f"line 4: {signal} of {name}"
        ]


def test_a_wait_for_a_time_is_noticed():
    assert len(habits.timed_waits("def test_a():\n    yield 300\n    yield POLL\n")) == 1


def test_a_test_without_claim_is_noticed():
    text = (
        "def test_a():\n    run()\ndef test_b():\n    assert run()\ndef test_c():\n    check(1)\n"
    )
    assert habits.python_tests_without_claim(text) == ["test_a"]
    cpp = "TEST(A, runs)\n{\n    run();\n}\nTEST(A, holds)\n{\n    EXPECT_EQ(1, run());\n}\n"
    assert habits.cpp_tests_without_claim(cpp) == ["A.runs"]
