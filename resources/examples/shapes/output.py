# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes an example's meshes (OBJ, ASCII PLY) and its recipe."""

from __future__ import annotations

import json
from pathlib import Path

from shapes.example import Example
from shapes.sheet import Sheet


def write_example(example: Example, folder: Path) -> list[Path]:
    """Meshes and recipe.json under `folder`; returns the files."""
    recipe = example.recipe()
    written = []
    for sheet, part in zip(example.sheets, recipe["parts"]):
        text = obj_text(sheet) if part["file"].endswith(".obj") else ply_text(sheet)
        written.append(write_text(folder / part["file"], text))
    written.append(write_text(folder / "recipe.json", recipe_text(recipe)))
    return written


def obj_text(sheet: Sheet) -> str:
    """Wavefront OBJ; coordinates in mm, as many digits as a double needs."""
    lines = [f"# {sheet.name}, mm", f"o {sheet.name.replace(' ', '_')}"]
    lines += ["v " + _coordinates(point) for point in sheet.points]
    lines += ["f " + " ".join(str(v + 1) for v in triangle) for triangle in sheet.triangles]
    return "\n".join(lines) + "\n"


def ply_text(sheet: Sheet) -> str:
    """ASCII PLY with double coordinates in mm."""
    lines = ["ply", "format ascii 1.0", f"comment {sheet.name}, mm"]
    lines += [f"element vertex {len(sheet.points)}"]
    lines += [f"property double {axis}" for axis in "xyz"]
    lines += [f"element face {len(sheet.triangles)}"]
    lines += ["property list uchar int vertex_indices", "end_header"]
    lines += [_coordinates(point) for point in sheet.points]
    lines += ["3 " + " ".join(str(v) for v in triangle) for triangle in sheet.triangles]
    return "\n".join(lines) + "\n"


def recipe_text(recipe: dict) -> str:
    """JSON with one line per part, region and contact, so that people can read it."""
    lines = []
    for key, value in recipe.items():
        if isinstance(value, list):
            rows = ",\n    ".join(json.dumps(row) for row in value)
            lines.append(f"  {json.dumps(key)}: [\n    {rows}\n  ]")
        else:
            lines.append(f"  {json.dumps(key)}: {json.dumps(value)}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _coordinates(point) -> str:
    return " ".join(repr(float(x) + 0.0) for x in point)


def write_text(path: Path, text: str) -> Path:
    """A file in a folder that is made if it is missing; returns its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="\n")
    return path
