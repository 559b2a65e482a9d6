# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of every kind of face, bent and twisted by a tenth of their size, written as STEP."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from cad_samples import made_by_freecad
from sheetmorph.files.cad_file import read_cad
from sheetmorph.files.cad_writing import CadWriting, write_model
from test_real_files import real_file

_SCRIPT = """
box = Part.makeBox(60, 40, 10)
drilled = Part.makeBox(60, 40, 6).cut(Part.makeCylinder(4, 10, Vector(20, 20, -1)))
# A thread of two turns on a pin: strips wind about its cylinder between the flanks.
corners = [(3.8, 2.3), (5, 2.8), (5, 3.2), (3.8, 3.7), (3.8, 2.3)]
profile = Part.makePolygon([Vector(x, 0, z) for x, z in corners])
helix = Part.makeHelix(2, 4, 5)
helix.translate(Vector(0, 0, 3))
thread = Part.Wire(helix.Edges).makePipeShell([profile], True, True)


def uneven(start, end):
    curve = Part.BezierCurve()
    curve.setPoles([Vector(start + share * (end - start), 0, 0) for share in (0, 0.002, 0.004, 1)])
    return curve.toBSpline().toShape()


# A block of which one side is two, along lines that hardly move while their parameters begin.
sides = [Vector(60, 0, 0), Vector(60, 8, 0), Vector(0, 8, 0), Vector(0, 0, 0)]
sides = [uneven(0, 30), uneven(30, 60), *Part.makePolygon(sides).Edges]
for name, shape in (
    ("uneven", Part.Face(Part.Wire(sides)).extrude(Vector(0, 0, 20))),
    ("tube", Part.makeCylinder(10, 80).cut(Part.makeCylinder(8, 80))),
    ("dish", Part.makeSphere(30, Vector(), Vector(0, 0, 1), 0, 90, 360).cut(Part.makeSphere(28))),
    ("cone", Part.makeCone(20, 0, 50)),
    ("ball", Part.makeSphere(20)),
    ("ring", Part.makeTorus(30, 6)),
    ("fillets", box.makeFillet(3, box.Edges)),
    ("countersunk", drilled.cut(Part.makeCone(4, 8, 4, Vector(20, 20, 2.5)))),
    ("thread", Part.makeCylinder(4, 10).fuse(thread)),
):
    shape.exportStep(os.path.join(folder, name + ".step"))
document = FreeCAD.newDocument("pins")
shown, pin = [], Part.makeCylinder(3, 30)
for label, x in (("pin a", 0), ("pin b", 20), ("pin c", 40)):
    shown.append(document.addObject("Part::Feature", "Part"))
    shown[-1].Label = label
    shown[-1].Shape = pin
    shown[-1].Placement.Base = Vector(x, 0, 0)
document.recompute()
Import.export(shown, os.path.join(folder, "pins.step"))
"""
SOLIDS = ("tube", "dish", "cone", "ball", "ring", "fillets", "countersunk", "thread")


@pytest.fixture(scope="module")
def solids(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of STEP files that FreeCAD made."""
    return made_by_freecad(_SCRIPT, tmp_path_factory.mktemp("solids"))


def bent(points: np.ndarray, share: float = 0.1) -> np.ndarray:
    """Points (n, 3) on an arc along their longest extent, and twisted about it."""
    extent = np.ptp(points, axis=0)
    along, across, up = np.argsort(-extent)
    middle = 0.5 * (points.max(axis=0) + points.min(axis=0))
    x, y, z = ((points - middle)[:, k] for k in (along, across, up))
    size = float(np.linalg.norm(extent))
    radius = extent[along] ** 2 / (4.0 * share * size)
    moved = np.empty_like(points)
    moved[:, along] = (radius - z) * np.sin(x / radius)
    lift = radius - (radius - z) * np.cos(x / radius)
    turn = share * 2.0 * x / extent[along]
    moved[:, across] = y * np.cos(turn) - lift * np.sin(turn)
    moved[:, up] = y * np.sin(turn) + lift * np.cos(turn)
    return moved + middle


@pytest.mark.parametrize("name", SOLIDS)
def test_a_bent_solid_is_valid_closed_and_near_its_mesh(solids: Path, tmp_path: Path, name: str):
    model = read_cad(solids / f"{name}.step").model
    positions = [bent(np.array(part.points)) for part in model.parts]
    (body,) = write_model(model, tmp_path / "out.step", positions, CadWriting("step"))
    assert (body["was_valid"], body["is_valid"], body["is_closed"]) == (True, True, True)
    assert body["distance"]["value"] < 0.01
    assert body["edge_tolerance_read"] < 0.005
    # Where three fillets meet, OpenCASCADE 7.8 answers less well than 7.6: a gap of 0.0044 mm.
    is_hard = name == "fillets"
    assert body["gap"]["value"] < (0.006 if is_hard else 0.0005)
    assert body["edge_tolerance"] < (0.006 if is_hard else 0.001)
    assert body["kink"]["value"] < (1.0 if is_hard else 0.2)


def test_an_edge_moves_by_its_length_however_uneven_its_parameter_is(solids: Path, tmp_path: Path):
    model = read_cad(solids / "uneven.step", {"edge": 12.0, "deflection": 0.3}).model
    positions = [bent(np.array(part.points)) for part in model.parts]
    (body,) = write_model(model, tmp_path / "out.step", positions, CadWriting("step"))
    assert body["gap"]["value"] < 0.0005  # 0.13 mm by the parameters
    assert body["kink"]["value"] < 0.2  # 2.7 degrees


def test_an_instance_that_differs_becomes_a_product_of_its_own(solids: Path, tmp_path: Path):
    model = read_cad(solids / "pins.step").model
    positions = [np.array(part.points) for part in model.parts]
    positions[1] = bent(positions[1])
    bodies = write_model(model, tmp_path / "pins.step", positions, CadWriting("step"))
    assert [body["kept"] == body["faces"] for body in bodies] == [True, False, True]
    assert all(body["is_valid"] and body["distance"]["value"] < 0.01 for body in bodies)
    again = read_cad(tmp_path / "pins.step").model
    assert [part.name for part in again.parts] == [part.name for part in model.parts]
    for before, after in zip(model.parts, again.parts):
        shift = np.abs(before.points.mean(axis=0) - after.points.mean(axis=0))
        assert shift.max() < 5.0
    solids_in = [
        (folder / "pins.step").read_text().count("MANIFOLD_SOLID_BREP(")
        for folder in (solids, tmp_path)
    ]
    assert solids_in == [1, 2]


def test_inches_stay_inches(tmp_path: Path):
    path = real_file("06-laser-cut-box/box_sides.step")
    model = read_cad(path).model
    positions = [np.array(part.points) for part in model.parts]
    positions[6] = bent(positions[6])
    positions[3] = np.roll(positions[3], 1, axis=1)  # x, y, z turned to y, z, x
    bodies = write_model(model, tmp_path / "box.step", positions, CadWriting("step"))
    assert all(body["is_valid"] and body["distance"]["value"] < 0.01 for body in bodies)
    turned = bodies[3]["cylinders"]  # of radii that no short decimal fraction of an inch is
    assert turned and all(abs(after / wanted - 1.0) < 1e-12 for *_, wanted, after in turned)
    assert "CONVERSION_BASED_UNIT('INCH'" in (tmp_path / "box.step").read_text()


def products_in(path: Path) -> set[str]:
    """The names of all products in a STEP file."""
    found = re.findall(r"= ?PRODUCT\s*\(\s*'[^']*'\s*,\s*'([^']*)'", path.read_text("latin-1"))
    return set(found)


def colours_in(path: Path) -> set[tuple[float, ...]]:
    """The colours that a STEP file has, red, green and blue."""
    found = re.findall(r"= ?COLOUR_RGB\s*\(\s*'[^']*'([^)]*)\)", path.read_text("latin-1"))
    return {tuple(round(float(x), 6) for x in one.strip(", \r\n").split(",")) for one in found}


def test_products_names_and_colours_come_back(tmp_path: Path):
    path = real_file("03-laser4diy-enclosure/Enclosure_v3_v9.step")
    model = read_cad(path).model
    positions = [np.array(part.points) for part in model.parts]
    bodies = write_model(model, tmp_path / "again.step", positions, CadWriting("step"))
    assert all(body["kept"] == body["faces"] for body in bodies)
    again = tmp_path / "again.step"
    # Bodies beside the components of a product become a component without a name of its own.
    assert products_in(again) - {"COMPOUND"} == products_in(path)
    # Two appearances of one colour are one.
    assert len(colours_in(again)) == 3
    assert colours_in(again) == colours_in(path)
