# SPDX-License-Identifier: LGPL-2.1-or-later
"""What overlaps is one body; what is proposed fits together; what nothing holds stays."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sheetmorph
from lumpy_plates import ends, raised
from plates import plate
from sheet_meshes import circle, flat, inside, lifted, polygon, rounded
from sheetmorph import PartMesh, Session
from sheetmorph.morph.running import CertificateError
from bending import bent_and_twisted


def standoff_plate() -> tuple[np.ndarray, np.ndarray]:
    """A plate 2 mm thick with standoffs, each with a blind hole that ends above the plate."""
    outline = polygon([(0, 0), (120, 0), (120, 160), (0, 160)], 4.0)
    places = [(30.0, 60.0), (90.0, 60.0), (60.0, 110.0)]
    posts = [circle(place, 3.5, 20) for place in places]
    blind = [circle(place, 1.25, 12) for place in places]
    points, triangles = flat(outline, [], 4.0, [*posts, *blind])
    centres = points[triangles].mean(axis=1)
    rise = np.zeros(len(triangles))
    for post, hole in zip(posts, blind):
        rise[inside(post, centres)] = 8.0
        rise[inside(hole, centres)] = 3.0
    return raised(points, triangles, rise)


def bent(points: np.ndarray, triangles: np.ndarray, **keys: Any) -> sheetmorph.Result:
    held, moved = (np.flatnonzero(end).tolist() for end in ends(points))
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", **keys.pop("part", {})}],
        "fixed": [{"part": "plate", "vertices": held}],
        "handles": [{"name": "end", "part": "plate", "vertices": moved}],
        "features": "auto",
        "pose": {"end": bent_and_twisted(144.0, 40.0, 20.0)},
        **keys,
    }
    return Session(recipe, {"plate": PartMesh(points, triangles)}).deform()


def test_blind_holes_in_the_standoffs_of_a_thin_solid_are_one_body_with_them():
    result = bent(*standoff_plate(), part={"thin": "auto"})
    report = result.report()
    assert result.session.thin_solid("plate") is not None
    pairs = [
        labels
        for labels in result.session.joined_bodies
        if any("lump" in label for label in labels) and any("round hole" in x for x in labels)
    ]
    assert len(pairs) == 3
    assert report["certificate"] == {"passed": True, "failures": []}
    assert any(
        "form one rigid body, because they share vertices" in note for note in report["notes"]
    )


def test_auto_keeps_every_rim_that_is_no_outline():
    outline = polygon([(0, 0), (120, 0), (120, 160), (0, 160)], 4.0)
    loops = [
        *(circle((x, 40.0), 4.0, 6) for x in (30.0, 60.0, 90.0)),
        rounded((60.0, 70.0), (70.0, 8.0), 4.0, 2.0),
        circle((30.0, 110.0), 9.0, 24),
        polygon([(75, 95), (105, 95), (90, 120)], 40.0),
        polygon([(45, 130), (60, 125), (58, 140), (75, 128), (75, 145), (45, 145)], 5.0),
    ]
    points, triangles = flat(outline, loops, 4.0)
    report = bent(lifted(points), triangles).report()
    assert len(report["features"]) == len(loops)
    assert report["found"]["left_out"] == []
    assert report["certificate"]["passed"]


def test_kinds_that_are_left_out_are_told():
    outline = polygon([(0, 0), (120, 0), (120, 160), (0, 160)], 4.0)
    loops = [circle((60.0, 60.0), 8.0, 24), polygon([(45, 95), (75, 95), (60, 120)], 40.0)]
    points, triangles = flat(outline, loops, 4.0)
    report = bent(lifted(points), triangles, features={"auto": {"kinds": ["round hole"]}}).report()
    assert len(report["features"]) == 1
    told = report["found"]["left_out"]
    assert told and all('"kinds" excludes holes' in text for text in told)


def layers(count: int) -> tuple[dict[str, Any], dict[str, PartMesh]]:
    """Plates with the same bolt holes, one above the other."""
    given = plate()
    names = [f"layer{k}" for k in range(count)]
    meshes = {
        name: PartMesh(given.points + (0.0, 0.0, 1.0 * k), given.triangles)
        for k, name in enumerate(names)
    }
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name} for name in names],
        "primary": names[0],
        "fixed": [{"part": names[0], "vertices": given.left}],
        "handles": [{"name": "tip", "part": names[0], "vertices": given.right}],
        "features": "auto",
        "contacts": {"auto": {"gap": 2.5}},
        "pose": {"tip": {"translation": [0, 0, 6]}},
    }
    return recipe, meshes


def test_a_stack_of_three_layers_on_every_bolt_solves_as_it_is_proposed():
    recipe, meshes = layers(3)
    report = Session(recipe, meshes).deform().report()
    bolts = [entry for entry in report["found"]["contacts"] if entry["kind"] == "bolt"]
    assert len(bolts) == 9 and {entry["type"] for entry in bolts} == {"rigid"}
    assert report["certificate"]["passed"] and report["unreached"] == []
    kept = {c["name"]: c["deviation"] for c in report["contacts"] if c["type"] == "rigid"}
    assert len(kept) == 9 and max(kept.values()) < 1e-9


def test_a_rigid_proposal_between_two_regions_is_tied_and_told():
    recipe, meshes = layers(2)
    points = meshes["layer0"].points
    recipe["fixed"][0]["vertices"] = np.flatnonzero(points[:, 0] < 3.0).tolist()
    lower = plate().rims[0]
    recipe["fixed"] = [{"part": "layer0", "vertices": lower}]
    recipe["handles"].append({"name": "other", "part": "layer1", "vertices": lower})
    report = Session(recipe, meshes).deform().report()
    (told,) = [text for text in report["found"]["left_out"] if "tied instead of rigid" in text]
    assert '"other"' in told and "fixed region" in told
    assert report["certificate"]["passed"]


def loose(unheld: str | None) -> dict[str, Any]:
    """Two sheets in one part, one of them held; the report, with the positions of the other."""
    given = plate()
    count = len(given.points)
    points = np.vstack([given.points, given.points + (0, 0, 30.0)])
    mesh = PartMesh(points, np.vstack([given.triangles, given.triangles + count]))
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate"}],
        "fixed": [{"part": "plate", "vertices": given.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": given.right}],
        "pose": {"tip": {"translation": [0, 0, 6]}},
        **({} if unheld is None else {"unheld": unheld}),
    }
    result = Session(recipe, {"plate": mesh}).deform()
    report = result.report()
    return {**report, "moved": np.abs(result.positions["plate"] - points)[count:].max()}


def test_what_nothing_holds_stays_at_rest_with_a_warning_or_goes_along_or_is_refused():
    report = loose(None)
    assert report["moved"] == 0.0
    assert any("are unconstrained and stay at rest" in text for text in report["warnings"])
    along = loose("along")
    assert along["moved"] > 0.1
    assert any("move along" in text for text in along["warnings"])
    with pytest.raises(sheetmorph.RecipeError, match="nothing constrains"):
        loose("refuse")


def torn_recipe(folder: Path) -> Path:
    """A recipe file of two plates whose contact opens far beyond its gap."""
    given = plate()
    rows = {"lower": 0.0, "upper": 1.0}
    for name, height in rows.items():
        lines = [f"v {x!r} {y!r} {height!r}" for x, y, _ in given.points.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (given.triangles + 1).tolist()]
        (folder / f"{name}.obj").write_text("\n".join(lines) + "\n")
    sides = {"vertices": list(range(len(given.points)))}
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name, "file": f"{name}.obj"} for name in rows],
        "primary": "lower",
        "fixed": [{"part": "lower", "vertices": given.left}],
        "handles": [{"name": "tip", "part": "lower", "vertices": given.right}],
        "contacts": [
            {"name": "seam", "a": {"part": "lower", **sides}, "b": {"part": "upper", **sides}}
        ],
        "pose": {"tip": {"rotation": {"axis": [1, 0, 0], "degrees": 150}}},
    }
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe))
    return path


def test_a_contact_that_opens_badly_is_a_warning_and_fails_a_strict_run(tmp_path: Path):
    path = torn_recipe(tmp_path)
    report = sheetmorph.run(path, tmp_path / "out")
    (told,) = [text for text in report["warnings"] if text.startswith('the gap of "seam"')]
    assert "half its gap of 1 mm" in told and "tied or rigid" in told
    assert set(report["warnings"]) <= set(report["notes"])
    with pytest.raises(CertificateError, match="seam"):
        sheetmorph.run(path, tmp_path / "strict", strict=True)
    assert not (tmp_path / "strict").exists()
    with pytest.raises(CertificateError, match="seam"):
        sheetmorph.check(path, strict=True)


def test_a_primary_that_nothing_of_its_own_holds_is_told():
    recipe, meshes = layers(2)
    recipe["fixed"][0]["part"] = "layer1"
    recipe["contacts"] = {"auto": {"gap": 2.5, "type": "tied"}}
    report = Session(recipe, meshes).deform().report()
    (told,) = [text for text in report["warnings"] if "has no fixed region" in text]
    assert '"layer0"' in told and '"layer1"' in told


def test_check_tries_every_pose_that_run_can_be_told(tmp_path: Path):
    path = torn_recipe(tmp_path)
    recipe = json.loads(path.read_text())
    recipe["pose"] = {}
    recipe["poses"] = {"far": {"tip": {"rotation": {"axis": [1, 0, 0], "degrees": 150}}}}
    path.write_text(json.dumps(recipe))
    (told,) = sheetmorph.check(path)
    assert told.startswith('pose "far": the gap of "seam" changes')
    assert sheetmorph.check(path, pose={}) == []
    with pytest.raises(CertificateError, match="seam"):
        sheetmorph.check(path, strict=True)
    assert sorted(file.name for file in tmp_path.iterdir()) == [
        "lower.obj",
        "recipe.json",
        "upper.obj",
    ]


def test_the_worst_edge_and_the_worst_fold_are_in_the_report():
    given = plate()
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate"}],
        "fixed": [{"part": "plate", "vertices": given.left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": given.right}],
        "pose": {"tip": {"translation": [200, 0, 0]}},
    }
    mesh = {"plate": PartMesh(given.points, given.triangles)}
    report = Session(recipe, mesh).deform().report()
    assert report["parts"][0]["quality"]["worst_strain"] > 0.5
    assert any("changes its length by" in text for text in report["warnings"])
    recipe["pose"] = {"tip": {"rotation": {"axis": [0, 1, 0], "degrees": -90}}}
    quality = Session(recipe, mesh).deform().report()["parts"][0]["quality"]
    assert 1.0 < quality["worst_fold_degrees"] < 90.0


def grids(sizes: list[int]) -> dict[str, PartMesh]:
    """Square sheets of so many vertices a side, apart from each other."""
    found = {}
    for number, count in enumerate(sizes):
        x, y = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
        points = np.stack([x.ravel(), y.ravel() + 50.0 * number, 0.0 * x.ravel()], axis=1)
        corner = np.arange(count * count).reshape(count, count)[:-1, :-1].ravel()
        triangles = [corner[:, None] + [0, count, count + 1], corner[:, None] + [0, count + 1, 1]]
        found[f"sheet {number}"] = PartMesh(points, np.concatenate(triangles))
    return found


@settings(max_examples=60)
@given(st.data())
def test_parts_that_nothing_reaches_change_nothing(data: st.DataObject):
    """Whatever the order and the sizes of the parts, and whatever is joined rigidly to what."""
    meshes = grids(data.draw(st.lists(st.integers(4, 12), min_size=3, max_size=7)))
    names = list(meshes)
    reached = data.draw(st.lists(st.sampled_from(names), min_size=1, unique=True))
    others = [name for name in names if name not in reached]

    def side(name: str, corner: int) -> dict[str, Any]:
        count = len(meshes[name].points)
        return {"part": name, "vertices": [abs(corner * (count - 1) - k) for k in range(3)]}

    def contacts(of: list[str]) -> list[dict[str, Any]]:
        """Every one of some parts to one before it."""
        return [
            {"name": f"bolt {a} {b}", "type": "rigid", "a": side(a, 1), "b": side(b, 0)}
            for k, b in enumerate(of[1:], 1)
            for a in [data.draw(st.sampled_from(of[:k]))]
        ]

    joined = contacts(reached)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name} for name in names],
        "primary": reached[0],
        "fixed": [side(reached[0], 0)],
        "handles": [{"name": "end", **side(reached[0], 1)}],
        "contacts": [*joined, *contacts(others)],
        "pose": {"end": {"translation": [0, 0, 2], "rotation": {"axis": [1, 0, 0], "degrees": 9}}},
    }
    result = Session(recipe, meshes).deform()
    alone = {"parts": [{"name": name} for name in names if name in reached], "contacts": joined}
    own = {name: mesh for name, mesh in meshes.items() if name in reached}
    expected = Session({**recipe, **alone}, own).deform()
    for name in reached:
        assert np.array_equal(result.positions[name], expected.positions[name])
    for name in others:
        assert np.array_equal(result.positions[name], meshes[name].points)
    assert sorted(result.session.unreached) == sorted(others)
    assert result.session.joined_bodies == expected.session.joined_bodies
