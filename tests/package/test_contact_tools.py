# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a contact while it is marked, and wires; both need no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools import wires
from freecad.sheetmorph.tools.contact_sides import ContactSides, reach_that_touches
from freecad.sheetmorph.tools.part_mesh import PartMesh
from freecad.sheetmorph.tools.rims import Ray
from sheetmorph import _core


def square(height: float) -> PartMesh:
    """A square of 100 mm, two triangles, at a height."""
    points = np.array([[0, 0, height], [100, 0, height], [100, 100, height], [0, 100, height]])
    return PartMesh(_core, (points, np.array([[0, 1, 2], [0, 2, 3]], np.int32)), points)


@pytest.fixture
def sides():
    return ContactSides({"low": square(0.0), "high": square(10.0)})


def look(downwards: bool = True) -> Ray:
    """A look from above or from below."""
    step = -1.0 if downwards else 1.0
    return Ray(np.array([30.0, 60.0, -60.0 * step]), np.array([0.0, 0.0, step]))


def test_the_part_in_front_is_taken(sides):
    assert sides.part_at(look()) == "high"
    assert sides.part_at(look(downwards=False)) == "low"
    assert sides.part_at(Ray(np.array([300.0, 0, 50]), np.array([0.0, 0, -1]))) == ""


def test_two_clicks_fill_both_sides_and_the_same_part_counts_once(sides):
    assert sides.take("high") and not sides.take("high") and not sides.take("")
    assert not sides.are_chosen
    assert sides.take("low")
    assert sides.are_chosen and sides.parts == {"a": "high", "b": "low"}


def test_a_part_moved_to_the_other_side_leaves_its_own(sides):
    sides.take("high")
    sides.put("b", "high", [1, 2])
    assert sides.parts == {"a": "", "b": "high"}
    assert sides.picked("b") == [1, 2] and sides.picked("a") == []


def test_picking_both_sides_can_be_taken_back(sides):
    sides.take("high")
    sides.take("low")
    sides.pick([3, 1], [0])
    assert (sides.picked("a"), sides.picked("b")) == ([1, 3], [0])
    assert sides.pickers["a"].back() and sides.picked("a") == []


def test_the_distance_grows_until_both_parts_touch():
    def touching(reach):
        return ([0], [0]) if reach >= 7.0 else ([0], [])

    assert reach_that_touches(touching, 141.0) == 8.0


def test_without_anything_near_the_distance_stays_small():
    assert reach_that_touches(lambda reach: ([], []), 141.0) == 2.0
    assert reach_that_touches(lambda reach: ([], []), 0.5) == 0.01


def test_wires_leave_out_what_only_halves_a_quad():
    points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    assert wires.of_mesh(points, triangles).tolist() == [[0, 1], [0, 3], [1, 2], [2, 3]]


def test_wires_of_several_meshes_are_numbered_through():
    points, triangles = np.eye(3), np.array([[0, 1, 2]])
    assert len(wires.of_all([])) == 0
    found = wires.of_all([(points, triangles), (points, triangles)])
    assert found.max() == 5 and len(found) == 6
