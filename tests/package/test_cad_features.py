# SPDX-License-Identifier: LGPL-2.1-or-later
"""What CAD surfaces say about a part, exact to rounding, and what a bare mesh can know."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

from cad_samples import make_cad_samples
from sheetmorph import PartMesh, _core, read_part, run
from sheetmorph.cli import main
from sheetmorph.files.cad_file import exact_features
from sheetmorph.finding import FindOptions, FindPart, find, find_schema, parts_of_files
from test_real_files import real_file


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of CAD files."""
    return make_cad_samples(tmp_path_factory.mktemp("cad"))


@pytest.mark.parametrize("degrees", [5, 20, 40])
def test_holes_of_step_are_exact_and_fits_are_within_the_chordal_error(
    samples: Path, degrees: float
):
    sizes = {"edge": 8.0, "deflection": 2.0, "angle": degrees}
    part = read_part(samples / "fixture.step", sizes).model.parts[0]
    holes = [f for f in exact_features(part) if f["kind"] == "round hole"]
    assert sorted(hole["radius"] for hole in holes) == pytest.approx([3, 5], abs=1e-13)
    for hole in holes:
        x = 15 if hole["radius"] < 4 else 40
        assert np.allclose(hole["center"], [x, 20, 1], atol=1e-12)
        assert np.allclose(hole["axis"], [0, 0, 1], atol=1e-13)
        assert hole["residual"] < 1e-12
        rim = [v for v in hole["vertices"] if part.points[v, 2] > 2 - 1e-9]
        assert len(rim) >= 360 / degrees - 1e-9
        fit = _core.fit_circle(part.points[rim])
        chordal = hole["radius"] * (1 - np.cos(np.pi / len(rim)))
        assert abs(fit.radius - hole["radius"]) <= chordal
        assert np.abs(fit.axis) == pytest.approx([0, 0, 1], abs=1e-12)


def test_a_real_enclosure_is_38_closed_parts_with_all_its_holes():
    """Diameters 3.3, 5 and 6 mm, from the README of the data: 155, 109 and 120 of 458 faces."""
    sizes = {"edge": 60.0, "deflection": 1.0, "angle": 30}
    model = read_part(real_file("03-laser4diy-enclosure/Enclosure_v3_v9.step"), sizes).model
    names = {part.name for part in model.parts}
    assert len(names) == 38 and "CornerBracket 4" in names
    assert not any(auto in name for name in names for auto in ("COMPOUND", "=>"))
    for part in model.parts:
        assert part.is_closed and part.skipped_faces == [], part.name
        assert part.deviation <= 1.5 * model.deflection, part.name
    holes = [f for p in model.parts for f in exact_features(p) if f["kind"] == "round hole"]
    counts = {d: sum(abs(2 * h["radius"] - d) < 1e-9 for h in holes) for d in (3.3, 5.0, 6.0)}
    assert counts == {3.3: 155, 5.0: 109, 6.0: 120}
    # The edges of the file are within its own uncertainty, 0.01 mm, of the surfaces.
    assert max(hole["residual"] for hole in holes) < 1e-3
    assert np.median([hole["residual"] for hole in holes]) < 1e-9
    bends = {"CornerBracket": 1, "LaserChamberv3 v16.ChamberTop": 2}
    for body in (part for part in model.parts if part.name in bends):
        assert_bends_as_drawn(body, bends[body.name])


def assert_bends_as_drawn(body: Any, count: int) -> None:
    """Bends of 90 degrees of a sheet of 1 mm, with an inner radius of 1 mm."""
    mesh = PartMesh(body.points, body.triangles)
    found = find([FindPart(body.name, mesh, exact=exact_features(body))]).features
    bends = [entry for entry in found if entry["kind"] == "bend"]
    assert len(bends) == count
    for bend in bends:
        assert bend["radius"] == pytest.approx(1.0, abs=1e-9)
        assert bend["depth"] == pytest.approx(1.0, abs=1e-9)
        assert np.degrees(bend["angle"]) == pytest.approx(90.0, abs=1e-6)


def test_find_gives_what_the_surfaces_say(samples: Path, capsys: pytest.CaptureFixture):
    assert main(["find", str(samples / "fixture.step")]) == 0
    found = json.loads(capsys.readouterr().out)
    jsonschema.validate(found, find_schema())
    assert found["parts"][0]["split"] is True
    holes = [entry for entry in found["features"] if entry["kind"] == "round hole"]
    assert {hole["part"] for hole in holes} == {"fixture/plate"} and len(holes) == 2
    assert sorted(hole["radius"] for hole in holes) == pytest.approx([3, 5], abs=1e-13)
    assert all(hole["residual"] < 1e-12 and hole["rims"] and hole["washer"] for hole in holes)
    cylinders = [entry for entry in found["features"] if entry["kind"] == "cylinder"]
    pins = [entry for entry in cylinders if not entry["hollow"]]
    assert sorted(pin["part"] for pin in pins) == ["fixture/pin", "fixture/pin 2"]
    assert all(min(abs(c["radius"] - r) for r in (3, 5)) < 1e-13 for c in cylinders)
    pairs = {(contact["a"]["part"], contact["b"]["part"]) for contact in found["contacts"]}
    assert pairs == {("fixture/plate", "fixture/pin")}


def test_find_meshes_cad_files_as_finely_as_asked(samples: Path, capsys: pytest.CaptureFixture):
    counts = []
    for degrees in ("40", "10"):
        wanted = f"--angle {degrees} --edge 20 --deflection 2 --kind".split()
        assert main(["find", str(samples / "plate.brep"), *wanted, "round hole"]) == 0
        found = json.loads(capsys.readouterr().out)
        jsonschema.validate(found, find_schema())
        sizes = {"angle": float(degrees), "edge": 20.0, "deflection": 2.0}
        assert found["parts"][0]["mesh"] == sizes
        counts.append([len(hole["rims"][0]) for hole in found["features"]])
    assert max(counts[0]) <= 12 and min(counts[1]) >= 36


@pytest.mark.parametrize("degrees", [10, 30])
def test_holes_of_a_bare_mesh_are_found_within_the_chordal_error(samples: Path, degrees: float):
    """The triangles of the STEP file alone, as an STL of it would hold them."""
    sizes = {"edge": 8.0, "deflection": 2.0, "angle": degrees}
    part = read_part(samples / "fixture.step", sizes).model.parts[0]
    bare = FindPart("plate", PartMesh(part.points, part.triangles))
    holes = find([bare], FindOptions(kinds=("round hole",))).features
    assert len(holes) == 2
    for hole, (x, radius) in zip(sorted(holes, key=lambda h: h["radius"]), ((15, 3), (40, 5))):
        chordal = radius * (1 - np.cos(np.pi / len(hole["rims"][0])))
        assert abs(hole["radius"] - radius) <= chordal
        assert np.allclose(hole["center"][:2], [x, 20], atol=chordal)
        assert np.abs(hole["axis"]) == pytest.approx([0, 0, 1], abs=1e-9)


def test_slots_and_rectangles_of_step_are_exact(samples: Path, capsys: pytest.CaptureFixture):
    kinds = ["--kind", "slotted hole", "--kind", "rectangular hole"]
    assert main(["find", str(samples / "openings.step"), *kinds]) == 0
    found = json.loads(capsys.readouterr().out)
    jsonschema.validate(found, find_schema())
    keys = ("kind", "length", "width", "radius", "depth")
    told = sorted(tuple(entry[key] for key in keys) for entry in found["features"])
    assert [one[0] for one in told] == ["rectangular hole"] * 2 + ["slotted hole"]
    sizes = [(16, 10, 0, 3), (30, 20, 4, 3), (32, 8, 4, 3)]
    assert np.allclose([one[1:] for one in told], sizes, rtol=0, atol=1e-10)
    turn = np.array([1, 2, 3]) / np.sqrt(14)
    angle = np.radians(25)
    for entry in found["features"]:
        place = (75, 30) if entry["length"] == pytest.approx(30) else (32, 30)
        place = (105, 30) if entry["length"] == pytest.approx(16) else place
        center = _rotated(np.array([*place, 1.5]), turn, angle)
        axis = _rotated(np.array([0.0, 0.0, 1.0]), turn, angle)
        off = np.array(entry["center"]) - center
        assert np.linalg.norm(np.cross(off, axis)) < 1e-10
        assert abs(axis @ entry["axis"]) == pytest.approx(1.0, abs=1e-12)
        assert entry["residual"] < 1e-9


def _rotated(point: np.ndarray, axis: np.ndarray, angle: float) -> np.ndarray:
    """Rodrigues."""
    return (
        np.cos(angle) * point
        + np.sin(angle) * np.cross(axis, point)
        + (1 - np.cos(angle)) * (axis @ point) * axis
    )


def test_a_recipe_finds_what_the_surfaces_say(samples: Path, tmp_path: Path):
    recipe = {
        "sheetmorph": 1,
        "parts": [{"file": str(samples / "fixture.step"), "split": "components"}],
        "primary": "fixture/plate",
        "features": "auto",
    }
    points = parts_of_files([samples / "fixture.step"]).meshes["fixture/plate"].points
    for section, of_end in (("fixed", points[:, 0] < 1), ("handles", points[:, 0] > 59)):
        end = {"part": "fixture/plate", "vertices": np.flatnonzero(of_end).tolist()}
        recipe[section] = [{"name": section, **end}]
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    found = run(path, tmp_path / "out")["found"]
    assert len(found["features"]) == 2
    assert sorted(hole["radius"] for hole in found["features"]) == pytest.approx([3, 5], abs=1e-13)
    assert "contacts" not in found
