# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the Python package lie above each other, and no import runs back up."""

import pytest
from imports import import_graph
from package_rooms import LAZY, OUTSIDE, ROOMS, lazy_imports, upward_imports
from source_tree import PACKAGE, ROOT


def graph_of(folder, sources):
    for path, text in sources.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return import_graph(folder, "house")


def test_every_module_of_the_package_is_in_a_room():
    graph = import_graph(PACKAGE, "sheetmorph")
    assert len(graph) > 200
    assert {name.split(".")[0] for name in graph if name not in OUTSIDE} == set(ROOMS)


def test_no_import_runs_back_up():
    assert upward_imports(import_graph(PACKAGE, "sheetmorph")) == []


def test_only_listed_modules_import_others_while_they_run():
    assert lazy_imports(PACKAGE, "sheetmorph") == sorted(LAZY)


def test_no_module_is_named_like_a_room_but_the_room():
    modules = {path.stem for path in PACKAGE.glob("*.py")} - {"__init__"}
    assert modules == OUTSIDE - {""}


def test_the_page_for_contributors_lists_the_rooms_in_their_order():
    page = ROOT / "resources" / "docs" / "contributing" / "architecture.md"
    table = page.read_text().split("| room | what |\n|---|---|\n")[1].split("\n\n")[0]
    assert [line.split("`")[1] for line in table.splitlines()] == list(ROOMS)


@pytest.mark.parametrize(
    "line",
    [
        "from ..cli import entry",
        "from house import cli",
        "def f():\n    from ..cli import entry",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from ..cli.entry import main",
        "import house",
        "from .. import unknown",
    ],
)
def test_an_import_that_runs_back_up_is_noticed(tmp_path, line):
    sources = {"__init__.py": "", "files/obj.py": line + "\n", "cli/entry.py": "main = 1\n"}
    graph = graph_of(tmp_path, sources | {"cli/__init__.py": ""})
    assert len(upward_imports(graph)) >= 1


def test_an_import_from_below_or_beside_passes(tmp_path):
    sources = {"base/words.py": "", "files/obj.py": "from ..base import words\nfrom . import ply\n"}
    assert upward_imports(graph_of(tmp_path, sources | {"files/ply.py": ""})) == []


@pytest.mark.parametrize(
    ("text", "is_noticed"),
    [
        ("def f():\n    from .b import g\n", True),
        ("def f():\n    return importlib.import_module('house.b')\n", True),
        ("class A:\n    def f(self):\n        import house.b\n", True),
        ("from .b import g\n\n\ndef f():\n    import scipy\n", False),
    ],
)
def test_an_import_inside_a_function_is_noticed(tmp_path, text, is_noticed):
    graph_of(tmp_path, {"a.py": text, "b.py": ""})
    assert lazy_imports(tmp_path, "house") == (["a"] if is_noticed else [])
