# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong values anywhere in a recipe are bad input, never a mistake of the program."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from plates import plate, recipe_of, write_plate
from sheetmorph.cli import main

PART = plate(holes=2, cells=3)
ROUNDS = 400
WRONG = [None, True, 0, -1, 3.5, 1e99, 1e308, 10**31, 10**400, float("nan"), float("inf"), "", "x",
         "auto", "\0", "a/b", [], [1], [0, 0, 0], [1, 2, 3], [None], ["x", 2, 3], [10**400] * 3, {},
         {"x": 1}, {"axis": [0, 0, 0], "degrees": 5}, {"box": {"min": 3}}, [[[]]]]  # fmt: skip


def recipe() -> dict[str, Any]:
    """A sound recipe with an entry of nearly every kind."""
    found = recipe_of(PART, "plate.obj")
    lower, upper = ({"part": part, "vertices": PART.rims[0]} for part in ("plate", "lid"))
    hinge = {"axis": [0, 1, 0], "degrees": 0}
    found |= {
        "parts": [
            {"name": "plate", "file": "plate.obj", "placement": {"translation": [0, 0, 1]}},
            {"name": "lid", "file": "lid.obj", "weld": 0.001, "mode": 3, "thickness": 1.0,
             "placement": {"translation": [0, 0, 3], "rotation": hinge}},
        ],
        "primary": "plate", "energy": "neumann", "operator": "cotangent", "refine": False,
        "unheld": "along", "propagation": {"type": "local", "levels": 2, "smoothness": 0.05},
        "contacts": [{"name": "weld", "type": "tied", "a": lower, "b": upper}],
        "points": [{"name": "peg", "part": "lid", "triangle": 5, "barycentric": [0.2, 0.3, 0.5],
                    "rotation": hinge}],
        "groups": [{"name": "both", "features": ["hole0", "hole1"]}],
        "poses": {"open": {"tip": {"translation": [0, 0, 2], "rotation": hinge, "pivot": [0] * 3}},
                  "shut": {"peg": {"target": [20, 0, 4]}}},
    }  # fmt: skip
    found["features"][0] |= {"motion": {"type": "plane", "normal": [0, 0, 1]}, "rotation": "free"}
    found["handles"][0]["pivot"] = [30, 0, 0]
    found["fixed"][0]["name"] = "root"
    found["fixed"][0] = {
        "name": "root", "part": "plate",
        "where": {"union": [{"half_space": {"point": [-9.9, 0, 0], "normal": [-1, 0, 0]}},
                            {"sphere": {"center": [-10, 0, 1], "radius": 1.0}}]},
    }  # fmt: skip
    del found["pose"]["tip"]["rotation"]
    return found


def places(node: Any, path: tuple = ()) -> Iterator[tuple]:
    """The paths of all values in a recipe."""
    children = node.items() if isinstance(node, dict) else ()
    for key, child in enumerate(node) if isinstance(node, list) else children:
        yield (*path, key)
        yield from places(child, (*path, key))


def mutated(rng: np.random.Generator, sound: dict[str, Any]) -> dict[str, Any]:
    """The recipe with one or two values exchanged, taken away or added."""
    found = copy.deepcopy(sound)
    for _ in range(int(rng.integers(1, 3))):
        every = list(places(found))
        # Lists of vertices are most of a recipe: one place in three is chosen by its section.
        deep = [path for path in every if "vertices" not in path[:-1]]
        *above, last = (
            deep[rng.integers(len(deep))] if rng.random() < 0.9 else every[rng.integers(len(every))]
        )
        node = found
        for step in above:
            node = node[step]
        act = rng.random()
        if act < 0.8:
            node[last] = copy.deepcopy(WRONG[rng.integers(len(WRONG))])
        elif act < 0.9:
            del node[last]
        elif isinstance(node, list):
            node.insert(int(rng.integers(len(node) + 1)), copy.deepcopy(node[last]))
        else:
            node[f"{last}x"] = node[last]
    return found


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("plate", "lid"):
        write_plate(PART, tmp_path / f"{name}.obj", "obj")
    return tmp_path


def test_the_recipe_is_sound(folder: Path, capsys: pytest.CaptureFixture[str]):
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe()))
    assert main(["check", str(path), "--quiet"]) == 0, capsys.readouterr()


def test_no_wrong_value_is_a_mistake_of_the_program(
    folder: Path, capsys: pytest.CaptureFixture[str]
):
    rng, sound = np.random.default_rng(36), recipe()
    path = folder / "recipe.json"
    refused = 0
    for _ in range(ROUNDS):
        wrong = mutated(rng, sound)
        path.write_text(json.dumps(wrong))
        status = main(["check", str(path), "--quiet"])
        told = capsys.readouterr().err
        assert "has a bug" not in told, f"{told}\n{json.dumps(wrong)}"
        assert status in (0, 2, 3) and (status != 2 or told.strip())
        refused += status == 2
    assert refused > ROUNDS // 2
