# SPDX-License-Identifier: LGPL-2.1-or-later
"""Public and own CAD parts, bent and twisted by a tenth of their size and written as STEP again: a
table of what the files hold. ./sheetmorph test shapes prints it; it takes minutes."""

from __future__ import annotations

import os
import re
import time
from pathlib import Path

import numpy as np
import pytest

from bent_parts import bent
from in_freecad import Cut, read_in_freecad
from own_parts import make_own_parts
from sheetmorph import read_part
from sheetmorph.files.cad_writing import CadWriting, write_model
from sheetmorph.reporting.shapes import body_faults

SHARED = Path(os.environ.get("SHEETMORPH_SHARED") or Path(__file__).resolve().parents[3] / "shared")
SETS = {
    "06": "data/06-laser-cut-box/box_sides.step",
    "03": "data/03-laser4diy-enclosure/Enclosure_v3_v9.step",
}
WRITING = CadWriting("step")
KINK = 0.5  # degrees, at edges that were smooth
RADIUS = 1e-12  # relative: how far the radius of a kept cylinder may be off
CUT = 0.01  # of the volume: how far that of a half may be off, sheets and chords are what they are
HOLES = {"06": 0, "03": 52}  # drawn in FreeCAD, at most two a solid; those of set 06 are in halves
# The part whose mesh in FreeCAD passes through itself, and how deep it may, mm.
CROSSING = {"MainEnclosure.MainSheet": 0.005}
COLUMNS = ("part", "kept/fitted", "off mesh", "edges", "re-read", "radii", "kink", "")


def row_of(body: dict) -> str:
    """One line of the table."""
    error = max((abs(after - wanted) for _, _, wanted, after in body["cylinders"]), default=0.0)
    fitted = len(body["fitted_faces"])
    numbers = (body["distance"]["value"], body["edge_tolerance"], body["edge_tolerance_read"])
    told = " ".join(f"{one:9.2g}" for one in (*numbers, error, body["kink"]["value"]))
    faults = "refused: " + body_faults(body, WRITING)[0] if body_faults(body, WRITING) else ""
    return f"{body['name'][:34]:34} {body['kept']:4d}/{fitted:<4d} {told} {faults}"


def carried(path: Path, out: Path, *how: object) -> list[dict]:
    """Writes a file with all its parts bent, how: see there; prints what it holds then."""
    model = read_part(path, {}).model
    positions = [bent(part, *how) for part in model.parts]
    start = time.process_time()
    bodies = write_model(model, out, positions, WRITING)
    taken, grown = time.process_time() - start, out.stat().st_size / path.stat().st_size
    print(f"\n{path.name}: {taken:.0f} s of processors, {grown:.1f} times the size")
    print(" | ".join(COLUMNS))
    for body in bodies:
        print(row_of(body))
    return bodies


def check(body: dict) -> None:
    """What is promised of every body."""
    assert body_faults(body, WRITING) == [], body["name"]
    assert body["is_valid"] and (body["is_closed"] or not body["was_closed"]), body["name"]
    assert body["distance"]["value"] < 0.01, body["name"]
    assert body["edge_tolerance"] < 0.001, body["name"]
    assert body["edge_tolerance_read"] < 0.005, body["name"]
    assert body["kink"]["value"] < KINK, body["name"]
    radii = [abs(after - wanted) / wanted for _, _, wanted, after in body["cylinders"]]
    assert max(radii, default=0.0) <= RADIUS, body["name"]


def check_in_freecad(solid: dict, name: str) -> None:
    """FreeCAD takes a solid: its mesh, a cut, its holes as circles in drawings."""
    assert solid["is_valid"] and solid["is_watertight"], name
    assert solid["depth"] <= CROSSING.get(name, 0.0), name
    assert solid["crossings"] == 0 or name in CROSSING, name
    rest, expected, whole = solid["cut_volumes"]
    assert solid["is_cut"] and abs(rest - expected) < CUT * whole, (name, solid)
    assert 0.01 * whole < expected < 0.99 * whole, name
    for radius, circles in solid["holes"]:
        assert round(radius, 9) in circles, name


@pytest.mark.parametrize("number", SETS)
def test_public_assemblies_come_back(number: str, tmp_path: Path):
    path = SHARED / SETS[number]
    if not path.is_file():
        pytest.skip(f"{path.name} is not at hand; SHEETMORPH_SHARED names the folder")
    bodies = carried(path, tmp_path / "back.step")
    was_in_inches, is_in_inches = (
        "'INCH'" in one.read_text(errors="replace").upper()
        for one in (path, tmp_path / "back.step")
    )
    assert was_in_inches == is_in_inches == (number == "06")
    for body in bodies:
        check(body)
        assert body["is_closed"], body["name"]
    solids = read_in_freecad(tmp_path / "back.step", tmp_path / "FreeCAD", 2)
    assert len(solids) == len(bodies)
    for body, solid in zip(bodies, solids):
        print(f"{body['name'][:34]:34} {solid['crossings']} crossings, {solid['depth']:.2g} mm")
        check_in_freecad(solid, body["name"])
    assert sum(len(solid["holes"]) for solid in solids) == HOLES[number]


def test_plain_cuts_along_bent_edges_work(tmp_path: Path):
    path = SHARED / SETS["03"]
    if not path.is_file():
        pytest.skip(f"{path.name} is not at hand; SHEETMORPH_SHARED names the folder")
    whole = read_part(path, {}).model
    lid, out = tmp_path / "lid.brep", tmp_path / "lid.step"
    (number,) = (k for k, part in enumerate(whole.parts) if part.name == "Deckel.Body1")
    lid.write_text(whole.brep(number), "utf-8")
    sizes = {"edge": whole.edge, "deflection": whole.deflection}
    model = read_part(lid, sizes).model
    for body in write_model(model, out, [bent(model.parts[0])], WRITING):
        check(body)
    # Where long edges lay beside their faces, planes along them cut nothing off at all of these.
    for at in (0.108, 0.258, 0.35, 0.5, 0.517, 0.533):
        (solid,) = read_in_freecad(out, tmp_path / f"FreeCAD {at}", 0, Cut(at, 0.0))
        check_in_freecad(solid, "Deckel.Body1")


def check_at_rest(path: Path, out: Path) -> None:
    """Writes a file as it is: all its surfaces are kept."""
    before = read_part(path, {}).model
    still = [np.array(part.points) for part in before.parts]
    for body in write_model(before, out, still, WRITING):
        # Edges of some files are some micrometres off their faces; vertices lie on the edges.
        assert body["kept"] == body["faces"], body["name"]
        assert body["distance"]["value"] < WRITING.tolerance, body["name"]
    after = read_part(out, {}).model
    assert [part.name for part in after.parts] == [part.name for part in before.parts]
    for old, new in zip(before.parts, after.parts):
        kinds = [[one.kind for one in part.surfaces] for part in (old, new)]
        assert sorted(kinds[0]) == sorted(kinds[1]), old.name
        radii = [sorted(one.radius for one in part.surfaces) for part in (old, new)]
        assert radii[1] == pytest.approx(radii[0], rel=RADIUS, abs=RADIUS), old.name


@pytest.mark.parametrize("number", SETS)
def test_at_rest_every_surface_is_the_same(number: str, tmp_path: Path):
    path = SHARED / SETS[number]
    if not path.is_file():
        pytest.skip(f"{path.name} is not at hand; SHEETMORPH_SHARED names the folder")
    check_at_rest(path, tmp_path / "back.step")


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the own parts."""
    return make_own_parts(tmp_path_factory.mktemp("own"))


def test_own_parts_at_rest_are_the_same(own: Path, tmp_path: Path):
    for path in sorted(own.glob("*.step")):
        check_at_rest(path, tmp_path / path.name)


# What goes along with the features of a part, and which they are; how many washers that makes.
HELD = {
    "washers": ((1.0,), 4),
    "stud": ((1.0, "cylinder"), 1),
    "threaded": ((1.0, "cylinder"), 2),
}


@pytest.mark.parametrize(
    ("name", "drawings"),
    [("tube", 0), ("ball", 0), ("countersunk", 0), ("inches", 0), ("fillets", 0), ("washers", 2)]
    + [("rod", 0), ("stud", 0), ("threaded", 0)],
)
def test_own_parts_come_back(name: str, drawings: int, own: Path, tmp_path: Path):
    how, washers = HELD.get(name, ((), 0))
    path, out = own / f"{name}.step", tmp_path / "back.step"
    bodies = carried(path, out, *how)
    for body in bodies:
        check(body)
    assert sum(body["washers"] for body in bodies) == washers
    assert not washers or bodies[0]["kink"]["value"] < 0.1  # although they turned
    assert ("'INCH'" in out.read_text()) == (name == "inches")
    before, after = (read_part(one, {}).model.parts[0].surfaces for one in (path, out))
    if name in ("stud", "threaded"):  # the thread is what it was
        assert {before[face].kind for face in bodies[0]["fitted_faces"]} == {"plane"}
    tags = [{(s.name, s.colour) for s in one if s.name or s.colour} for one in (before, after)]
    assert tags[0] == tags[1] == ({("left end", "#ff8000")} if name == "washers" else set())
    # Along the axis of its thread FreeCAD cuts neither what came in nor what comes out.
    cut = Cut(0.45) if name == "threaded" else Cut()
    solids = read_in_freecad(out, tmp_path / "FreeCAD", drawings, cut)
    assert len(solids) == len(bodies)
    for solid in solids:
        check_in_freecad(solid, name)
    assert sum(len(solid["holes"]) for solid in solids) == drawings


def test_instances_driven_differently_become_products_of_their_own(own: Path, tmp_path: Path):
    out = tmp_path / "back.step"
    bodies = carried(own / "frame.step", out)
    for body in bodies:
        check(body)
    models = [read_part(one, {}).model for one in (own / "frame.step", out)]
    names = [[part.name for part in model.parts] for model in models]
    assert names[0] == names[1] and len(names[0]) == 2
    counts = [
        (len(re.findall(r"= PRODUCT\(", text)), text.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE("))
        for text in ((own / "frame.step").read_text(), out.read_text())
    ]
    assert counts == [(2, 2), (3, 2)]
    for solid in read_in_freecad(out, tmp_path / "FreeCAD", 0):
        check_in_freecad(solid, "frame")
    model = models[0]
    one_bent = [bent(model.parts[0]), np.array(model.parts[1].points)]
    for body in write_model(model, tmp_path / "one.step", one_bent, WRITING):
        check(body)
    assert (tmp_path / "one.step").read_text().count("= PRODUCT(") == 3
