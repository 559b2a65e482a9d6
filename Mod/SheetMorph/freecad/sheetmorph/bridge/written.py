# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output of parts and recipes in double precision; all files are written, or none."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import conversion, decks, kernel, recipes, worded
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.bridge.rest import RestPart, read_kept

CERTIFICATE = ("certificate.json", "certificate.html")
Meshes = dict[str, Callable[[], Any]]
"""Object name of a part to a function that returns its sheetmorph.PartMesh with vertex indices."""


def in_the_way(assembly, morph, place: Path) -> list[Path]:
    """Return the files that an export would overwrite and that no earlier export wrote.

    `place` is a folder for parts and their certificate, or the file of a recipe.
    """
    ledger = kernel.load().files.ledger.Ledger()
    if place.suffix.lower() in (".json", ".toml"):
        by, folder = "recipe", place.parent
        names = [place.name, *recipes.beside_of(assembly)[1]]
    else:
        by, folder = "run", place
        names = ["report.json", *shape_names(assembly, morph).values()]
    names += part_files(assembly, morph)
    found = {folder / name: by for name in names}
    if by == "run":
        found |= {folder / name: "certify" for name in CERTIFICATE}
    return [path for path, by in found.items() if path.exists() and not ledger.has(path, by)]


def part_files(assembly, morph) -> list[str]:
    """Return the file names of all parts, including the includes of decks."""
    names, found = file_names(assembly, morph), []
    for owner, parts in writers(assembly, morph).values():
        found.append(names[parts[0].Name])
        if owner is not parts[0]:
            found += decks.includes_of(owner)
    return found


def shape_names(assembly, morph) -> dict[str, str]:
    """Return the names of the STEP files of deformed shapes by object name of the part."""
    names = file_names(assembly, morph)
    parts = [part for part in model.parts(assembly) if part.DeformedShape is not None]
    return {part.Name: f"{Path(names[part.Name]).stem}.step" for part in parts}


def write_parts(
    assembly, morph, positions: dict[str, np.ndarray], place: tuple, *, force: bool = False
) -> list[Path]:
    """Write all parts at global `positions` (n, 3) by object name; return the paths.

    `place` has the folder, which is created if necessary, and the report or None. With `force`,
    files that SheetMorph did not write are overwritten. Raises MorphError if a joint of a deck is
    broken.
    """
    folder, report = place
    folder.mkdir(parents=True, exist_ok=True)
    with kernel.load().files.atomic.FileSet(force=force) as files:
        paths, told, _ = write_files(files, assembly, morph, (folder, positions))
        shapes = shape_names(assembly, morph)
        for part in model.parts(assembly):
            if part.Name in shapes:
                paths.append(folder / shapes[part.Name])
                part.DeformedShape.Shape.exportStep(str(files.temporary_for(paths[-1])))
        if report is not None:
            paths.append(folder / "report.json")
            text = json.dumps({**report, "decks": told}, indent=2)
            files.temporary_for(paths[-1]).write_text(text + "\n", encoding="utf-8")
        files.commit()
    return paths


def write_files(files, assembly, morph, place: tuple) -> tuple[list[Path], list[dict], Meshes]:
    """Write all parts and decks; return the paths, the report entries of decks, and the written
    parts.

    `place` has the folder and all positions. Raises MorphError if a joint is broken.
    """
    folder, positions = place
    names, paths, told = file_names(assembly, morph), [], []
    meshes: Meshes = {}
    for owner, parts in writers(assembly, morph).values():
        paths.append(folder / names[parts[0].Name])
        if owner is parts[0]:
            rest = morph.rests[owner.Name]
            meshes[owner.Name] = write_one(files, owner, rest, (paths[-1], positions))
            continue
        with decks.opened(owner) as file:
            whole = decks.whole(file, parts, morph.rests, positions)
            told.append(file.told(whole))
            if told[-1]["failures"]:
                todo = f"move less, or set '{owner.Label}' to report broken joints"
                raise MorphError("; ".join([*told[-1]["failures"][:5], todo]))
            written = file.write_into(files, paths[-1], whole)
            if not all(morph.rests[part.Name].frame.is_unmoved() for part in parts):
                whole = file.stored_positions(written)  # rounded to the width of a field
            meshes |= {part.Name: as_written(part, morph.rests[part.Name], whole) for part in parts}
    return paths, told, meshes


def as_written(part, rest: RestPart, whole: np.ndarray) -> Callable[[], Any]:
    """Return a function for the sheetmorph.PartMesh of a deck's part at positions (n, 3) of all."""
    known = {"name": part.Label, "labels": read_kept(part).labels}
    return lambda: kernel.load().PartMesh(whole[rest.rows], rest.triangles, **known)


def writers(assembly, morph) -> dict[str, tuple]:
    """Return by object name the object that writes a file, a part or a deck, and its parts."""
    found: dict[str, tuple] = {}
    for part in model.parts(assembly):
        owner = decks.deck_of(part, morph.rests[part.Name]) or part
        found.setdefault(owner.Name, (owner, []))[1].append(part)
    return found


def write_recipe(
    assembly, morph, path: Path, poses: dict, *, is_placed: bool = True, force: bool = False
) -> Path:
    """Write the recipe with its poses and the parts at rest to `path`; return the path.

    Regions have selectors if these give their vertices in the written files too. With `is_placed`,
    a part whose source was moved keeps the coordinates of its file and gets a placement. With
    `force`, files that SheetMorph did not write are overwritten.
    """
    names = file_names(assembly, morph)
    owners = writers(assembly, morph).values()
    placed = placements(owners, morph) if is_placed else {}
    recipe = {key: value for key, value in morph.recipe.items() if value not in ([], "")}
    entries = {part.Name: entry for part, entry in zip(model.parts(assembly), recipe["parts"])}
    recipe["parts"] = [
        {**entries[owner.Name], "file": names[owner.Name], **placed.get(owner.Name, {})}
        if owner is parts[0]
        else decks.entry_of(owner, parts, [entries[part.Name] for part in parts])
        for owner, parts in owners
    ]
    recipe = decks.renamed(recipe, decks.names_in_recipe(assembly, morph.rests, morph.names))
    recipe["pose"] = recipes.entries_of(recipes.pose_of(assembly, morph.names))
    if poses:
        recipe["poses"] = poses
    said, texts = recipes.beside_of(assembly)
    recipe |= said
    rests = {name: rest.points for name, rest in morph.rests.items()}
    rests |= {p.Name: read_kept(p).points for p in model.parts(assembly) if p.Name in placed}
    with kernel.load().files.atomic.FileSet("recipe", force=force) as files:
        _, _, meshes = write_files(files, assembly, morph, (path.parent, rests))
        for name, text in texts.items():
            files.temporary_for(path.parent / name).write_bytes(text.encode("latin-1"))
        recipe = worded.worded(assembly, recipe, worded.Written(morph, meshes, placed))
        text = kernel.load().recipe.writing.recipe_text(recipe, path)
        files.temporary_for(path).write_text(text, encoding="utf-8")
        files.commit()
    return path


def placements(owners, morph) -> dict[str, dict]:
    """Return the key `placement` of moved parts with the double precision data of their files.

    `owners` comes from `writers`.
    """
    rests = {owner.Name: morph.rests[owner.Name] for owner, parts in owners if owner is parts[0]}
    return {
        name: {"placement": conversion.placement_entry(rest.frame)}
        for name, rest in rests.items()
        if rest.is_from_file and not rest.frame.is_unmoved()
    }


def write_one(files, part, rest: RestPart, place: tuple) -> Callable[[], Any]:
    """Write one part; `place` has its path and all positions.

    Return a function that reads the written part before the file set commits.
    """
    path, positions = place[0], place[1][part.Name]
    package = kernel.load()
    if rest.is_from_file and part.FileData:
        file = package.read_part(part.FileData)
        temporary = file.write_into(files, path, positions)
        labels = file.mesh.with_indices().labels
        return lambda: package.PartMesh(
            file.stored_positions(temporary), rest.triangles, name=part.Label, labels=labels
        )
    files.temporary_for(path).write_text(obj_text(positions, rest.triangles), encoding="ascii")
    return lambda: package.PartMesh(positions, rest.triangles, name=part.Label)


def obj_text(points: np.ndarray, triangles: np.ndarray) -> str:
    """Return a mesh as OBJ; `repr` writes every double with all digits."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (triangles + 1).tolist()]
    return "\n".join(lines) + "\n"


def file_names(assembly, morph) -> dict[str, str]:
    """Return a file name per part by object name; an imported part keeps that of its file."""
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
    """Return a label without characters that are invalid in file names."""
    return re.sub(r'[\\/:*?"<>|\x00-\x1f]', "_", label).strip(". ") or "part"
