# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laws that hold for every selector: sets, finer meshes, turned parts, hostile recipes."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sheetmorph import PartMesh, RecipeError
from sheetmorph.checking import check_with_meshes
from sheetmorph.recipe.placement import Placement
from sheetmorph.selecting import PartShape, selected
from sheetmorph.selecting.chosen import SelectorError
from sheetmorph.selecting.resolving import _evaluated
from thin_plates import thin_plate

CALM = settings(
    max_examples=30,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
PLACE = st.tuples(st.floats(-12, 52), st.floats(-11, 11), st.floats(-2, 2)).map(list)
DIRECTION = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda d: math.hypot(*d) > 0.1).map(list)
RADIUS = st.floats(3, 30)
LEAF = st.one_of(
    st.builds(lambda a, b: {"box": [a, b]}, PLACE, PLACE),
    st.builds(lambda p, n: {"half_space": {"point": p, "normal": n}}, PLACE, DIRECTION),
    st.builds(
        lambda p, n, t: {"slab": {"point": p, "normal": n, "thickness": t}},
        PLACE,
        DIRECTION,
        RADIUS,
    ),
    st.builds(
        lambda p, d, r: {"cylinder": {"point": p, "direction": d, "radius": r}},
        PLACE,
        DIRECTION,
        RADIUS,
    ),
    st.builds(lambda c, r: {"sphere": {"center": c, "radius": r}}, PLACE, RADIUS),
    st.builds(lambda p: {"face_at": p}, PLACE),
    st.builds(lambda p, r: {"rim_at": p, "rings": r}, PLACE, st.integers(0, 2)),
    st.builds(lambda p: {"piece_at": p}, PLACE),
    st.builds(lambda p: {"found": "round hole", "near": p}, PLACE),
    st.just({"all": True}),
)
VOLUMES = ("box", "half_space", "slab", "cylinder", "sphere")


@lru_cache(maxsize=None)
def solid(level: int = 0) -> PartShape:
    """A thin plate with three holes, its triangles cut into four so many times."""
    part = thin_plate(3, cells=2)
    points, triangles = part.points, part.triangles
    for _ in range(level):
        points, triangles = refined(points, triangles)
    return PartShape(PartMesh(points, triangles, name="plate"))


def refined(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every triangle as four of the same surface."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, number = np.unique(sides, axis=0, return_inverse=True)
    middle = len(points) + number.reshape(-1, 3)
    a, b, c = triangles.T
    ab, bc, ca = middle.T
    four = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    fresh = np.concatenate([np.stack(corners, axis=1) for corners in four])
    return np.concatenate([points, points[edges].mean(axis=1)]), fresh


def inside(selector: Any, shape: PartShape | None = None) -> np.ndarray:
    return _evaluated(shape or solid(), selector).inside


@CALM
@given(LEAF, LEAF, LEAF)
def test_joining_is_that_of_sets(a, b, c):
    def same(one, other):
        return np.array_equal(inside(one), inside(other))

    assert same({"union": [a, b]}, [b, a]) and same({"union": [a, a]}, a)
    assert same({"intersection": [a, b]}, {"intersection": [b, a]})
    assert same({"union": [a, {"union": [b, c]}]}, [a, b, c])
    assert same(
        {"intersection": [a, {"union": [b, c]}]},
        [{"intersection": [a, b]}, {"intersection": [a, c]}],
    )
    assert same([{"minus": [a, b]}, {"intersection": [a, b]}], a)
    assert same({"minus": [a, b, c]}, {"minus": [a, [b, c]]})
    assert same(
        {"minus": [{"all": True}, [a, b]]},
        {"intersection": [{"minus": [{"all": True}, a]}, {"minus": [{"all": True}, b]}]},
    )


@CALM
@given(LEAF, st.one_of(st.integers(0, 3), st.floats(0, 12).map(lambda x: {"length": x})))
def test_growing_takes_more_and_shrinking_less(a, amount):
    start = inside(a)
    assert (inside({"grow": amount, "of": a}) >= start).all()
    assert (inside({"shrink": amount, "of": a}) <= start).all()
    if isinstance(amount, int):
        once = {"grow": 1, "of": {"grow": amount, "of": a}}
        assert np.array_equal(inside(once), inside({"grow": amount + 1, "of": a}))
        complement = {"minus": [{"all": True}, a]}
        kept = {"minus": [{"all": True}, {"grow": amount, "of": complement}]}
        assert np.array_equal(inside(kept), inside({"shrink": amount, "of": a}))


@CALM
@given(LEAF)
def test_a_finer_mesh_gives_the_same_region_by_area(a):
    if a.get("rings"):
        a = {**a, "rings": 0}  # rings are counted in triangles
    coarse, fine = solid(2), solid(3)
    one, other = (_evaluated(shape, a) for shape in (coarse, fine))
    total = coarse.areas.sum()
    slack = 0.03 * coarse.area_of(one) + (0.01 * total if next(iter(a)) in VOLUMES else 1e-9)
    assert coarse.area_of(one) == pytest.approx(fine.area_of(other), abs=slack)


@CALM
@given(LEAF, PLACE, DIRECTION, st.floats(-180, 180))
def test_a_placed_part_has_the_same_region(a, shift, axis, degrees):
    turn = Placement.of(shift, axis, degrees)
    mesh = solid().mesh
    moved = PartShape(turn.placed_mesh(mesh), turn)
    near = np.abs(moved.points - mesh.points).max()
    assert near < 1e-9
    one, other = inside(a), inside(a, moved)
    assert (one != other).sum() <= 2 or next(iter(a)) not in VOLUMES


JUNK = st.recursive(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(-(10**20), 10**20),
        st.floats(),
        st.text(max_size=5),
        LEAF,
    ),
    lambda inner: st.one_of(
        st.lists(inner, max_size=4),
        st.dictionaries(
            st.sampled_from(
                ["box", "half_space", "cylinder", "sphere", "face_at", "rim_at", "rings", "found"]
                + ["near", "diameter", "union", "minus", "grow", "of", "group", "all", "vertices"]
                + [
                    "cad_face_at",
                    "cad_edge_at",
                    "point",
                    "normal",
                    "radius",
                    "holes",
                    "count",
                    "slab",
                    "kind",
                ]
            ),
            inner,
            max_size=3,
        ),
    ),
    max_leaves=8,
)


@settings(CALM, max_examples=200)
@given(JUNK)
def test_whatever_stands_there_gives_a_region_or_sentences(junk):
    mesh = solid().mesh
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate"}],
        "fixed": [{"part": "plate", "where": junk}],
    }
    try:
        model = check_with_meshes(recipe, {"plate": mesh})
        assert model.regions[0].vertices
    except RecipeError as error:
        for fault in error.faults:
            assert fault.where and fault.what and fault.todo
            assert "\n" not in str(fault) and "Error" not in str(fault)


def test_a_selector_that_selects_nothing_is_never_a_region():
    with pytest.raises(SelectorError):
        selected(solid(), {"minus": [{"all": True}, {"all": True}]})
