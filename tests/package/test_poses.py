# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses are recognised without the schema only where the schema would find nothing."""

import itertools

import pytest
from sheetmorph.recipe import structure
from sheetmorph.recipe.pose import is_plainly_sound

VALUES = (
    [0.0, 1, -2.5],
    [0.0, 1],
    [0, 0, float("nan")],
    [0, 0, float("inf")],
    [0, 0, "1"],
    [True, 0, 0],
    (0, 0, 1),
    [1e8, -1e8, 0],
    [1e30, 0, 0],
    {"axis": [0, 0, 1], "degrees": 5},
    {"axis": [0, 0, 1], "degrees": 1e7},
    {"axis": [0, 0, 1]},
    {"axis": [0, 0, 1], "degrees": 5, "more": 1},
    5.0,
    0,
    -1.0,
    "free",
    None,
)
KEYS = ("translation", "rotation", "pivot", "target", "size", "unknown")
USUAL = {"translation": [0.0, 0.0, 1.0], "rotation": {"axis": [0.0, 0.0, 1.0], "degrees": 3.0}}


def schema_finds_none(pose, monkeypatch) -> bool:
    with monkeypatch.context() as patch:
        patch.setattr(structure, "is_plainly_sound", lambda _: False)
        return structure.pose_faults(pose) == []


@pytest.mark.parametrize("key, value", itertools.product(KEYS, VALUES))
def test_what_is_recognised_is_what_the_schema_finds_nothing_in(key, value, monkeypatch):
    pose = {"tip": USUAL, "other": {key: value}}
    assert is_plainly_sound(pose) == schema_finds_none(pose, monkeypatch)


@pytest.mark.parametrize(
    "pose", [None, [], {"tip": None}, {"a\0b": USUAL}, {"\ud800": USUAL}, {1: {}}]
)
def test_other_forms_are_left_to_the_schema(pose):
    assert not is_plainly_sound(pose)


def test_the_poses_of_a_drag_need_no_schema(monkeypatch):
    monkeypatch.setattr(structure, "_errors", None)
    pose = {"tip": USUAL, "hole": {"rotation": USUAL["rotation"], "size": 12.0}, "rest": {}}
    assert structure.pose_faults(pose) == []
