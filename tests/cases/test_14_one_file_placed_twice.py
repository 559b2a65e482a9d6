# SPDX-License-Identifier: LGPL-2.1-or-later
"""One file that stands in the assembly twice, by placements."""
import json
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def vertices(path: Path) -> list[list[float]]:
    """The vertices of an OBJ file."""
    lines = path.read_text().splitlines()
    return [[float(x) for x in line.split()[1:]] for line in lines if line.startswith("v ")]


def test_each_part_is_written_under_its_own_name(case: Callable[[str], Path]) -> None:
    folder = case("14")
    assert sheetmorph("check", "placed.json", folder=folder).status == 0
    done = sheetmorph("run", "placed.json", "-o", "out", folder=folder)
    assert done.status == 0, done.said
    assert sorted(path.name for path in (folder / "out").iterdir()) == ["a.obj", "b.obj"]
    rest = vertices(folder / "strip.obj")
    tip = max(range(len(rest)), key=lambda k: rest[k][0])
    a, b = (vertices(folder / "out" / name) for name in ("a.obj", "b.obj"))
    assert a[tip][2] == rest[tip][2] + 5.0
    # Nothing joins the second part: it is where it was, in the coordinates of its file.
    assert b == rest and 'no motion reaches "b"' in done.out


def test_names_that_no_file_can_have_are_told(case: Callable[[str], Path]) -> None:
    folder = case("14")
    recipe = json.loads((folder / "placed.json").read_text())
    recipe["parts"][1]["name"] = "left/b"
    (folder / "slash.json").write_text(json.dumps(recipe))
    done = sheetmorph("check", "slash.json", folder=folder)
    assert done.status == 2 and "is already used" in done.err
