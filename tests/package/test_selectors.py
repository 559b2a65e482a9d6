# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions that say what they are: what every selector takes, and what is told of it."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import sheetmorph
from plates import plate, write_plate
from sheetmorph import PartMesh, RecipeError, Session
from sheetmorph.cli import main
from sheetmorph.reporting.report import report_schema
from sheetmorph.morph.running import resolve, run
from sheetmorph.selecting import PartShape, selected
from sheetmorph.selecting.chosen import SelectorError
from sheetmorph.recipe.placement import Placement
from thin_plates import thin_plate

STRIP = plate(3, start=0.0)  # from x = -10 to 50, y = -10 to 10; holes of radius 4 at x = 0, 20, 40
SOLID = thin_plate(3, thickness=1.0)  # the same, z = 0 and -1


def sheet() -> PartShape:
    return PartShape(PartMesh(STRIP.points, STRIP.triangles, name="strip"))


def solid() -> PartShape:
    return PartShape(PartMesh(SOLID.points, SOLID.triangles, name="solid"))


def box_mesh(size: float = 10.0, cells: int = 4) -> PartMesh:
    """The surface of a cube, its faces cut into squares and these into triangles."""
    line = np.linspace(0.0, size, cells + 1)
    points: dict[tuple[float, ...], int] = {}
    triangles = []
    for axis in range(3):
        for side in (0.0, size):
            for i in range(cells):
                for j in range(cells):
                    corners = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        place = [line[a], line[b]]
                        place.insert(axis, side)
                        corners.append(points.setdefault(tuple(place), len(points)))
                    triangles += [corners[:3], [corners[0], corners[2], corners[3]]]
    return PartMesh(np.array(list(points)), np.array(triangles), name="cube")


def places(shape: PartShape, selector: object) -> np.ndarray:
    return shape.points[selected(shape, selector).vertices]


@pytest.mark.parametrize(
    "selector, expected",
    [
        ({"box": [[-10, -10, 0], [0, 10, 0]]}, lambda p: p[:, 0] <= 1e-9),
        ({"box": [[0, 10, 1], [-10, -10, -1]]}, lambda p: p[:, 0] <= 1e-9),
        (
            {"half_space": {"point": [10, 0, 0], "normal": [-2, 0, 0]}},
            lambda p: p[:, 0] <= 10 + 1e-9,
        ),
        (
            {"slab": {"point": [20, 0, 0], "normal": [1, 0, 0], "thickness": 4}},
            lambda p: np.abs(p[:, 0] - 20) <= 2 + 1e-9,
        ),
        (
            {"cylinder": {"point": [20, 0, 5], "direction": [0, 0, 3], "radius": 6}},
            lambda p: np.hypot(p[:, 0] - 20, p[:, 1]) <= 6 + 1e-9,
        ),
        (
            {"sphere": {"center": [20, 0, 3], "radius": 6}},
            lambda p: (p[:, 0] - 20) ** 2 + p[:, 1] ** 2 + 9 <= 36 + 1e-6,
        ),
        ({"all": True}, lambda p: p[:, 0] < 1e9),
        ({"piece_at": [0, 9, 4]}, lambda p: p[:, 0] < 1e9),
        ({"face_at": [0, 9, 4]}, lambda p: p[:, 0] < 1e9),
        ({"rim_at": [23.9, 0, 0]}, lambda p: np.hypot(p[:, 0] - 20, p[:, 1]) < 4.1),
        ({"border_at": [43, 1, 0]}, lambda p: np.hypot(p[:, 0] - 40, p[:, 1]) < 4.1),
        (
            {"borders_longer": 100},
            lambda p: (np.abs(p[:, 1]) > 9.999) | (np.abs(p[:, 0] - 20) > 29.99),
        ),
        (
            {"found": "round hole", "near": [20, 0, 0]},
            lambda p: np.hypot(p[:, 0] - 20, p[:, 1]) < 4.1,
        ),
    ],
)
def test_a_selector_takes_what_it_says(selector, expected):
    shape = sheet()
    chosen = selected(shape, selector)
    assert np.array_equal(chosen.inside, expected(shape.points))


def test_a_list_is_a_union_and_the_three_ways_of_joining_are_those_of_sets():
    shape = sheet()
    a = {"box": [[-10, -10, 0], [21, 10, 0]]}
    b = {"half_space": {"point": [10, 0, 0], "normal": [1, 0, 0]}}
    inside_a, inside_b = (selected(shape, s).inside for s in (a, b))
    assert np.array_equal(selected(shape, [a, b]).inside, inside_a | inside_b)
    assert np.array_equal(selected(shape, {"union": [a, b]}).inside, inside_a | inside_b)
    assert np.array_equal(selected(shape, {"intersection": [a, b]}).inside, inside_a & inside_b)
    assert np.array_equal(selected(shape, {"minus": [a, b]}).inside, inside_a & ~inside_b)


def test_growing_and_shrinking_go_by_rings_or_by_a_length():
    shape = sheet()
    rim = {"rim_at": [24, 0, 0]}
    ring = selected(shape, {"grow": 1, "of": rim})
    assert np.array_equal(ring.inside, selected(shape, {"rim_at": [24, 0, 0], "rings": 1}).inside)
    wide = places(shape, {"grow": {"length": 3.0}, "of": rim})
    away = np.hypot(wide[:, 0] - 20, wide[:, 1])
    assert away.max() <= 7.0 + 1e-9 and len(wide) > len(places(shape, rim))
    back = selected(shape, {"shrink": 1, "of": {"grow": 1, "of": rim}})
    assert (back.inside >= selected(shape, rim).inside).all()
    less = places(shape, {"shrink": {"length": 2.0}, "of": {"box": [[10, -10, 0], [30, 10, 0]]}})
    assert less[:, 0].min() > 10.0 and less[:, 0].max() < 30.0


def test_a_face_ends_at_creases_and_a_rim_of_a_thin_solid_has_its_wall_and_both_loops():
    shape = PartShape(box_mesh())
    top = places(shape, {"face_at": [5, 5, 11]})
    assert (top[:, 2] == 10).all() and len(top) == 25
    assert len(places(shape, {"face_at": [5, 5, 11], "crease_angle": 100})) == len(shape.points)
    rim = places(solid(), {"rim_at": [24, 0, 0]})
    assert {0.0, -1.0} == set(rim[:, 2].tolist())
    assert np.allclose(np.hypot(rim[:, 0] - 20, rim[:, 1]), 4.0)


def test_a_placement_turns_the_part_and_not_what_its_selector_says():
    turn = Placement.of([100, 0, 7], [0, 0, 1], 90)
    mesh = PartMesh(STRIP.points, STRIP.triangles)
    moved = PartShape(turn.placed_mesh(mesh), turn)
    says = {"half_space": {"point": [10, 0, 0], "normal": [-1, 0, 0]}}
    assert np.array_equal(selected(moved, says).inside, selected(PartShape(mesh), says).inside)


@pytest.mark.parametrize(
    "selector, told",
    [
        ({"box": [[90, 0, 0], [91, 1, 1]]}, '"box" selects nothing'),
        ({"intersection": [{"rim_at": [0, 0, 0]}, {"rim_at": [20, 0, 0]}]}, "selects nothing"),
        ({"group": "flange"}, "no names at all"),
        ({"cad_face_at": [0, 0, 0]}, "no CAD faces"),
        ({"found": "round hol"}, "use round hole"),
        ({"found": "bead"}, "found there: "),
        ({"found": "round hole", "diameter": [1, 2]}, "those found have 8 mm"),
        ({"found": "round hole", "holes": 4}, "4 holes expected, 3 are selected"),
        ({"found": "round hole", "count": 4}, "4 matches expected"),
        ({"box": [[-10, -10, 0], [10, 10, 0]], "holes": 2}, "2 holes expected, 1 is selected"),
        ({"vertices": [0, 99999]}, "99999 are not in part"),
        ({}, "has no key that selects anything"),
        ({"face_at": [0, 0, 0], "rim_at": [0, 0, 0]}, "one selector has both"),
        ({"rim_at": [0, 0, 0], "near": [0, 0, 0]}, '"rim_at" does not use "near"'),
        ({"grow": 2}, 'add "of"'),
        ({"half_space": {"point": [0, 0, 0], "normal": [0, 0, 0]}}, "the normal has no length"),
    ],
)
def test_what_selects_nothing_or_something_else_is_told(selector, told):
    with pytest.raises(SelectorError, match=".*") as caught:
        selected(sheet(), selector)
    assert told in str(caught.value) and "\n" not in str(caught.value)


def test_a_solid_has_no_border():
    with pytest.raises(SelectorError, match="closed and has no border"):
        selected(solid(), {"border_at": [0, 0, 0]})


def test_everything_far_matches_and_empty_operands_are_remarked():
    shape = sheet()
    assert "whole part" in selected(shape, {"box": [[-99, -99, -9], [99, 99, 9]]}).remarks[0]
    assert selected(shape, {"all": True}).remarks == []
    far = selected(shape, {"rim_at": [20, 0, 30]})
    assert "mm from the point" in far.remarks[0]
    assert far.matches[0]["distance"] == pytest.approx(30.0)
    half = selected(shape, [{"rim_at": [24, 0, 0]}, {"box": [[90, 0, 0], [91, 1, 1]]}])
    assert half.remarks == ['its part "box" selects nothing']


@pytest.fixture
def recipe(tmp_path: Path) -> Path:
    """A recipe of the strip in a deck, with node ids, that has no id in it."""
    write_plate(STRIP, tmp_path / "strip.nas", "nas")
    data = {
        "sheetmorph": 1,
        "parts": [{"name": "strip", "file": "strip.nas"}],
        "fixed": [{"part": "strip", "where": {"box": [[-10, -10, 0], [-8, 10, 0]]}}],
        "handles": [
            {
                "name": "tip",
                "part": "strip",
                "where": {"half_space": {"point": [49, 0, 0], "normal": [1, 0, 0]}},
            }
        ],
        "features": [
            {
                "name": "seat",
                "part": "strip",
                "where": {"found": "round hole", "near": [20, 0, 0], "holes": 1},
            }
        ],
        "pose": {"tip": {"translation": [0, 0, 8]}},
    }
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(data))
    return path


def test_a_run_with_selectors_is_the_run_with_their_ids(recipe: Path, tmp_path: Path):
    first = run(recipe, tmp_path / "a")
    resolved = tmp_path / "elsewhere" / "ids.json"
    resolved.parent.mkdir()
    assert main(["resolve", str(recipe), "-o", str(resolved), "--quiet"]) == 0
    ids = json.loads(resolved.read_text())
    assert ids["parts"][0]["file"] == "../strip.nas"
    assert all(
        "where" not in e and min(e["vertices"]) > 100 for e in (*ids["fixed"], *ids["features"])
    )
    second = run(resolved, tmp_path / "b")
    assert (tmp_path / "a/strip.nas").read_bytes() == (tmp_path / "b/strip.nas").read_bytes()
    assert [e["vertices"] for e in first["regions"]] == [e["vertices"] for e in second["regions"]]


def test_resolve_prints_a_recipe(recipe: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["resolve", str(recipe)]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == resolve(recipe)
    seat = STRIP.points[np.array(printed["features"][0]["vertices"]) - 101]
    assert np.allclose(np.hypot(seat[:, 0] - 20, seat[:, 1]), 4.0)


def test_resolve_tells_what_took_all_of_a_part_or_something_far_away(recipe: Path, capsys):
    told = json.loads(recipe.read_text())
    told["features"] = [{"name": "seat", "part": "strip", "where": {"rim_at": [20.0, 0.0, 9.0]}}]
    told["fixed"] = [{"part": "strip", "where": {"box": [[-1e3] * 3, [1e3] * 3]}}]
    del told["handles"], told["pose"]
    recipe.write_text(json.dumps(told))
    assert main(["resolve", str(recipe), "--quiet"]) == 0
    printed = capsys.readouterr()
    assert len(json.loads(printed.out)["fixed"][0]["vertices"]) == len(STRIP.points)
    all_of_it, far = printed.err.strip().splitlines()
    assert all_of_it.startswith('warning: fixed[0]: it is the whole part "strip"; ')
    assert far.startswith("warning: features[0] (seat): rim_at: the nearest match is ")


def test_resolve_writes_over_nothing_that_the_recipe_reads(recipe: Path, capsys):
    for place in (recipe, recipe.parent / "strip.nas"):
        before = place.read_bytes()
        assert main(["resolve", str(recipe), "-o", str(place)]) == 2
        assert " another f" in capsys.readouterr().err and place.read_bytes() == before


def test_the_report_tells_of_every_region(recipe: Path, tmp_path: Path):
    report = run(recipe, tmp_path / "out")
    jsonschema.Draft202012Validator(report_schema()).validate(report)
    fixed, tip, seat = report["regions"]
    assert (fixed["kind"], tip["name"], seat["kind"]) == ("fixed", "tip", "feature")
    assert tip["centre"][0] > 49 and tip["distance"] is None
    assert seat["distance"] == pytest.approx(0, abs=1e-6)
    assert seat["matches"][0]["count"] == 1
    assert fixed["area"] == pytest.approx(2 * 20, rel=0.7)


def test_faults_say_where_in_the_selector_they_are(recipe: Path):
    data = json.loads(recipe.read_text())
    data["fixed"][0]["where"] = [{"box": [[-10, -10, 0], [-8, 10]]}]
    data["handles"][0]["where"] = {"minus": [{"all": True}, {"grow": 1}]}
    data["features"][0]["vertices"] = [101]
    with pytest.raises(RecipeError) as caught:
        sheetmorph.validate(data, recipe.parent)
    told = str(caught.value)
    assert "fixed[0].where[0].box[1]: it has 2 entries" in told
    assert "handles[0] (tip).where.minus[1]: " in told
    assert "both vertices and a selector are given" in told


def test_a_selector_of_a_missing_thing_is_a_fault_of_its_region(recipe: Path):
    data = json.loads(recipe.read_text())
    data["features"][0]["where"] = {"found": "round hole", "diameter": [10, 12]}
    data["fixed"][0]["where"] = {"box": [[90, 0, 0], [91, 1, 1]]}
    with pytest.raises(RecipeError) as caught:
        sheetmorph.validate(data, recipe.parent)
    lines = str(caught.value).splitlines()
    assert lines[0].startswith('fixed[0].where: "box" selects nothing on "strip"')
    assert lines[1].startswith("features[0] (seat).where.diameter: no round hole has")


def test_selectors_stand_beside_auto_and_in_sides_of_contacts():
    above = PartMesh(STRIP.points + [0, 0, 1.0], STRIP.triangles)
    left = {"box": [[-10, -10, -9], [-8, 10, 9]]}
    side = {"half_space": {"point": [45, 0, 0], "normal": [1, 0, 0]}}
    middle = {"slab": {"point": [30, 0, 0], "normal": [1, 0, 0], "thickness": 1}}
    sides = {"a": {"part": "low", "where": side}, "b": {"part": "high", "where": side}}
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "low"}, {"name": "high"}],
        "primary": "low",
        "fixed": [{"part": "low", "where": left}],
        "handles": [{"name": "h", "part": "low", "where": middle}],
        "features": "auto",
        "contacts": [{"type": "tied", **sides}],
        "pose": {"h": {"translation": [0, 0, 1]}},
    }
    meshes = {"low": PartMesh(STRIP.points, STRIP.triangles), "high": above}
    report = Session(recipe, meshes).deform().report()
    sides = [entry for entry in report["regions"] if entry["kind"] == "side"]
    assert [entry["part"] for entry in sides] == ["low", "high"]
    assert sides[0]["centre"][0] > 45 and len(report["features"]) >= 3


def test_a_selector_means_the_same_after_weld_and_remesh(tmp_path: Path):
    write_plate(STRIP, tmp_path / "strip.obj", "obj")
    says = {"half_space": {"point": [5, 0, 0], "normal": [-1, 0, 0]}}
    areas = []
    for edge in (6.0, 3.0, 1.5):
        data = {
            "sheetmorph": 1,
            "parts": [{"name": "strip", "file": "strip.obj", "remesh": {"edge": edge}}],
            "fixed": [{"part": "strip", "where": says}],
            "handles": [{"name": "tip", "part": "strip", "where": {"rim_at": [44, 0, 0]}}],
            "pose": {"tip": {"translation": [0, 0, 5]}},
        }
        path = tmp_path / f"{edge}.json"
        path.write_text(json.dumps(data))
        report = run(path, tmp_path / f"out{edge}")
        areas.append(report["regions"][0]["area"])
        ids = resolve(path)
        (tmp_path / f"{edge}-ids.json").write_text(json.dumps(ids))
        run(tmp_path / f"{edge}-ids.json", tmp_path / f"ids{edge}")
        a, b = (tmp_path / f"{k}{edge}" / "strip.obj" for k in ("out", "ids"))
        assert a.read_bytes() == b.read_bytes()
    assert np.ptp(areas) < 0.03 * np.mean(areas)


OBJ = """g left shared
usemtl steel
v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0
f 1 2 5 4
g right shared
o thing
f 2 3 6
f 2 6 5
"""


def test_the_names_of_an_obj_are_groups(tmp_path: Path):
    (tmp_path / "a.obj").write_text(OBJ)
    shape = PartShape(sheetmorph.read_part(tmp_path / "a.obj").mesh)
    taken = {
        n: selected(shape, {"group": n}).vertices.tolist()
        for n in ("left", "g right", "steel", "thing")
    }
    assert taken["left"] == [0, 1, 3, 4] and taken["g right"] == [1, 2, 4, 5] == taken["thing"]
    assert taken["steel"] == [0, 1, 2, 3, 4, 5]
    with pytest.raises(SelectorError, match='"g left"'):
        selected(shape, {"group": "lefd"})


DECK = """SOL 101
SET 3 = 1,
 2
SET 9 = 4 THRU 6
BEGIN BULK
GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,2.,0.,0.
GRID,4,,0.,1.,0.
GRID,5,,1.,1.,0.
GRID,6,,2.,1.,0.
CQUAD4,1,7,1,2,5,4
CTRIA3,20,8,2,3,6
CTRIA3,21,8,2,6,5
SET1,5,20,THRU,21
ENDDATA
"""


def test_properties_and_sets_of_a_deck_are_groups(tmp_path: Path):
    (tmp_path / "a.bdf").write_text(DECK)
    mesh = sheetmorph.read_part(tmp_path / "a.bdf").mesh
    shape = PartShape(mesh)

    def ids(name):
        return mesh.file_ids(selected(shape, {"group": name}).vertices)

    assert ids("PID 7") == ids("7") == ids(7) == [1, 2, 4, 5]
    assert ids("SET 9") == [4, 5, 6] and ids("SET 5") == ids("PID 8") == [2, 3, 5, 6]
    assert ids("SET 3 nodes") == [1, 2] == ids("SET 3")
    assert ids("SET 3 elements") == [1, 2, 4, 5]


def test_groups_go_through_split_and_remesh(tmp_path: Path):
    (tmp_path / "a.obj").write_text(OBJ)
    data = {
        "sheetmorph": 1,
        "parts": [{"file": "a.obj", "split": True, "remesh": {"edge": 0.2}}],
        "fixed": [{"part": "a/1", "where": {"minus": [{"group": "left"}, {"group": "right"}]}}],
        "handles": [{"name": "tip", "part": "a/1", "where": {"face_at": [2, 0.5, 0]}}],
        "pose": {},
    }
    data["handles"][0]["where"] = {
        "intersection": [{"group": "right"}, {"box": [[1.8, 0, 0], [2, 1, 0]]}]
    }
    (tmp_path / "r.json").write_text(json.dumps(data))
    fixed, tip = run(tmp_path / "r.json", tmp_path / "out")["regions"]
    assert fixed["area"] == pytest.approx(1.0, rel=0.05)  # flats forget the line between
    assert tip["vertices"] > 6 and tip["centre"][0] > 1.8


def strips_in_two(driven: dict) -> dict:
    """Two strips above each other, welded at one end; what a region or a part says is driven."""
    end = {"half_space": {"point": [45, 0, 0], "normal": [1, 0, 0]}}
    sides = {"a": {"part": "low", "where": end}, "b": {"part": "high", "where": end}}
    return {
        "sheetmorph": 1,
        "parts": [{"name": "low"}, {"name": "high", "mode": 2, **driven}],
        "primary": "low",
        "fixed": [{"part": "low", "where": {"box": [[-10, -10, -9], [-8, 10, 9]]}}],
        "handles": [{"name": "h", "part": "low", "where": {"rim_at": [40, 4, 0]}}],
        "contacts": [{"type": "control mesh", **sides}],
        "pose": {"h": {"translation": [0, 0, 1], "rotation": {"axis": [0, 1, 0], "degrees": 9}}},
    }


def test_what_a_part_says_is_driven_is_a_follower():
    above = PartMesh(STRIP.points + [0, 0, 1.0], STRIP.triangles)
    meshes = {"low": PartMesh(STRIP.points, STRIP.triangles), "high": above}
    region = {"slab": {"point": [20, 0, 0], "normal": [1, 0, 0], "thickness": 9}}
    told = Session(strips_in_two({"driven": {"where": region}}), meshes).deform()
    listed = strips_in_two({})
    listed["regions"] = [{"part": "high", "where": region, "role": "follower"}]
    same = Session(listed, meshes).deform()
    without = Session(strips_in_two({}), meshes).deform()
    assert np.array_equal(told.positions["high"], same.positions["high"])
    assert not np.allclose(told.positions["high"], without.positions["high"], atol=1e-3)
    (entry,) = [e for e in told.report()["regions"] if e["kind"] == "follower"]
    assert entry["name"] == "high: driven" and entry["area"] > 0


def test_faults_of_what_is_driven_say_where(tmp_path: Path):
    write_plate(STRIP, tmp_path / "a.nas", "nas")
    write_plate(STRIP, tmp_path / "b.nas", "nas")
    recipe = strips_in_two({"driven": {"where": {"rim_at": [1, 2]}}})
    for part, name in zip(recipe["parts"], "ab"):
        part["file"] = f"{name}.nas"
    with pytest.raises(RecipeError, match=r"parts\[1\] \(high\)\.driven\.where\.rim_at"):
        sheetmorph.validate(recipe, tmp_path)
    recipe["parts"][1] |= {"driven": {"where": {"sphere": {"center": [900, 0, 0], "radius": 1}}}}
    with pytest.raises(RecipeError, match=r"\(high\)\.driven\.where: .* selects nothing"):
        sheetmorph.validate(recipe, tmp_path)
    recipe["parts"][1] |= {"driven": {"where": {"rim_at": [20, 4, 0]}}}
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    ids = resolve(tmp_path / "recipe.json")["parts"][1]["driven"]
    assert list(ids) == ["vertices"] and len(ids["vertices"]) > 8
    recipe["parts"][1] |= {"split": True}
    with pytest.raises(RecipeError, match="the entry is for several parts"):
        sheetmorph.validate(recipe, tmp_path)
