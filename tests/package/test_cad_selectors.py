# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces and solids of CAD files as regions: by place, kind, number and name, at every edge."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cad_samples import make_cad_samples
from sheetmorph import PartMesh, read_part
from sheetmorph.recipe.splitting import part_of
from sheetmorph.selecting import PartShape, selected
from sheetmorph.selecting.chosen import SelectorError


@pytest.fixture(scope="module")
def samples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of CAD files."""
    return make_cad_samples(tmp_path_factory.mktemp("cad"))


@pytest.fixture(params=["plate.igs", "plate.brep", "fixture.step"])
def shape(samples: Path, request: pytest.FixtureRequest) -> PartShape:
    """A plate of 60 x 40 x 2 mm with holes of radius 3 and 5 mm, in three formats."""
    return PartShape(read_part(samples / request.param, {"edge": 3.0}).mesh, name="plate")


def test_a_face_is_found_by_its_place_and_kind(shape: PartShape):
    top = selected(shape, {"cad_face_at": [5, 5, 2]})
    assert (shape.points[top.vertices, 2] == pytest.approx(2.0)) and top.matches[0][
        "kind"
    ] == "plane"
    assert shape.area_of(top) == pytest.approx(60 * 40 - np.pi * (9 + 25), rel=2e-3)
    wall = selected(shape, {"cad_face_at": [44, 20, 1], "kind": "cylinder"})
    away = np.hypot(*(shape.points[wall.vertices, :2] - [40, 20]).T)
    assert away == pytest.approx(5.0, abs=1e-4) and wall.matches[0]["distance"] < 1.01
    with pytest.raises(SelectorError, match="has no face that is a torus"):
        selected(shape, {"cad_face_at": [44, 20, 1], "kind": "torus"})


def test_an_edge_is_found_by_its_place(shape: PartShape):
    rim = selected(shape, {"cad_edge_at": [45.5, 20, 2]})
    points = shape.points[rim.vertices]
    assert np.hypot(*(points[:, :2] - [40, 20]).T) == pytest.approx(5.0, abs=1e-4)
    assert points[:, 2] == pytest.approx(2.0) and len(rim.vertices) > 8
    assert rim.matches[0]["distance"] == pytest.approx(0.5, abs=0.05)
    assert len(rim.matches[0]["faces"]) == 2
    side = shape.points[selected(shape, {"cad_edge_at": [0, 20, 2]}).vertices]
    assert side[:, 0] == pytest.approx(0.0) and side[:, 2] == pytest.approx(2.0)
    assert np.ptp(side[:, 1]) == pytest.approx(40.0)


def test_a_mesh_has_no_cad_edge():
    mesh = PartMesh(np.eye(3), np.array([[0, 1, 2]]), name="mesh")
    with pytest.raises(SelectorError, match="no CAD edges"):
        selected(PartShape(mesh), {"cad_edge_at": [0, 0, 0]})


def test_a_number_that_moved_on_is_told(shape: PartShape):
    told = selected(shape, {"cad_face_at": [5, 5, 2]}).matches[0]
    same = selected(shape, {"cad_face_at": [5, 5, 2], "number": told["number"]})
    assert same.remarks == []
    other = selected(shape, {"cad_face_at": [5, 5, 2], "number": told["number"] + 1, "name": "lid"})
    assert "no face is called" in other.remarks[0] and "has moved" in other.remarks[1]
    assert np.array_equal(other.inside, same.inside)


def test_solids_of_a_step_file_are_groups_and_go_through_split(samples: Path):
    file = read_part(samples / "fixture.step", {"edge": 3.0})
    whole = PartShape(file.mesh, name="fixture")
    pin = selected(whole, {"group": "solid pin"})
    assert np.array_equal(pin.vertices, np.unique(file.mesh.triangles[file.bodies["pin"]]))
    alone = PartShape(part_of(file.mesh, file.bodies["pin"], "pin")[0])
    assert len(selected(alone, {"cad_face_at": [15, 20, 5.1]}).vertices) > 4
    with pytest.raises(SelectorError, match="solid pin"):
        selected(whole, {"group": "solid pim"})


def test_a_face_has_the_same_area_at_every_edge_length(samples: Path):
    shapes = [
        PartShape(read_part(samples / "bend.step", {"edge": edge}).mesh, name="bend")
        for edge in (12.0, 6.0, 3.0)
    ]
    place = shapes[0].points[shapes[0].triangles[0]].mean(axis=0).tolist()
    areas = [shape.area_of(selected(shape, {"cad_face_at": place})) for shape in shapes]
    assert np.ptp(areas) <= 0.01 * min(areas)
