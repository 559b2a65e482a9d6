# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes parts and recipes: every file in double, all of them or none."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

from freecad.sheetmorph.bridge import kernel, recipes
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.bridge.rest import RestPart


def write_parts(assembly, morph, positions: dict[str, np.ndarray], place: tuple) -> list[Path]:
    """Write all parts at global `positions` (n, 3) by object name; return the paths.

    `place`: the folder, made if missing, and the report, None for none.
    """
    folder, report = place
    folder.mkdir(parents=True, exist_ok=True)
    names = file_names(assembly, morph)
    with kernel.load().files.atomic.FileSet() as files:
        for part in model.parts(assembly):
            write_one(files, part, morph.rests[part.Name], (folder / names[part.Name], positions))
        paths = [folder / name for name in names.values()]
        for part in model.parts(assembly):
            if part.DeformedShape is not None:
                paths.append(folder / f"{Path(names[part.Name]).stem}.step")
                part.DeformedShape.Shape.exportStep(str(files.temporary_for(paths[-1])))
        if report is not None:
            paths.append(folder / "report.json")
            text = json.dumps(report, indent=2)
            files.temporary_for(paths[-1]).write_text(text + "\n", encoding="utf-8")
        files.commit()
    return paths


def write_recipe(assembly, morph, path: Path, poses: dict) -> Path:
    """Write the recipe with its poses to `path`, the parts at rest beside it; return the path."""
    names = file_names(assembly, morph)
    recipe = {key: value for key, value in morph.recipe.items() if value not in ([], "")}
    found = model.parts(assembly)
    recipe["parts"] = [
        {**entry, "file": names[part.Name]} for entry, part in zip(recipe["parts"], found)
    ]
    recipe["pose"] = recipes.pose_of(assembly, morph.names)
    if poses:
        recipe["poses"] = poses
    rests = {name: rest.points for name, rest in morph.rests.items()}
    with kernel.load().files.atomic.FileSet() as files:
        for part in found:
            place = (path.parent / names[part.Name], rests)
            write_one(files, part, morph.rests[part.Name], place)
        text = json.dumps(recipe, indent=1)
        files.temporary_for(path).write_text(text + "\n", encoding="utf-8")
        files.commit()
    return path


def write_one(files, part, rest: RestPart, place: tuple) -> None:
    """Write one part into a set of files; `place`: its path and all positions."""
    path, positions = place
    if rest.is_from_file and part.FileData:
        kernel.load().read_part(part.FileData).write_into(files, path, positions[part.Name])
    else:
        text = obj_text(positions[part.Name], rest.triangles)
        files.temporary_for(path).write_text(text, encoding="ascii")


def obj_text(points: np.ndarray, triangles: np.ndarray) -> str:
    """Return a mesh as OBJ; `repr` gives every double the digits that bring it back exactly."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()]
    return "\n".join(lines) + "\n"


def file_names(assembly, morph) -> dict[str, str]:
    """Return a file name per part by object name: its own where it was read from a file."""
    names: dict[str, str] = {}
    for part in model.parts(assembly):
        from_file = morph.rests[part.Name].is_from_file and part.FileName
        name = part.FileName if from_file else f"{plain(morph.names[part.Name])}.obj"
        if name.lower() in {other.lower() for other in names.values()}:
            stem, suffix = Path(name).stem, Path(name).suffix
            name = f"{stem} {part.Name}{suffix}"
        names[part.Name] = name
    return names


def plain(label: str) -> str:
    """Return a label without what a file name must not hold."""
    return re.sub(r'[\\/:*?"<>|\x00-\x1f]', "_", label).strip(". ") or "part"
