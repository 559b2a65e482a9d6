# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes parts and recipes: every file in double, all of them or none."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

from freecad.sheetmorph.bridge import decks, kernel, recipes
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.bridge.rest import RestPart


def write_parts(assembly, morph, positions: dict[str, np.ndarray], place: tuple) -> list[Path]:
    """Write all parts at global `positions` (n, 3) by object name; return the paths.

    `place`: the folder, made if missing, and the report, None for none. Raises MorphError if a
    joint of a deck comes apart.
    """
    folder, report = place
    folder.mkdir(parents=True, exist_ok=True)
    with kernel.load().files.atomic.FileSet() as files:
        paths, told = write_files(files, assembly, morph, (folder, positions))
        for part in model.parts(assembly):
            if part.DeformedShape is not None:
                name = file_names(assembly, morph)[part.Name]
                paths.append(folder / f"{Path(name).stem}.step")
                part.DeformedShape.Shape.exportStep(str(files.temporary_for(paths[-1])))
        if report is not None:
            paths.append(folder / "report.json")
            text = json.dumps({**report, "decks": told}, indent=2)
            files.temporary_for(paths[-1]).write_text(text + "\n", encoding="utf-8")
        files.commit()
    return paths


def write_files(files, assembly, morph, place: tuple) -> tuple[list[Path], list[dict]]:
    """Write all parts and decks into a set of files; return the paths, and what decks tell.

    `place`: the folder and all positions. Raises MorphError if a joint comes apart.
    """
    folder, positions = place
    names, paths, told = file_names(assembly, morph), [], []
    for owner, parts in writers(assembly, morph).values():
        paths.append(folder / names[parts[0].Name])
        if owner is parts[0]:
            write_one(files, owner, morph.rests[owner.Name], (paths[-1], positions))
            continue
        with decks.opened(owner) as file:
            whole = decks.whole(file, parts, morph.rests, positions)
            told.append(file.told(whole))
            if told[-1]["failures"]:
                todo = f"move less, or let '{owner.Label}' tell of broken joints"
                raise MorphError("; ".join([*told[-1]["failures"][:5], todo]))
            file.write_into(files, paths[-1], whole)
    return paths, told


def writers(assembly, morph) -> dict[str, tuple]:
    """Return by object name what writes a file, a part or a deck, and the parts that are in it."""
    found: dict[str, tuple] = {}
    for part in model.parts(assembly):
        owner = decks.deck_of(part, morph.rests[part.Name]) or part
        found.setdefault(owner.Name, (owner, []))[1].append(part)
    return found


def write_recipe(assembly, morph, path: Path, poses: dict) -> Path:
    """Write the recipe with its poses to `path`, the parts at rest beside it; return the path."""
    names = file_names(assembly, morph)
    recipe = {key: value for key, value in morph.recipe.items() if value not in ([], "")}
    entries = {part.Name: entry for part, entry in zip(model.parts(assembly), recipe["parts"])}
    recipe["parts"] = [
        {**entries[owner.Name], "file": names[owner.Name]}
        if owner is parts[0]
        else decks.entry_of(owner, [entries[part.Name] for part in parts])
        for owner, parts in writers(assembly, morph).values()
    ]
    recipe = decks.renamed(recipe, decks.names_in_recipe(assembly, morph.rests, morph.names))
    recipe["pose"] = recipes.pose_of(assembly, morph.names)
    if poses:
        recipe["poses"] = poses
    rests = {name: rest.points for name, rest in morph.rests.items()}
    with kernel.load().files.atomic.FileSet() as files:
        write_files(files, assembly, morph, (path.parent, rests))
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
    for owner, parts in writers(assembly, morph).values():
        from_file = morph.rests[parts[0].Name].is_from_file and owner.FileName
        name = owner.FileName if from_file else f"{plain(morph.names[owner.Name])}.obj"
        if name.lower() in {other.lower() for other in names.values()}:
            stem, suffix = Path(name).stem, Path(name).suffix
            name = f"{stem} {owner.Name}{suffix}"
        names |= dict.fromkeys((part.Name for part in parts), name)
    return names


def plain(label: str) -> str:
    """Return a label without what a file name must not hold."""
    return re.sub(r'[\\/:*?"<>|\x00-\x1f]', "_", label).strip(". ") or "part"
