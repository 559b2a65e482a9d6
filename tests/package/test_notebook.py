# SPDX-License-Identifier: LGPL-2.1-or-later
"""The notebook among the examples runs from its first cell to its last."""

from __future__ import annotations

import ast
import json
import shutil
from pathlib import Path

import pytest

import sheetmorph as sm

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"


def cells() -> list[str]:
    """The code of the notebook, cell by cell."""
    notebook = json.loads((EXAMPLES / "tutorial.ipynb").read_text("utf-8"))
    assert notebook["nbformat"] == 4
    return ["".join(c["source"]) for c in notebook["cells"] if c["cell_type"] == "code"]


def executed(code: str, names: dict[str, object]) -> object:
    """Runs a cell as a notebook does: its last expression is what it shows."""
    body = ast.parse(code).body
    last = body.pop() if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "tutorial.ipynb", "exec"), names)
    if last is None:
        return None
    return eval(compile(ast.Expression(last.value), "tutorial.ipynb", "eval"), names)


def test_the_notebook_runs_cell_by_cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    (tmp_path / "door_mirror").mkdir()
    shutil.copy(EXAMPLES / "door_mirror" / "cover.obj", tmp_path / "door_mirror")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    shown = [executed(code, names) for code in cells()]
    assert repr(shown[1]).endswith("1 fixed region, 1 handle, 4 form features>")
    assert "<img" in shown[2]._repr_html_() or "python3-vtk9" in shown[2]._repr_html_()
    assert len(names["report"]["features"]) == 4
    again = sm.run(tmp_path / "recipe.json", tmp_path / "again")
    assert again["certificate"]["passed"]
    written = [(tmp_path / folder / "cover.obj").read_bytes() for folder in ("deformed", "again")]
    assert written[0] == written[1]
