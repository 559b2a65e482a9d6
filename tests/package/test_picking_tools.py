# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a click means: the picking tools of the workbench, which need no FreeCAD."""

import math

import numpy as np
import pytest
from freecad.sheetmorph.tools.part_mesh import PartMesh, meets_box
from freecad.sheetmorph.tools.rims import Ray
from freecad.sheetmorph.tools.picking import (
    ADD,
    FACE,
    FACET,
    REMOVE,
    REPLACE,
    RIM,
    WHOLE,
    Options,
    RegionPicker,
    Taken,
    mode_of,
)
from sheetmorph import _core

DOWN = np.array([0.0, 0.0, -1.0])


def folded_grid(count: int = 9) -> tuple[np.ndarray, np.ndarray]:
    """Unit cells, one of them cut out of the flat half, the other half folded up at x = 4."""
    x, y = (g.ravel().astype(float) for g in np.meshgrid(range(count), range(count), indexing="ij"))
    points = np.stack([np.minimum(x, 4.0), y, np.maximum(x - 4.0, 0.0)], axis=1)
    first = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    first = first[first != 2 * count + 4]
    a, b, c, d = first, first + count, first + count + 1, first + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return points, triangles.astype(np.int32)


def down_at(x: float, y: float) -> Ray:
    """A look from above at a point of the flat half."""
    return Ray(np.array([x, y, 50.0]), DOWN)


@pytest.fixture
def mesh():
    points, triangles = folded_grid()
    return PartMesh(_core, (points, triangles), points)


@pytest.fixture
def picker(mesh):
    return RegionPicker(mesh)


def test_a_facet_is_its_three_vertices(picker):
    picker.choose(what=FACET)
    assert picker.click(down_at(0.7, 0.2))
    assert sorted(picker.picked) == [0, 9, 10]


def test_a_face_ends_at_the_fold(mesh, picker):
    picker.choose(what=FACE, crease=math.radians(30))
    assert picker.click(down_at(0.7, 0.2))
    heights = folded_grid()[0][sorted(picker.picked), 2]
    assert len(heights) == 45 and not heights.any()


def test_a_face_goes_on_across_the_fold_if_the_angle_allows(picker):
    picker.choose(what=FACE, crease=math.radians(95))
    assert picker.click(down_at(0.7, 0.2))
    assert len(picker.picked) == 81


def test_the_whole_part_is_its_connected_piece(picker):
    picker.choose(what=WHOLE)
    assert picker.click(down_at(0.7, 0.2))
    assert len(picker.picked) == 81


def test_a_click_beside_the_hole_takes_its_rim_in_one(picker):
    picker.choose(what=RIM)
    assert picker.click(down_at(1.8, 4.4))
    assert sorted(picker.picked) == [22, 23, 31, 32]


def test_a_click_through_the_hole_takes_its_rim(picker):
    picker.choose(what=RIM)
    assert picker.click(down_at(2.2, 4.5))
    assert sorted(picker.picked) == [22, 23, 31, 32]


def test_rings_around_a_rim_belong_to_it(picker):
    picker.choose(what=RIM, rings=1)
    assert picker.click(down_at(1.8, 4.4))
    assert {22, 23, 31, 32} < set(picker.picked) and len(picker.picked) > 10


def test_near_the_border_the_outline_is_taken_unless_only_holes_are_wanted(mesh):
    border, holes = RegionPicker(mesh), RegionPicker(mesh, options=Options(holes_only=True))
    for picker in (border, holes):
        picker.choose(what=RIM)
        assert picker.click(down_at(0.1, 4.0))
    assert len(border.picked) == 32
    assert sorted(holes.picked) == [22, 23, 31, 32]


def test_a_click_beside_the_part_changes_nothing(picker):
    picker.take([1, 2, 3])
    for what in (FACET, FACE, RIM, WHOLE):
        picker.choose(what=what)
        assert not picker.click(down_at(-30.0, 0.0))
    assert picker.picked.tolist() == [1, 2, 3]


def test_parts_are_picked_where_they_are_seen():
    points, triangles = folded_grid()
    turned = points @ np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]) + (100, 0, -7)
    picker = RegionPicker(PartMesh(_core, (points, triangles), turned), options=Options(what=FACET))
    middle = turned[[0, 9, 10]].mean(axis=0)
    assert picker.click(Ray(middle + (20.0, 0, 0), np.array([-1.0, 0.0, 0.0])))
    assert sorted(picker.picked) == [0, 9, 10]


def test_modes_replace_add_and_remove(picker):
    picker.take([1, 2, 3], REPLACE)
    picker.take([3, 4], ADD)
    assert picker.picked.tolist() == [1, 2, 3, 4]
    picker.take([1, 2], REMOVE)
    assert picker.picked.tolist() == [3, 4]
    picker.take([7], REPLACE)
    assert picker.picked.tolist() == [7]


def test_modifier_keys_choose_the_mode():
    assert mode_of(False, False) == REPLACE
    assert mode_of(True, False) == ADD
    assert mode_of(False, True) == mode_of(True, True) == REMOVE


def test_every_change_can_be_taken_back(picker):
    picker.take([1])
    picker.take([2], ADD)
    assert not picker.take([2], ADD)  # changes nothing, so it is no step
    picker.grow()
    picker.clear()
    for expected in (len(picker._history), 2, 1, 0):
        assert picker.can_go_back
        picker.back()
        if expected <= 2:
            assert len(picker.picked) == expected
    assert not picker.can_go_back and not picker.back()


def test_growing_and_shrinking_are_by_one_ring(picker):
    picker.take([0])
    picker.grow()
    assert sorted(picker.picked) == [0, 1, 9, 10]
    picker.shrink()
    assert sorted(picker.picked) == [0]


def test_separate_pieces_become_separate_groups(picker):
    picker.take([0, 1, 9, 40, 41])
    assert [group.tolist() for group in picker.groups()] == [[0, 1, 9], [40, 41]]


def test_all_holes_are_taken_without_the_outline(picker):
    assert picker.take_holes()
    assert [group.tolist() for group in picker.groups()] == [[22, 23, 31, 32]]


def test_without_a_closed_outline_every_rim_is_a_hole():
    points, triangles = folded_grid()
    fin = np.array([[8, 17, 81], [17, 26, 81]], np.int32)  # T-joints break the outline
    points = np.vstack([points, [1.0, 8.0, -5.0]])
    mesh = PartMesh(_core, (points, np.vstack([triangles, fin])), points)
    assert [sorted(rim) for rim in mesh.hole_rims(0)] == [[22, 23, 31, 32]]


def test_a_part_beside_the_ray_is_told_from_its_box_alone(mesh):
    low, high = mesh._seen.min(axis=0), mesh._seen.max(axis=0)
    rng = np.random.default_rng(5)
    origins = rng.uniform(low - 8.0, high + 8.0, (400, 3))
    towards = rng.uniform(low - 4.0, high + 4.0, (400, 3)) - origins
    towards[:100, :2] = 0.0  # as rays of an orthographic view along an axis are
    rays = [Ray(origin, direction) for origin, direction in zip(origins, towards)]
    hits = [mesh._tree.nearest_hit(ray.origin, ray.direction) is not None for ray in rays]
    meets = [meets_box(ray, low, high) for ray in rays]
    assert not any(hit and not meet for hit, meet in zip(hits, meets))
    assert 20 < sum(hits) <= sum(meets) < 380


def test_a_part_that_the_mouse_is_never_on_builds_no_tree():
    points, triangles = folded_grid()
    far = PartMesh(_core, (points, triangles), points + 1000.0)
    assert far.hit(down_at(1.0, 1.0)) is None and far.distance(down_at(1.0, 1.0)) == math.inf
    assert "_tree" not in vars(far)


def test_what_other_regions_have_is_left_out_of_every_pick():
    picker = RegionPicker(PartMesh(_core, folded_grid(), folded_grid()[0]))
    picker.leave(Taken({"Fixed": [1, 2], "Other": [9]}))
    picker.take([0, 1, 2, 3])
    assert picker.picked.tolist() == [0, 3] and picker.refused == ["Fixed"]
    picker.take([4], ADD)
    assert picker.picked.tolist() == [0, 3, 4] and picker.refused == []
    picker.take([1, 9], ADD)
    assert picker.picked.tolist() == [0, 3, 4] and picker.refused == ["Fixed", "Other"]
    assert picker.back() and picker.picked.tolist() == [0, 3] and picker.refused == []
