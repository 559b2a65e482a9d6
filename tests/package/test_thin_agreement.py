# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command has one answer to what is thin: the doctor, `init` and a session."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sheetmorph import PartMesh, Session, _core, diagnose, read_part
from sheetmorph.files import is_cad
from sheetmorph.recipe.model import model_of
from sheetmorph.recipe.parts import read_parts
from sheetmorph.starting.first_recipe import starting_recipe
from finding_scores import data_folder
from thin_plates import thin_plate

FILES = [
    "05-robotnik-summit-stl/summit_xl_covers.stl",
    "10-cases/05-touching-corner/corner_gap_0_5.step",
    "10-cases/07-ledge-in-a-skin/ledge.step",
    "10-cases/07-ledge-in-a-skin/veneer.step",
    "10-cases/18-inside-out/plate_mostly_inside_out.stl",
    "10-cases/19-thin-lost/default_fender.stl",
    *(f"11-bent-sheets/{number}.stp" for number in range(6)),
]
PLATE = thin_plate()


def recipe_of(path: Path, folder: Path) -> dict[str, Any]:
    """What `init` writes, without its comments."""
    text = starting_recipe([path], folder)
    found: dict[str, Any] = json.loads(re.sub(r"^\s*//.*$", "", text, flags=re.MULTILINE))
    return found


def thickness_in_session(recipe: dict[str, Any], folder: Path) -> dict[str, float | None]:
    """By part: the thickness with which a run solves it, None where it is no thin solid."""
    parts = read_parts(model_of({"parts": recipe["parts"]}).parts, folder)
    assert not parts.faults
    first = next(iter(parts.meshes))
    last = len(parts.meshes[first].points) - 1
    whole = {
        "sheetmorph": 1,
        "parts": recipe["parts"],
        "primary": first,
        "fixed": [{"part": first, "vertices": parts.meshes[first].file_ids([0])}],
        "handles": [{"name": "h", "part": first, "vertices": parts.meshes[first].file_ids([last])}],
    }
    session = Session(whole, parts.meshes)
    solids = {name: session.thin_solid(name) for name in parts.meshes}
    return {name: None if one is None else one.thickness for name, one in solids.items()}


@pytest.mark.parametrize("file", FILES)
def test_doctor_init_and_run_agree(file: str, tmp_path: Path):
    data = data_folder()
    if data is None or not (data / file).is_file():
        pytest.skip("the public files are not on this machine")
    recipe = recipe_of(data / file, tmp_path)
    in_run = thickness_in_session(recipe, tmp_path)
    for name, thickness in in_run.items():
        parts = read_parts(model_of({"parts": recipe["parts"]}).parts, tmp_path)
        told = diagnose(PartMesh(parts.meshes[name].points, parts.meshes[name].triangles))
        assert told["thickness"] == (None if thickness is None else pytest.approx(thickness))
    whole = diagnose(read_part(data / file).mesh)
    scale = whole["unit"]["scale"]
    thin = [thickness for thickness in in_run.values() if thickness is not None]
    assert (whole["thickness"] is not None) == bool(thin)
    if thin:
        assert whole["thickness"] * scale == pytest.approx(np.median(thin), rel=0.01)


@pytest.mark.parametrize(
    "file, expected",
    [("a.step", True), ("a.STP", True), ("a.igs", True), ("a.brep", True), ("a.obj", False),
     ("a.stl", False), ("a.nas", False)],
)  # fmt: skip
def test_shapes_are_thin_by_default_and_meshes_are_not(file: str, expected: bool):
    assert is_cad(file) == expected
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": file}],
        "fixed": [{"part": "plate", "vertices": PLATE.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": PLATE.right}],
    }
    mesh = {"plate": PartMesh(PLATE.points, PLATE.triangles)}
    entry = Session(recipe, mesh).deform().report()["parts"][0]["thin"]
    assert (entry is not None) == expected
    switched_off = {**recipe, "parts": [{"name": "plate", "file": file, "thin": False}]}
    assert Session(switched_off, mesh).deform().report()["parts"][0]["thin"] is None


def test_the_default_says_nothing_about_shapes_that_are_no_sheets():
    box = _core.TriangleMesh(*block())
    assert _core.find_thin_solid(box)[0] is None
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "block", "file": "block.step"}],
        "fixed": [{"part": "block", "vertices": [0]}],
        "handles": [{"name": "tip", "part": "block", "vertices": [7]}],
    }
    report = Session(recipe, {"block": PartMesh(*block())}).deform().report()
    assert not [note for note in report["notes"] if "thin" in note]


def block() -> tuple[np.ndarray, np.ndarray]:
    """The corners and triangles of a cube."""
    points = np.array([[x, y, z] for x in (0, 9) for y in (0, 9) for z in (0, 9)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return points, np.array(triangles, np.int32)
