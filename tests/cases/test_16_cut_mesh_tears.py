# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plate that doubled vertices cut in two, and a vertex of no face far away."""
import json
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def vertices(path: Path) -> list[list[float]]:
    """The vertices of a PLY file in text."""
    lines = path.read_text().splitlines()
    count = next(int(line.split()[-1]) for line in lines if line.startswith("element vertex"))
    first = lines.index("end_header") + 1
    return [[float(x) for x in line.split()[:3]] for line in lines[first : first + count]]


def test_the_doctor_measures_the_sheet(case: Callable[[str], Path]) -> None:
    done = sheetmorph("doctor", "plate.ply", folder=case("16"))
    assert round(json.loads(done.out)["files"][0]["size"]) == 134


def test_a_tear_is_a_warning(case: Callable[[str], Path]) -> None:
    folder = case("16")
    done = sheetmorph("run", "lift.json", "-o", "out", folder=folder)
    (told,) = [line for line in done.out.splitlines() if "is cut" in line]
    assert "7 vertices" in told and "by up to 10 mm at (60, " in told and '"weld"' in told
    assert told in sheetmorph("check", "lift.json", folder=folder).out
    assert sheetmorph("check", "lift.json", "--strict", folder=folder).status == 3


def test_a_vertex_of_no_face_stays_where_it_was(case: Callable[[str], Path]) -> None:
    folder = case("16")
    sheetmorph("run", "lift.json", "-o", "out", folder=folder)
    assert vertices(folder / "out" / "plate.ply")[91] == vertices(folder / "plate.ply")[91]


def test_a_weld_joins_the_two_halves(case: Callable[[str], Path]) -> None:
    folder = case("16")
    recipe = json.loads((folder / "lift.json").read_text())
    recipe["parts"][0]["weld"] = 0.001
    (folder / "welded.json").write_text(json.dumps(recipe))
    done = sheetmorph("check", "welded.json", "--strict", folder=folder)
    assert done.status == 0, done.said
