# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small study: a plate with holes, held at one end, moved at the other."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

from plates import plate, recipe_of, save_recipe, write_plate


def write_recipe(folder: Path, kind: str = "obj") -> Path:
    """A recipe and its part in a folder; returns the recipe's path."""
    part = plate()
    write_plate(part, folder / f"plate.{kind}", kind)
    recipe = recipe_of(part, f"plate.{kind}", None if kind == "obj" else range(101, 9999))
    recipe["fixed"][0]["name"] = "wall"
    recipe["features"][0]["size"] = 8.0
    recipe["poses"] = {
        "up": {"tip": {"translation": [0, 0, 12]}},
        "turned": {"tip": {"rotation": {"axis": [0, 1, 0], "degrees": -10}}},
    }
    return save_recipe(recipe, folder)


def write_study(folder: Path, **keys: Any) -> Path:
    """A study of that recipe; keys replace its own, those that are None go."""
    if not (folder / "recipe.json").exists():
        write_recipe(folder)
    study = {
        "sheetmorph_study": 1,
        "recipe": "recipe.json",
        "parameters": {"lift": {"path": "pose.tip.translation[2]", "range": [0, 10]}},
        "sampling": {"method": "latin hypercube", "count": 4, "seed": 1},
        **keys,
    }
    path = folder / "study.json"
    path.write_text(json.dumps({key: value for key, value in study.items() if value is not None}))
    return path


def rows_of(out: Path) -> list[dict[str, str]]:
    """The rows of summary.csv."""
    with open(out / "summary.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def contents(out: Path) -> dict[str, bytes]:
    """All files of a study by name, but for what each call costs."""
    return {
        path.relative_to(out).as_posix(): path.read_bytes()
        for path in sorted(out.rglob("*"))
        if path.is_file() and path.name not in (".lock", "costs.json")
    }
