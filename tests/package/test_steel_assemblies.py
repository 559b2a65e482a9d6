# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steel sheets in assemblies: contacts, features and their pairs hold as with other energies."""

from __future__ import annotations

import json
from collections import Counter

import numpy as np
import pytest

pytest.importorskip("scipy")

import sheetmorph  # noqa: E402
from sheet_meshes import circle, flat, lifted, polygon, thickened  # noqa: E402
from sheetmorph.cli import main  # noqa: E402

STEP, LENGTH, HALF, RADIUS, AROUND = 5.0, 90.0, 20.0, 6.0, 12
CONTACTS = ("control mesh", "tied", "rigid")
BEND = {"translation": [-6, 0, 22], "rotation": {"axis": [0, -1, 0], "degrees": 35}}


class Plate:
    """A plate with two round holes at 25 and 65 mm of its 90; `rims`: their vertices."""

    def __init__(self, start: float = 0.0, height: float = 0.0, lines: tuple = ()):
        ends = (start, start + LENGTH)
        corners = [(ends[0], -HALF), (ends[1], -HALF), (ends[1], HALF), (ends[0], HALF)]
        outline = polygon(corners, STEP)
        holes = [circle((start + x, 0.0), RADIUS, AROUND) for x in (25.0, 65.0)]
        flat_points, self.triangles = flat(outline, holes, STEP, lines)
        self.points = lifted(flat_points, height)
        self.loops = [len(outline), AROUND, AROUND]
        first = len(outline)
        self.rims = [list(range(first + AROUND * k, first + AROUND * (k + 1))) for k in (0, 1)]

    def between(self, low: float, high: float) -> list[int]:
        x = self.points[:, 0]
        return np.flatnonzero((x > low - 1e-6) & (x < high + 1e-6)).tolist()

    def mesh(self) -> sheetmorph.PartMesh:
        return sheetmorph.PartMesh(self.points, self.triangles)


def part(name: str) -> dict:
    return {"name": name, "file": f"{name}.obj", "thickness": 1.0}


def single(plate: Plate, **more) -> dict:
    """A recipe of one plate, bent, with a form feature at each hole."""
    seat = {"part": "base", "name": "seat", "vertices": plate.rims[0]}
    eye = {"part": "base", "name": "eye", "vertices": plate.rims[1]}
    found = {
        "sheetmorph": 1,
        "parts": [part("base")],
        "energy": "steel",
        "fixed": [{"part": "base", "name": "wall", "vertices": plate.between(0, 0)}],
        "handles": [{"part": "base", "name": "tip", "vertices": plate.between(LENGTH, LENGTH)}],
        "features": [{**seat, **more.pop("seat", {})}, eye],
        "pose": {"tip": BEND},
    }
    return {**found, **more}


def double(base: Plate, top: Plate, kind: str, **more) -> dict:
    """A recipe of two plates that lap between 74 and 89 mm; the eye and the lug are coaxial."""
    recipe = single(base, **more)
    recipe["parts"] = [part("base"), part("top")]
    recipe["primary"] = "base"
    names = zip(("lug", "far"), top.rims)
    recipe["features"] += [{"part": "top", "name": name, "vertices": rim} for name, rim in names]
    sides = {"base": base.between(74, 89), "top": top.between(74, 89)}
    a, b = ({"part": name, "vertices": ids} for name, ids in sides.items())
    return {**recipe, "contacts": [{"name": "lap", "type": kind, "a": a, "b": b}]}


def lapping(kind: str, **more) -> tuple[dict, dict[str, Plate]]:
    plates = {"base": Plate(), "top": Plate(40.0, 2.0)}
    return double(plates["base"], plates["top"], kind, **more), plates


def deformed(recipe: dict, plates: dict[str, Plate], **more):
    meshes = {name: plate.mesh() for name, plate in plates.items()}
    return sheetmorph.Session({**recipe, **more}, meshes).deform()


def require_sound(result) -> dict:
    """What every pose keeps; the report."""
    report = result.report()
    assert all(np.isfinite(points).all() for points in result.positions.values())
    assert report["certificate"]["passed"], report["certificate"]["failures"]
    rest = result.session.meshes["base"].points
    wall = rest[:, 0] < 1e-6  # of every recipe here
    assert np.array_equal(result.positions["base"][wall], rest[wall])
    for entry in report["parts"]:
        assert entry["quality"]["flipped"] == 0, entry["name"]
    return report


def centre(result, name: str) -> np.ndarray:
    feature = next(f for f in result.features if f.name == name)
    ids = result.session.feature_vertices(name)
    return result.positions[feature.part][ids].mean(axis=0)


def rotation(result, name: str) -> np.ndarray:
    return next(f for f in result.features if f.name == name).rotation


LINKS = {
    "alone": {},
    "group": {"groups": [{"features": ["lug", "far"]}]},
    "distance on a part": {"distance": [{"features": ["seat", "eye"]}]},
    "distance of two parts": {"distance": [{"features": ["eye", "far"]}]},
    "coaxial": {"coaxial": [{"features": ["eye", "lug"]}]},
    "coaxial and distance": {
        "coaxial": [{"features": ["eye", "lug"]}],
        "distance": [{"features": ["lug", "far"]}],
    },
    "one control mesh": {"propagation": {"type": "single"}},
}


@pytest.mark.parametrize("kind", CONTACTS)
@pytest.mark.parametrize("link", LINKS)
def test_contacts_and_links_hold_and_nothing_tears(kind, link):
    recipe, plates = lapping(kind, **LINKS[link])
    result = deformed(recipe, plates)
    report = require_sound(result)
    linear = deformed(recipe, plates, energy="neumann")
    handle = plates["base"].between(LENGTH, LENGTH)
    assert np.array_equal(result.positions["base"][handle], linear.positions["base"][handle])
    if link != "one control mesh":  # which ignores contacts
        (contact,), (before,) = report["contacts"], linear.report()["contacts"]
        assert contact["gap_change"] <= before["gap_change"] + 1e-9
    for pair in recipe.get("distance", []):
        rests = [centre(deformed({**recipe, "pose": {}}, plates), n) for n in pair["features"]]
        now = [centre(result, name) for name in pair["features"]]
        lengths = [np.linalg.norm(a - b) for a, b in (rests, now)]
        assert lengths[1] == pytest.approx(lengths[0], abs=1e-9)
    if "coaxial" in recipe:
        a, b = (rotation(result, name)[:, 2] for name in ("eye", "lug"))
        gap = centre(result, "lug") - centre(result, "eye")
        assert np.linalg.norm(np.cross(a, b)) < 1e-9
        assert np.linalg.norm(np.cross(a, gap)) < 1e-8
    if "groups" in recipe:
        assert np.allclose(rotation(result, "lug"), rotation(result, "far"), atol=1e-12)
    # A body that the sheet has lost would show as triangles drawn out around it.
    stretches = [entry["stretch"]["largest"] for entry in report["parts"]]
    assert stretches[0] < 0.02 and stretches[1] < 0.15, stretches


@pytest.mark.parametrize("link", ["distance on a part", "coaxial"])
def test_a_pose_of_linked_features_does_not_depend_on_the_one_before(link):
    """The same pose after another one is the same to the bit."""
    recipe, plates = lapping("tied", **LINKS[link])
    session = sheetmorph.Session(recipe, {name: p.mesh() for name, p in plates.items()})
    first = session.deform()
    session.deform({"tip": {"translation": [0, 0, 3]}})
    again = session.deform()
    for name in plates:
        assert np.array_equal(first.positions[name], again.positions[name])


@pytest.mark.parametrize(
    "motion",
    [
        {"type": "fixed"},
        {"type": "translation"},
        {"type": "plane", "normal": [0, 1, 0]},
        {"type": "line", "direction": [0, 0, 1]},
        {"type": "axis", "point": [25, 0, 0], "direction": [0, 1, 0]},
    ],
    ids=lambda motion: motion["type"],
)
def test_features_keep_to_their_motions(motion):
    plate = Plate()
    result = deformed(single(plate, seat={"motion": motion}), {"base": plate})
    report = require_sound(result)
    shift = centre(result, "seat") - [25, 0, 0]
    turn = rotation(result, "seat")
    if motion["type"] in ("fixed", "axis"):
        assert np.abs(shift).max() < 1e-9
    if motion["type"] in ("fixed", "translation"):
        assert np.allclose(turn, np.eye(3), atol=1e-12)
    if motion["type"] in ("plane", "line"):
        assert abs(shift[1]) < 1e-9
    if motion["type"] == "line":
        assert abs(shift[0]) < 1e-9 and abs(shift[2]) > 0.1
    if motion["type"] in ("plane", "axis"):
        assert np.allclose(turn @ [0, 1, 0], [0, 1, 0], atol=1e-12)
    assert report["parts"][0]["stretch"]["largest"] < 0.02


def test_a_sized_hole_has_its_size():
    plate = Plate()
    result = deformed(single(plate, seat={"size": 15.0}), {"base": plate})
    require_sound(result)
    ids = result.session.feature_vertices("seat")
    radii = np.linalg.norm(result.positions["base"][ids] - centre(result, "seat"), axis=1)
    assert np.allclose(radii, 7.5, atol=1e-9)


def test_a_handle_that_turns_freely_is_one_body_and_relieves_the_sheet():
    plate = Plate()
    tip = {**single(plate)["handles"][0], "rotation": "free"}
    pose = {"tip": {"translation": BEND["translation"]}}
    free = deformed(single(plate, handles=[tip], pose=pose), {"base": plate})
    held = deformed(single(plate, pose=pose), {"base": plate})
    ids = list(tip["vertices"])
    after, before = free.positions["base"][ids], plate.points[ids]
    assert np.allclose(after.mean(axis=0) - before.mean(axis=0), BEND["translation"], atol=1e-9)
    lengths = [np.linalg.norm(p[:, None] - p[None, :], axis=2) for p in (before, after)]
    assert np.allclose(*lengths, atol=1e-9)
    energy = [require_sound(r)["parts"][0]["stretch"]["springs_back"] for r in (free, held)]
    assert energy[0] < energy[1]


def test_a_symmetric_pose_stays_symmetric():
    rows = np.stack(
        np.meshgrid(np.linspace(0, 60, 13), np.linspace(-20, 20, 9), indexing="ij"), axis=-1
    )
    points = lifted(rows.reshape(-1, 2))
    triangles = []
    for i, j in np.ndindex(12, 8):
        a, b, c, d = 9 * i + j, 9 * i + j + 9, 9 * i + j + 10, 9 * i + j + 1
        triangles += [(a, b, c), (a, c, d)] if j < 4 else [(a, b, d), (b, c, d)]
    recipe = {
        "sheetmorph": 1,
        "parts": [part("base")],
        "energy": "steel",
        "fixed": [{"part": "base", "name": "wall", "vertices": list(range(9))}],
        "handles": [{"part": "base", "name": "tip", "vertices": [108, 109]}],
        "features": [{"part": "base", "name": "seat", "vertices": [55, 56, 64, 65]}],
        "symmetry": {"point": [0, 0, 0], "normal": [0, 1, 0]},
        "pose": {"tip": {"translation": [-1, 0, 8]}},
    }
    mesh = sheetmorph.PartMesh(points, np.array(triangles))
    result = sheetmorph.Session(recipe, {"base": mesh}).deform()
    require_sound(result)
    found = result.positions["base"].reshape(13, 9, 3)
    assert np.allclose(found, found[:, ::-1] * [1, -1, 1], atol=1e-5)


def test_a_web_on_the_sheet_goes_along():
    line = np.column_stack([np.full(7, 45.0), np.linspace(-15, 15, 7)])
    plate = Plate(lines=(line,))
    foot = [int(np.argmin(np.linalg.norm(plate.points[:, :2] - p, axis=1))) for p in line]
    count = len(plate.points)
    rows = [foot, *([count + 7 * k + j for j in range(7)] for k in (0, 1))]
    risen = [plate.points[foot] + [0, 0, 5.0 * k] for k in (1, 2)]
    web = [
        corners
        for low, high in zip(rows, rows[1:])
        for j in range(6)
        for corners in ((low[j], low[j + 1], high[j]), (low[j + 1], high[j + 1], high[j]))
    ]
    plate.points = np.vstack([plate.points, *risen])
    plate.triangles = np.vstack([plate.triangles, web])
    sides = Counter(
        tuple(sorted((int(t[k]), int(t[k - 1])))) for t in plate.triangles for k in range(3)
    )
    assert max(sides.values()) == 3
    report = require_sound(deformed(single(plate), {"base": plate}))
    assert report["parts"][0]["stretch"]["largest"] < 0.02


def test_a_thin_solid_with_a_distance_keeps_its_thickness():
    plate = Plate()
    points, triangles = thickened(plate.points[:, :2], plate.triangles, plate.loops, 2.0)
    plate.points, plate.triangles = points, triangles
    recipe = single(plate, distance=[{"features": ["seat", "eye"]}])
    recipe["parts"] = [{"name": "base", "file": "base.obj", "thin": {"thickness": 2.0}}]
    result = deformed(recipe, {"base": plate})
    report = require_sound(result)
    (entry,) = report["parts"]
    assert entry["steel"]["thickness"] == pytest.approx(2.0)
    assert entry["thin"]["largest_change"] < 0.1


@pytest.mark.parametrize("thickness", [1e-4, 1e-7])
def test_a_thin_sheet_is_buckled_or_not_written(thickness: float, tmp_path, capsys):
    """Rounding decides whether so thin a sheet settles, so both answers are right; not a third."""
    plate = Plate()
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in plate.points.tolist()]
    lines += ["f {} {} {}".format(*(row + 1)) for row in plate.triangles]
    (tmp_path / "base.obj").write_text("\n".join(lines) + "\n")
    crushed = single(plate, pose={"tip": {"translation": [-150, 0, 0]}})
    crushed["parts"][0]["thickness"] = thickness
    (tmp_path / "recipe.json").write_text(json.dumps(crushed))
    report, written = tmp_path / "report.json", tmp_path / "out" / "base.obj"
    arguments = ["run", str(tmp_path / "recipe.json"), "-o", str(tmp_path / "out")]
    status = main([*arguments, "--report", str(report)])
    has_settled = json.loads(report.read_text())["parts"][0]["unsettled"] is None
    assert status == (0 if has_settled else 3)
    assert written.exists() == has_settled
    assert has_settled != ("did not converge" in capsys.readouterr().err)
    if has_settled:
        edges = plate.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        moved = sheetmorph.read_part(written).mesh.points
        after, before = (
            np.linalg.norm(np.diff(p[edges], axis=1), axis=-1) for p in (moved, plate.points)
        )
        assert (after / before).min() > 0.6


def test_a_sheet_that_is_crushed_settles_by_either_energy():
    plate = Plate()
    recipe = single(plate, pose={"tip": {"translation": [-150, 0, 0]}})
    linear, steel = (
        sheetmorph.Session(
            {**recipe, "energy": energy},
            {"base": sheetmorph.PartMesh(plate.points, plate.triangles)},
        ).deform()
        for energy in ("neumann", "steel")
    )
    assert not linear.unsettled and not steel.unsettled
    held = plate.between(LENGTH, LENGTH)
    assert np.abs(steel.positions["base"][held] - plate.points[held] - [-150, 0, 0]).max() < 1e-9
