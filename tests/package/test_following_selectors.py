# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors on a changed part take the hole or face they took before, or raise a question."""

import numpy as np
import pytest

from sheet_meshes import circle, flat, lifted, polygon, rounded, thickened
from sheetmorph import PartMesh
from sheetmorph.selecting import Following, PartShape, Question, selected

SIZE = (190.0, 110.0)
PITCH = 30.0
STEP = 11.0
ROW = [(35.0 + PITCH * k, 55.0, 4.5) for k in range(4)]


def plate(holes, depth=0.0, size=SIZE, seed=None) -> PartShape:
    """A plate with holes (x, y, radius), or (x, y, radius, length) for slots; its vertices in a
    random order with a seed."""
    outline = polygon([(0, 0), (size[0], 0), size, (0, size[1])], STEP)
    loops = [
        circle(hole[:2], hole[2], 14)
        if len(hole) == 3
        else rounded(hole[:2], (hole[3], 2 * hole[2]), hole[2], 3.0)
        for hole in holes
    ]
    points, triangles = flat(outline, loops, STEP)
    if depth:
        points, triangles = thickened(points, triangles, [len(x) for x in (outline, *loops)], depth)
    else:
        points = lifted(points)
    if seed is not None:
        order = np.random.default_rng(seed).permutation(len(points))
        number = np.argsort(order)
        points, triangles = points[order], number[triangles]
    return PartShape(PartMesh(points, triangles.astype(np.int32)), name="plate")


def centre_of(shape: PartShape, vertices) -> np.ndarray:
    """The middle of the box around some vertices, in the plane."""
    points = shape.points[vertices][:, :2]
    return 0.5 * (points.min(axis=0) + points.max(axis=0))


def moved_row(shift: float) -> list:
    return [(x + shift, y, r) for x, y, r in ROW]


@pytest.mark.parametrize("depth", [0.0, 2.0])
@pytest.mark.parametrize(
    "where",
    [
        {"rim_at": [65, 55, 0], "rings": 1},
        {"found": "round hole", "near": [65, 55, 0]},
        [{"rim_at": [65, 59, 0]}, {"rim_at": [95, 55, 0]}],
        {"grow": 1, "of": {"rim_at": [65, 55, 0]}},
    ],
)
def test_the_second_hole_stays_the_second_one_where_the_pattern_moved_by_16(depth, where):
    old, new = plate(ROW, depth), plate(moved_row(16.0), depth, seed=1)
    before = centre_of(old, selected(old, where).vertices)
    found = Following(old, new).followed(where, where)
    np.testing.assert_allclose(centre_of(new, found.chosen.vertices), before + [16, 0], atol=3.0)
    assert "moved by 16 mm" in found.told[0]


def test_what_did_not_change_keeps_its_words():
    old, new = plate(ROW), plate(ROW, seed=4)
    for where in ({"rim_at": [65, 50, 0]}, {"face_at": [10, 10, 0]}, {"border_at": [0, 9, 0]}):
        found = Following(old, new).followed(where, where)
        assert (found.where, found.told) == (where, [])


def test_a_hole_half_the_way_to_another_one_is_a_question_that_an_answer_settles():
    holes = list(ROW)
    holes[1] = (80.0, 55.0, 4.5)
    following = Following(plate(ROW), plate(holes))
    where = {"rim_at": [65, 55, 0], "rings": 1}
    with pytest.raises(Question, match=r"round hole of 9 mm at \(65, 55, 0\) may be") as asked:
        following.followed(where, where)
    assert asked.value.candidates[0].place == [80, 55, 0]
    found = following.followed(where, where, np.array([80.0, 55.0, 0.0]))
    assert found.where == {"rim_at": [80, 55, 0], "rings": 1}


def test_a_removed_hole_is_a_question_and_what_is_left_is_not():
    following = Following(plate(ROW), plate(ROW[:1] + ROW[2:]))
    where = {"found": "round hole", "near": [65, 55, 0]}
    with pytest.raises(Question, match="at .65, 55, 0. may be"):
        following.followed(where, where)
    kept = {"rim_at": [95, 55, 0]}
    assert following.followed(kept, kept).where == kept


def test_a_piece_of_space_that_holds_another_hole_now_is_a_question():
    box = {"box": [[55, 45, -1], [75, 65, 1]]}
    with pytest.raises(Question):
        Following(plate(ROW), plate(moved_row(30.0))).followed(box, box)
    with pytest.raises(Question):
        Following(plate(ROW), plate(moved_row(9.0))).followed(box, box)
    assert Following(plate(ROW), plate(moved_row(1.0))).followed(box, box).where == box


def test_the_end_faces_of_a_longer_solid_follow():
    old, new = plate(ROW, 2.0), plate(ROW, 2.0, (230.0, 110.0))
    for where, x in (({"face_at": [190, 40, 1]}, 230.0), ({"face_at": [0, 40, 1]}, 0.0)):
        found = Following(old, new).followed(where, where)
        assert np.abs(new.points[found.chosen.vertices, 0] - x).max() < 1e-9


def grid(rng, with_slot: bool) -> list:
    """Holes of two sizes in a grid, the last one perhaps a slot."""
    columns, rows = rng.integers(2, 5), rng.integers(1, 3)
    holes = [
        (35.0 + PITCH * i, 30.0 + PITCH * j, float(rng.choice([4.5, 4.5, 3.0])))
        for i in range(columns)
        for j in range(rows)
    ]
    return [*holes[:-1], (*holes[-1][:2], 4.0, 15.0)] if with_slot else holes


def changed(rng, holes: list, what: int) -> tuple[list, list]:
    """The holes after a small change, and of every hole before it its number, None if removed."""
    one, truth = int(rng.integers(len(holes))), list(range(len(holes)))
    shift = rng.uniform(-17.0, 17.0, 2)

    def moved(hole) -> tuple:
        return (hole[0] + shift[0], hole[1] + shift[1], *hole[2:])

    if what == 0:
        return [moved(hole) for hole in holes], truth
    after = list(holes)
    if what == 1:
        after[one] = moved(holes[one])
    elif what == 2:
        after.pop(one)
        truth = [None if k == one else k - (k > one) for k in truth]
    else:
        after[one] = (*holes[one][:2], 1.3 * holes[one][2], *holes[one][3:])
    return after, truth


@pytest.mark.parametrize("seed", range(8))
def test_random_plates_never_bind_another_hole_in_silence(seed):
    rng = np.random.default_rng(seed)
    holes = grid(rng, seed % 3 == 0)
    depth = float(rng.choice([0.0, 2.0]))
    after, truth = changed(rng, holes, seed % 4)
    new = plate(after, depth, seed=seed)
    following = Following(plate(holes, depth), new)
    bound = 0
    for k, true in enumerate(truth):
        x, y, radius = holes[k][:3]
        where = {"rim_at": [x + radius, y, 0.0]} if k % 2 else {"rim_at": [x, y, 0.0], "rings": 1}
        try:
            found = following.followed(where, where)
        except Question:
            continue
        bound += 1
        assert true is not None
        middle = centre_of(new, found.chosen.vertices)
        assert np.linalg.norm(middle - after[true][:2]) < 6.0
    assert bound >= len(holes) - 2 or seed % 4 == 0
