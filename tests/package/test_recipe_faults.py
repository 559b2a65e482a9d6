# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every mistake in a recipe is found, and said with its place, what is wrong and what to do."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest

from part_samples import NASTRAN, OBJ
from sheetmorph import RecipeError, validate

RECIPE = {
    "sheetmorph": 1,
    "parts": [{"name": "cover", "file": "cover.obj"}, {"name": "deck", "file": "deck.nas"}],
    "primary": "cover",
    "energy": "paper",
    "operator": "cotangent",
    "fixed": [{"part": "cover", "vertices": [0]}, {"part": "deck", "vertices": [10, 20]}],
    "handles": [
        {"name": "tip", "part": "cover", "vertices": [1, 2], "pivot": [0, 0, 0]},
        {"name": "peg", "part": "cover", "triangle": 1, "barycentric": [0.2, 0.3, 0.5]},
    ],
    "features": [
        {"name": "hole", "part": "cover", "vertices": [3]},
        {
            "name": "slot",
            "part": "deck",
            "vertices": [30],
            "rotation": {"axis": [0, 0, 1], "degrees": 5},
            "motion": {"type": "free"},
        },
    ],
    "points": [
        {"part": "deck", "triangle": 2, "barycentric": [1, 0, 0], "target": [1, 2, 3],
         "rotation": {"axis": [0, 1, 0], "degrees": 0}},
    ],
    "pose": {
        "tip": {"translation": [0, 0, 20], "rotation": {"axis": [0, 1, 0], "degrees": 15}},
        "slot": {"rotation": {"axis": [0, 0, 1], "degrees": 30}},
        "point0": {"target": [0, 0, 1]},
    },
}  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "cover.obj").write_bytes(OBJ)
    (tmp_path / "deck.nas").write_bytes(NASTRAN)
    return tmp_path


def changed(path: str, value: object) -> dict:
    """The recipe with the value at a path such as "parts.0.name" exchanged; None removes it."""
    recipe = copy.deepcopy(RECIPE)
    *steps, last = path.split(".")
    node = recipe
    for step in steps:
        node = node[int(step)] if isinstance(node, list) else node[step]
    key = int(last) if isinstance(node, list) else last
    if value is None:
        del node[key]
    else:
        node[key] = value
    return recipe


def faults_of(recipe: object, folder: Path) -> list:
    """The faults of a recipe; each must be one line that says all three things."""
    with pytest.raises(RecipeError) as caught:
        validate(recipe, folder)
    for fault in caught.value.faults:
        assert fault.where and fault.what and fault.todo
        assert "\n" not in str(fault)
    assert str(caught.value).split("\n") == [str(fault) for fault in caught.value.faults]
    return caught.value.faults


def test_a_sound_recipe_passes(folder: Path):
    assert validate(RECIPE, folder) is None


NAN, INFINITY = float("nan"), float("inf")
ONE_FAULT = [
    ("sheetmorph", 2, "sheetmorph", "2 is not valid", "give the number 1"),
    ("sheetmorph", None, "recipe", 'the key "sheetmorph" is missing', "add it"),
    ("enery", "paper", "enery", 'unknown key "enery"', 'did you mean "energy"?'),
    (
        "energy",
        "thin plate",
        "energy",
        '"thin plate" is not an energy',
        'use "natural" or "neumann" or "paper"',
    ),
    ("primary", "lid", "primary", 'there is no part "lid"', 'use one of "cover", "deck"'),
    ("primary", None, "primary", "there are several parts", 'name the part you deform: "cover"'),
    ("parts.1.name", "cover", "parts[1] (cover)", "is already used", "give it another name"),
    ("parts.0.file", None, "parts[0] (cover)", 'the key "file" is missing', "add the path"),
    ("parts.0.file", "lid.obj", "parts[0] (cover).file", "does not exist", "check the path"),
    ("parts.0.file", "./deck.nas", "parts[1] (deck).file", "is already used", "rename one"),
    ("fixed.0.vertices", [], "fixed[0].vertices", "the list is empty", "at least one"),
    ("fixed.0.vertices", [0, 5, 9], "fixed[0].vertices", "vertices 5, 9 are not in", "0 .. 4"),
    ("fixed.1.vertices", [10, 99], "fixed[1].vertices", "vertices 99 are not in", "10 .. 50"),
    ("fixed.0.vertices", [-1], "fixed[0].vertices[0]", "-1 is not valid", "0 or more"),
    ("fixed.0.vertices", [True], "fixed[0].vertices[0]", "true is not valid", "0 or more"),
    ("fixed.0.part", "lid", "fixed[0].part", 'there is no part "lid"', "use one of"),
    ("handles.0.part", None, "handles[0] (tip)", 'the key "part" is missing', "add it"),
    ("handles.0.vertices", None, "handles[0] (tip)", "neither vertices nor", "give vertices, or"),
    ("handles.0.triangle", 1, "handles[0] (tip)", "vertices and a point", "keep either"),
    ("handles.1.barycentric", None, "handles[1] (peg)", "neither vertices nor a complete point",
     "triangle and barycentric"),
    ("handles.1.name", "tip", "handles[1] (tip)", "is already used by handles[0] (tip)", "another"),
    ("handles.0.pivot", [0, 0], "handles[0] (tip).pivot", "it has 2 entries", "three numbers"),
    ("handles.0.pivot", [0, 0, NAN], "handles[0] (tip).pivot[2]", "NaN", "finite number"),
    ("handles.0.pivot", [0, 0, INFINITY], "handles[0] (tip).pivot[2]", "too large", "finite"),
    ("handles.0.pivot", [0, 0, 10**400], "handles[0] (tip).pivot[2]", "too large", "finite"),
    ("features.0.rotation", "fre", "features[0] (hole).rotation", '"fre" is not', "interpolated"),
    ("features.1.rotation.axis", [0, 0, 0], "features[1] (slot).rotation.axis", "no length",
     "give the axis a direction"),
    ("features.1.rotation.degree", 5, "features[1] (slot).rotation", 'unknown key "degree"',
     'did you mean "degrees"?'),
    ("features.0.motion", {"type": "plane"}, "features[0] (hole).motion",
     'needs the key "normal"', "add"),
    ("features.0.motion", {"type": "line", "normal": [0, 0, 1]}, "features[0] (hole).motion",
     'needs the key "direction"', "add"),
    ("features.0.motion", {"type": "plane", "normal": [0, 0, 0]},
     "features[0] (hole).motion.normal", "no length", "a direction"),
    ("features.0.size", 0, "features[0] (hole).size", "0 is not valid", "diameter"),
    ("groups", [{"features": ["hole", "rim"]}], "groups[0].features", 'no feature "rim"', "names"),
    ("groups", [{"features": ["hole", "slot"]}], "groups[0].features", "features of one part",
     'a contact of type "rigid"'),
    ("groups", [{"features": ["hole"]}], "groups[0].features", "it has 1 entry", "at least two"),
    ("coaxial", [{"features": ["hole", "hole"]}], "coaxial[0].features", "named twice", "once"),
    ("symmetry", {"point": [0, 0, 0], "normal": [0, 0, 0]}, "symmetry.normal", "no length", "give"),
    ("pose.hole", {"size": 5}, "pose.hole.size", "has no size in the recipe", "(hole)"),
    ("pose.tip.size", 5, "pose.tip.size", '"size" has no meaning', "only form features"),
    ("handles.0.rotation", "free", "pose.tip.rotation", 'rotation of the handle "tip" is free',
     "from handles[0] (tip)"),
    ("points.0.triangle", 99, "points[0].triangle", "triangle 99 is not in part deck", "0 .. 3"),
    ("points.0.barycentric", [1, 1, 0], "points[0].barycentric", "add up to 2", "divide them"),
    ("points.0.barycentric", [2, -1, 0], "points[0].barycentric", "negative", "from 0 to 1"),
    ("pose.lid", {}, "pose.lid", 'no handle, feature or point "lid"', '"hole", "peg", "point0"'),
    ("pose.tip.target", [0, 0, 0], "pose.tip.target", '"target" has no meaning', "leave it out"),
    ("pose.slot.pivot", [0, 0, 0], "pose.slot.pivot", '"pivot" has no meaning', "its own centre"),
    ("pose.point0.translation", [0, 0, 1], "pose.point0.translation", "no meaning", "its target"),
    ("pose.hole", {"rotation": {"axis": [0, 0, 1], "degrees": 5}}, "pose.hole.rotation",
     "has no rotation of its own", "to features[0] (hole)"),
    ("pose.tip.rotation.axis", [0, 0, 0], "pose.tip.rotation.axis", "no length", "a direction"),
    ("pose.tip.translation", "up", "pose.tip.translation", '"up" is not valid', "three numbers"),
    ("pose.tip.shift", [0, 0, 1], "pose.tip", 'unknown key "shift"', "known keys are translation"),
]  # fmt: skip


@pytest.mark.parametrize(
    "mistake", ONE_FAULT, ids=[f"{path}={value}"[:50] for path, value, *_ in ONE_FAULT]
)
def test_a_single_mistake_gives_one_fault(mistake: tuple, folder: Path):
    path, value, where, what, todo = mistake
    faults = faults_of(changed(path, value), folder)
    # A wrong part also has other vertices.
    assert len(faults) == 1 or path.startswith("parts.")
    assert faults[0].where.split(",")[0] == where
    assert what in faults[0].what
    assert todo in faults[0].todo


NOT_AVAILABLE = [
    ("features.0.groups", [], "groups"),
    ("parts.0.refine", True, "refine"),
    ("modes", [], "modes"),
    ("parts.0.modes", [], "modes"),
]


@pytest.mark.parametrize(("path", "value", "key"), NOT_AVAILABLE)
def test_what_later_versions_bring_is_refused_by_name(path, value, key, folder: Path):
    faults = faults_of(changed(path, value), folder)
    assert f"not available in this version: {key}" in [fault.what for fault in faults]
    assert not [fault for fault in faults if "unknown key" in fault.what]


def test_all_faults_are_collected(folder: Path):
    recipe = changed("modes", [])
    recipe["fixed"] = [{"part": "cover", "vertices": [77]}, {"part": "lid", "vertices": [1]}]
    recipe["handles"][0]["pivot"] = [1]
    recipe["colour"] = "red"
    recipe["pose"]["nobody"] = {}
    places = [fault.where for fault in faults_of(recipe, folder)]
    assert places == [
        "modes",
        "colour",
        "handles[0] (tip).pivot",
        "fixed[1].part",
        "pose.nobody",
        "fixed[0].vertices",
    ]


def test_an_entry_with_a_mistake_of_its_own_does_not_blame_others(folder: Path):
    places = [fault.where for fault in faults_of(changed("handles.0.vertices", [1.5]), folder)]
    assert places == ["handles[0] (tip).vertices[0]"]


@pytest.mark.parametrize("recipe", [None, [], "recipe", 1, {}, {"sheetmorph": 1, "parts": 3}])
def test_what_is_no_recipe_at_all_is_refused(recipe: object, folder: Path):
    assert faults_of(recipe, folder)


def test_nothing_fixed_and_nothing_moved_is_refused(folder: Path):
    recipe = {"sheetmorph": 1, "parts": [{"name": "cover", "file": "cover.obj"}]}
    assert [fault.what for fault in faults_of(recipe, folder)] == [
        "there is no fixed region and no handle"
    ]


def test_a_corrupt_part_file_is_a_fault_with_its_line(folder: Path):
    (folder / "cover.obj").write_bytes(OBJ.replace(b"v 0 0 0", b"v 0 0 x"))
    fault = faults_of(RECIPE, folder)[0]
    assert fault.where == f"parts[0] (cover).file, {folder / 'cover.obj'}, line 4"
    assert fault.what == '"x" is not a number'


def test_random_damage_to_a_recipe_never_gives_another_error(folder: Path):
    """Every value of the recipe in turn becomes something of another type."""
    paths = _paths(RECIPE)
    assert len(paths) > 60
    for path in paths:
        for value in ("text", -7, 1.5, [], {}, [[]], False):
            try:
                validate(changed(path, value), folder)
            except RecipeError as error:
                assert all(fault.todo for fault in error.faults)


def _paths(node: object, prefix: str = "") -> list[str]:
    items = node.items() if isinstance(node, dict) else ()
    items = enumerate(node) if isinstance(node, list) else items
    return [
        found
        for key, child in items
        for found in [f"{prefix}{key}", *_paths(child, f"{prefix}{key}.")]
    ]


def test_the_published_schema_accepts_the_recipe_and_is_a_schema():
    import jsonschema

    from sheetmorph.recipe.structure import schema

    jsonschema.Draft202012Validator.check_schema(schema())
    jsonschema.Draft202012Validator(schema()).validate(json.loads(json.dumps(RECIPE)))
