# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults and warnings know their objects by identity, whatever these are called."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sheetmorph import PartMesh, RecipeError, Session
from sheetmorph.base.errors import Caution, Fault, Subject
from strips import flat_strip

HOSTILE = (
    "contact 'weld'",
    "contact 'weld': vertex 9999; pick it again",
    "part 'b': handle 'tip'",
    "tip' and 'clamp",
    "tip (mirrored)",
    "tip (mirrored)'",
    "single control mesh",
    "b lump 1",
    "around vertex 3",
    "loose pieces",
    "x; y; z",
    "vertices 3, 7 and 5 more",
    " ",
    "'",
    '"',
    "\\",
    "{0}%s",
    "é 蓋 \U0001f527",
    "one\ntwo: three",
    "handles[0] (tip)",
)
KINDS = {
    "parts": "part",
    "fixed": "fixed region",
    "handles": "handle",
    "features": "feature",
    "points": "point",
    "contacts": "contact",
    "groups": "group",
}
ALONG, ACROSS = 20, 5
RIGHT = list(range(ALONG * (ACROSS + 1), (ALONG + 1) * (ACROSS + 1)))
MIDDLE = [8 * 6 + 2, 8 * 6 + 3, 9 * 6 + 2, 9 * 6 + 3]


def recipe() -> dict[str, Any]:
    """Two strips, one above the other, with an entry of every kind."""
    side = [12 * 6 + k for k in range(6)] + [13 * 6 + k for k in range(6)]
    return {
        "sheetmorph": 1,
        "parts": [{"name": "a"}, {"name": "b"}],
        "primary": "a",
        "fixed": [{"name": "clamp", "part": "a", "vertices": list(range(6))}],
        "handles": [
            {"name": "tip", "part": "a", "vertices": RIGHT},
            {"name": "side", "part": "a", "vertices": [16 * 6, 17 * 6]},
        ],
        "features": [
            {"name": "hole", "part": "a", "vertices": MIDDLE},
            {"name": "far", "part": "b", "vertices": [12, 13, 18]},
        ],
        "points": [
            {"name": "p", "part": "b", "triangle": 150, "barycentric": [0.2, 0.3, 0.5]},
        ],
        "contacts": [
            {
                "name": "weld",
                "type": "rigid",
                "a": {"part": "a", "vertices": side},
                "b": {"part": "b", "vertices": side},
            },
            {
                "name": "other",
                "a": {"part": "a", "vertices": side[:4]},
                "b": {"part": "b", "vertices": side[:4]},
            },
        ],
        "pose": {"tip": {"translation": [0, 0, 3]}, "side": {"translation": [0, 0, 1]}},
    }


Entry = tuple[str, int]
"""A section of the recipe and the number of an entry."""


def unheld(found: dict[str, Any]) -> list[Entry]:
    found["unheld"] = "refuse"
    found["contacts"], found["points"] = [], []
    found["fixed"].append({"name": "more", "part": "b", "vertices": [0]})
    found["handles"].append({"name": "extra", "part": "b", "vertices": [2]})
    found["pose"]["extra"] = {"translation": [0, 0, 1]}
    found["loose"] = True
    return [("parts", 1)]


def two_handles(found: dict[str, Any]) -> list[Entry]:
    found["handles"][1]["vertices"].append(RIGHT[0])
    return [("handles", 0), ("handles", 1)]


def fixed_and_handle(found: dict[str, Any]) -> list[Entry]:
    found["fixed"][0]["vertices"].append(16 * 6)
    return [("fixed", 0), ("handles", 1)]


def all_fixed(found: dict[str, Any]) -> list[Entry]:
    found["fixed"][0]["vertices"] += found["handles"][1]["vertices"]
    del found["pose"]["side"]
    return [("handles", 1)]


def torn(found: dict[str, Any]) -> list[Entry]:
    found["features"][0]["vertices"] += [RIGHT[0], 16 * 6]
    return [("features", 0), ("handles", 0), ("handles", 1)]


def torn_weld(found: dict[str, Any]) -> list[Entry]:
    found["fixed"].append({"name": "held", "part": "b", "vertices": [20 * 6]})
    found["features"][1]["vertices"] = [20 * 6, 19 * 6]
    found["features"][1]["rotation"] = {"axis": [0, 0, 1], "degrees": 5}
    return [("features", 1)]


def lost_vertex(found: dict[str, Any]) -> list[Entry]:
    found["contacts"][1]["b"]["vertices"].append(9999)
    return [("contacts", 1)]


def empty_side(found: dict[str, Any]) -> list[Entry]:
    found["contacts"][0]["a"]["vertices"] = []
    return [("contacts", 0)]


def lost_region(found: dict[str, Any]) -> list[Entry]:
    found["handles"][1]["vertices"].append(9999)
    return [("handles", 1)]


def no_axis(found: dict[str, Any]) -> list[Entry]:
    found["pose"]["side"]["rotation"] = {"axis": [0, 0, 0], "degrees": 3}
    return [("handles", 1)]


def no_size(found: dict[str, Any]) -> list[Entry]:
    found["features"][0]["size"] = 3.0
    return [("features", 0)]


def no_thin_solid(found: dict[str, Any]) -> list[Entry]:
    found["parts"][1]["thin"] = {"thickness": 1.0}
    return [("parts", 1)]


def bending_mode(found: dict[str, Any]) -> list[Entry]:
    found["contacts"] = found["contacts"][1:]
    found["parts"][1]["mode"] = 1
    return [("parts", 1)]


def group_over_parts(found: dict[str, Any]) -> list[Entry]:
    found["groups"] = [{"name": "both", "features": ["hole", "far"]}]
    return [("groups", 0)]


def missing_part(found: dict[str, Any]) -> list[Entry]:
    found["fixed"][0]["part"] = "nothing is called so"
    return [("fixed", 0)]


def wrong_barycentric(found: dict[str, Any]) -> list[Entry]:
    found["points"][0]["barycentric"] = [0.2, 0.3, 0.6]
    return [("points", 0)]


def lost_triangle(found: dict[str, Any]) -> list[Entry]:
    found["points"][0]["triangle"] = 9999
    return [("points", 0)]


def wrong_type(found: dict[str, Any]) -> list[Entry]:
    found["contacts"][0]["type"] = "glue"
    return [("contacts", 0)]


FAULTS: list[Callable[[dict[str, Any]], list[Entry]]] = [
    unheld, two_handles, fixed_and_handle, all_fixed, torn, torn_weld, lost_vertex, empty_side,
    lost_region, no_axis, no_size, no_thin_solid, bending_mode, group_over_parts, missing_part,
    wrong_barycentric, lost_triangle, wrong_type,
]  # fmt: skip


def renamed(found: dict[str, Any], names: dict[str, str]) -> dict[str, Any]:
    """The recipe with other names, wherever they stand."""

    def new(node: Any, key: str = "") -> Any:
        if isinstance(node, dict):
            inner = {k: new(v, k) for k, v in node.items()}
            return {names.get(k, k): v for k, v in inner.items()} if key == "pose" else inner
        if isinstance(node, list):
            return [new(child, key) for child in node]
        is_name = key in ("name", "part", "primary", "features") and isinstance(node, str)
        return names.get(node, node) if is_name else node

    return {section: new(entries, section) for section, entries in found.items()}


def meshes(found: dict[str, Any], is_loose: bool) -> dict[str, PartMesh]:
    points, triangles = flat_strip(ALONG, ACROSS)
    above = points + (0.0, 0.0, 2.0)
    made = [(points, triangles), (above, triangles)]
    if is_loose:
        keep = triangles[~((triangles // 6 == 5).any(axis=1))]
        made[1] = (above, keep)
    return {part["name"]: PartMesh(*mesh) for part, mesh in zip(found["parts"], made)}


OWN = (
    "a",
    "b",
    "clamp",
    "more",
    "held",
    "tip",
    "side",
    "hole",
    "far",
    "p",
    "weld",
    "other",
    "both",
    "extra",
)


@pytest.mark.parametrize("spoil", FAULTS, ids=lambda one: one.__name__)
@settings(max_examples=8)
@given(st.permutations(HOSTILE))
def test_a_fault_names_exactly_the_entries_at_fault(
    spoil: Callable[[dict[str, Any]], list[Entry]], names: list[str]
):
    spoiled = copy.deepcopy(recipe())
    entries = spoil(spoiled)
    is_loose = spoiled.pop("loose", False)
    found = renamed(spoiled, dict(zip(OWN, names)))
    wanted = {Subject(KINDS[section], found[section][k]["name"]) for section, k in entries}
    with pytest.raises(RecipeError) as refused:
        Session(found, meshes(found, is_loose)).deform()
    assert set(refused.value.faults[0].objects) == wanted, str(refused.value)


@given(st.permutations(HOSTILE))
@settings(max_examples=5)
def test_a_mirrored_handle_leaves_the_pose_of_one_that_has_its_name(names: list[str]):
    """'tip (mirrored)' is a handle of the user, and symmetry makes a mirror of 'tip'."""
    points, triangles = flat_strip(ALONG, ACROSS)
    tip, taken = names[0], f"{names[0]} (mirrored)"
    found = {
        "sheetmorph": 1,
        "parts": [{"name": "a"}],
        "fixed": [{"part": "a", "vertices": list(range(54, 66))}],
        "handles": [
            {"name": tip, "part": "a", "vertices": RIGHT},
            {"name": taken, "part": "a", "vertices": [16 * 6 + 2, 16 * 6 + 3]},
        ],
        "symmetry": {"point": [50.0, 0.0, 0.0], "normal": [1.0, 0.0, 0.0]},
    }
    mesh = symmetric(points, triangles)
    pose = {tip: {"translation": [0, 0, 3]}, taken: {"translation": [0, 0, 1]}}
    moved = Session(found, {"a": mesh}).deform(pose).positions["a"] - mesh.points
    assert moved[RIGHT][:, 2] == pytest.approx(3.0) and moved[:6, 2] == pytest.approx(3.0)
    assert moved[[98, 99]][:, 2] == pytest.approx(1.0)


def symmetric(points: Any, triangles: Any) -> PartMesh:
    """The strip with diagonals that mirror each other about its middle."""
    found = triangles.copy()
    half = len(found) // 2
    right = [k for k in range(half) if points[found[k]][:, 0].mean() > 50.0]
    for k in right:  # two triangles a cell, over the other diagonal
        a, b, c = found[k]
        d = found[half + k][2]
        found[k], found[half + k] = (a, b, d), (b, c, d)
    return PartMesh(points, found)


def test_warnings_are_sentences_that_know_their_objects():
    found = recipe()
    found["contacts"], found["points"] = [], []
    result = Session(found, meshes(found, False)).deform()
    (warning,) = [one for one in result.warnings() if one.code == "unreached"]
    assert isinstance(warning, str) and warning.objects == (Subject("part", "b"),)
    assert result.report()["warnings"] == result.warnings()


def test_a_warning_survives_a_copy_and_another_process():
    warning = Caution("it opens", Subject("contact", "weld"), code="open contact")
    for other in (copy.deepcopy(warning), pickle.loads(pickle.dumps(warning))):
        assert (other, other.objects, other.code) == (warning, warning.objects, warning.code)
    assert warning.after('pose "p": ').objects == warning.objects


def test_a_panel_reads_how_many_vertices_and_a_console_which():
    found = recipe()
    two_handles(found)
    found["handles"][1]["vertices"].append(RIGHT[1])
    with pytest.raises(RecipeError) as refused:
        Session(found, meshes(found, False))
    (fault,) = refused.value.faults
    assert "both move 2 vertices (120, 121); remove" in str(fault)
    assert "both move 2 vertices; remove" in fault.in_brief()
    assert fault.vertices == (120, 121) and fault.code == "overlap"
    assert Fault("w", "x", "y").in_brief() == "w: x; y"
