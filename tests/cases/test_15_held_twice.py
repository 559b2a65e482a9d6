# SPDX-License-Identifier: LGPL-2.1-or-later
"""A vertex that is fixed and that a handle moves."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize("command", ["check", "run"])
def test_the_error_names_both_regions_and_the_vertex(
    command: str, case: Callable[[str], Path]
) -> None:
    folder = case("15")
    more = ["-o", "out"] if command == "run" else []
    done = sheetmorph(command, "held_twice.json", *more, folder=folder)
    assert done.status == 2
    assert "fixed region 'fixed0' and handle 'h' share 1 vertex (4)" in done.err
    assert "moves by 20 mm; remove it from" in done.err
    assert not (folder / "out").exists()


def test_a_handle_that_turns_about_the_shared_vertices_does_not_contradict(
    case: Callable[[str], Path]
) -> None:
    folder = case("15")
    recipe = json.loads((folder / "held_twice.json").read_text())
    line = (folder / "plate.obj").read_text().splitlines()[4]
    hinge = [float(x) for x in line.split()[1:]]
    recipe["handles"][0]["pivot"] = hinge
    recipe["pose"]["h"] = {"rotation": {"axis": [0, 0, 1], "degrees": 3}}
    (folder / "hinge.json").write_text(json.dumps(recipe))
    assert sheetmorph("check", "hinge.json", folder=folder).status == 0
