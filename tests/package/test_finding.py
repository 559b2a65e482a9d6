# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `find`: true, after its schema, and ready to stand in a recipe."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import sheetmorph
from sheetmorph.cli import main
from sheetmorph.finding import FindOptions, FindPart, find, find_in_files, find_schema

EXAMPLES = Path(__file__).resolve().parents[2] / "resources/examples"
MIRROR = [EXAMPLES / "door_mirror" / name for name in ("cover.obj", "frame.ply", "foot.obj")]


def printed(capsys: pytest.CaptureFixture, *arguments: str) -> dict:
    assert main(["find", *arguments]) == 0
    return json.loads(capsys.readouterr().out)


def test_it_prints_json_of_the_published_schema(capsys):
    found = printed(capsys, *map(str, MIRROR))
    jsonschema.validate(found, find_schema())
    holes = [entry for entry in found["features"] if entry["kind"] == "round hole"]
    assert len(holes) == 18
    assert {entry["part"] for entry in holes} == {"cover", "frame", "foot"}
    assert found["gap"] > 1.2


def test_center_axis_and_radius_are_those_of_the_mesh(capsys):
    found = printed(capsys, str(MIRROR[2]), "--kind", "round hole")
    points = sheetmorph.read_part(MIRROR[2]).mesh.points
    for hole in found["features"]:
        off = points[hole["vertices"]] - hole["center"]
        assert np.allclose(np.linalg.norm(off, axis=1), hole["radius"], atol=1e-6)
        assert np.abs(off @ hole["axis"]).max() < 1e-6
        assert hole["residual"] < 1e-6


def test_what_is_found_stands_in_a_recipe_as_it_is(tmp_path, capsys):
    found = printed(capsys, *map(str, MIRROR), "--one-per-pair")
    recipe = json.loads((EXAMPLES / "door_mirror/recipe.json").read_text())
    kinds = ("round hole", "slotted hole", "rectangular hole")
    taken = {(r["part"], v) for k in ("fixed", "handles") for r in recipe[k] for v in r["vertices"]}
    recipe["parts"] = [{k: v for k, v in part.items() if k != "parts"} for part in found["parts"]]
    recipe["features"] = [
        entry
        for entry in found["features"]
        if entry["kind"] in kinds and not taken & {(entry["part"], v) for v in entry["vertices"]}
    ]
    recipe["contacts"] = found["contacts"]
    recipe["propagation"] = {"type": "local"}
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    report = sheetmorph.run(path, tmp_path / "out")
    assert report["certificate"]["passed"]
    assert report["unreached"] == []


def test_options_choose_kinds_and_sizes(capsys):
    files = list(map(str, MIRROR))
    small = printed(capsys, *files, "--kind", "round hole", "--largest-radius", "4.2")
    radii = [entry["radius"] for entry in small["features"]]
    assert radii and max(radii) <= 4.2
    assert all(
        len(e["washer"]) == 2
        for e in printed(capsys, *files, "--rings", "2")["features"]
        if e["kind"] == "round hole"
    )
    assert printed(capsys, *files, "--gap", "0.1")["contacts"] == []


def test_what_is_wrong_is_said_in_one_line(capsys):
    for arguments, words in (
        (["nothing.obj"], "the file does not exist"),
        ([str(MIRROR[0]), "--rings", "99"], "rings is 99"),
        ([str(MIRROR[0]), "--kind", "whole"], 'no kind "whole"'),
        ([str(MIRROR[0]), "--split", "property"], "only decks have properties"),
    ):
        assert main(["find", *arguments]) == 2
        error = capsys.readouterr().err
        assert words in error and error.count("\n") == 1


def test_output_goes_to_a_file_but_never_over_a_mesh(tmp_path, capsys):
    target = tmp_path / "found.json"
    assert main(["find", str(MIRROR[0]), "-o", str(target)]) == 0
    jsonschema.validate(json.loads(target.read_text()), find_schema())
    mesh = tmp_path / "cover.obj"
    mesh.write_bytes(MIRROR[0].read_bytes())
    assert main(["find", str(mesh), "-o", str(mesh)]) == 2
    assert mesh.read_bytes() == MIRROR[0].read_bytes()


def test_the_same_files_give_the_same_answer():
    first, second = (find_in_files(MIRROR) for _ in range(2))
    assert {**first, "seconds": None} == {**second, "seconds": None}


def test_a_search_in_memory_can_be_cancelled():
    mesh = sheetmorph.read_part(MIRROR[0]).mesh
    with pytest.raises(RuntimeError, match="cancelled"):
        find([FindPart("cover", mesh)], FindOptions(), progress=lambda share, task: False)


def test_what_is_kept_of_a_search_is_not_searched_again():
    part = FindPart("cover", sheetmorph.read_part(MIRROR[0]).mesh)
    first = find([part]).features
    (features,) = part.kept.values()
    features.pop()  # what is kept is what the next search answers
    assert len(find([part]).features) == len(first) - 1
    assert find([part], FindOptions(kinds=("round hole",))).features
    assert len(find([part], FindOptions(rings=2)).features) == len(first)
    assert list(part.kept) == [FindOptions(rings=2).feature_key()]


DECK = """BEGIN BULK
$ two strips of 4 shells, riveted by a CBUSH, a spring pair over a node of no shell, and RBE3
{grids}
{shells}
PSHELL         1       1      2.
PSHELL         2       1      4.
CBUSH        100       1       3      13
CELAS2       101     1.0       4       1      99       1
CELAS2       102     1.0      99       1      14       1
RBE3         103              15     123      1.     123       5
ENDDATA
"""


def test_decks_tell_thickness_and_elements_between_parts(tmp_path):
    grids, shells = [], []
    for part, (first, height) in enumerate(((0, 0.0), (10, 2.2)), start=1):
        for k in range(10):
            x, y = 10.0 * (k // 2), 10.0 * (k % 2)
            grids.append(f"GRID    {first + k + 1:8d}        {x:8.1f}{y:8.1f}{height:8.1f}")
        for k in range(4):
            corners = [first + 2 * k + c + 1 for c in (0, 2, 3, 1)]
            shells.append("CQUAD4  " + "".join(f"{n:8d}" for n in (first + k + 1, part, *corners)))
    grids.append(f"GRID    {99:8d}        {10.0:8.1f}{10.0:8.1f}{1.1:8.1f}")
    path = tmp_path / "strips.bdf"
    path.write_text(DECK.format(grids="\n".join(grids), shells="\n".join(shells)))
    found = find_in_files([path], FindOptions(gap=0.5))
    assert len(found["contacts"]) == 1
    contact = found["contacts"][0]
    assert (contact["kind"], contact["type"]) == ("weld", "tied")
    assert contact["connections"] >= 3
    assert {3, 4, 5} <= set(contact["a"]["vertices"])


def test_measured_vertices_hide_no_hole_and_their_scatter_is_told():
    """Every hole of the cover, vertices off by a normal distribution of 3 % of the edges."""
    mesh = sheetmorph.read_part(MIRROR[0]).mesh
    ends = mesh.points[mesh.triangles]
    edge = np.median(np.linalg.norm(ends - np.roll(ends, 1, axis=1), axis=2))
    drawn = find([FindPart("cover", mesh)], FindOptions(kinds=("round hole",))).features
    noise = np.random.default_rng(0).normal(0.0, 0.03 * edge, mesh.points.shape)
    measured = [FindPart("cover", sheetmorph.PartMesh(mesh.points + noise, mesh.triangles))]
    found = find(measured, FindOptions(kinds=("round hole",))).features
    assert [hole["vertices"] for hole in found] == [hole["vertices"] for hole in drawn]
    assert all(0.02 < hole["scatter"] / edge < 0.06 for hole in found)
    assert not any("scatter" in hole for hole in find(measured, FindOptions(scatter=0.0)).features)


def test_a_search_in_cad_files_takes_the_sizes_of_their_meshes(capsys):
    assert main(["find", str(MIRROR[0]), "--edge", "5"]) == 2
    assert "only CAD files are meshed" in capsys.readouterr().err
