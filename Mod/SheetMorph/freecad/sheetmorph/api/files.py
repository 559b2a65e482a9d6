# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files: parts read and written in double, and whole morphs as recipes."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np

from freecad.sheetmorph.bridge import conversion, kernel, solving, written
from freecad.sheetmorph.bridge.reading import read_file
from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.api.assemblies import create_assembly, set_energy, set_operator, set_primary
from freecad.sheetmorph.api.checks import require_assembly
from freecad.sheetmorph.api.decks import import_deck
from freecad.sheetmorph.api.loading import (
    add_contacts,
    add_driven,
    add_regions,
    add_relations,
    apply_options,
    apply_pose,
    apply_propagation,
    keep_extras,
    keep_files,
    with_names,
    with_sentences,
)
from freecad.sheetmorph.api.meshes import add_mesh
from freecad.sheetmorph.api.poses import add_named_poses, named_poses
from freecad.sheetmorph.api.propagations import set_mode
from freecad.sheetmorph.api.shapes import update_shapes
from freecad.sheetmorph.api.thin import set_sheet, set_thin
from freecad.sheetmorph.objects.assembly import together
from freecad.sheetmorph.objects.properties import number_of


def import_part(assembly, path: str | os.PathLike, label: str | None = None, *, mesh=None):
    """Read a mesh file into an assembly and return the part; its positions are kept in double.

    Formats: what `sheetmorph.read_part` reads (OBJ, OFF, PLY, STL, Nastran, VTK, ...). The file
    is kept in the document, so that `write_parts` can write it again with other coordinates.
    A CAD file is one part, meshed as `mesh` says; see `import_cad`. So is a deck; `import_deck`
    makes a part of every property.
    Raises ValueError or OSError if the file cannot be read.
    """
    require_assembly(assembly)
    path = Path(path)
    package = kernel.load()
    if mesh is None and is_deck(path):
        (part,) = import_deck(assembly, path, "")
        part.Label = label or path.stem
        return part
    read = read_file(path, mesh).mesh
    if len(read.triangles) == 0:
        raise ValueError(f"{path.name}: the file holds no triangles; choose another one.")
    part = add_mesh(assembly, read, label or path.stem)
    if package.files.is_cad(path):
        set_thin(part, "auto")
    else:
        part.FileName = path.name
        part.FileData = str(path.absolute())
    return part


def is_deck(path: str | os.PathLike) -> bool:
    """Whether a file is one that `import_deck` reads, by its name."""
    package = kernel.load()
    return package.decks.is_deck(package.files.unpacked_name(path))


def in_the_way(assembly, place: str | os.PathLike) -> list[Path]:
    """Return the files of others that `write_parts` and `certify` into a folder, or `export_recipe`
    to a path that ends in .json, would write over: they refuse that, unless `force` says otherwise.
    """
    require_assembly(assembly)
    return written.in_the_way(assembly, solving.read_morph(assembly), Path(place))


def write_parts(assembly, folder: str | os.PathLike, *, force: bool = False) -> list[Path]:
    """Write every part, deformed exactly, into `folder` and return the files and the report.

    An imported part is written in its own format with only the coordinates changed, any other as
    OBJ; coordinates are global, in double. Where a part has a deformed shape, that is brought up to
    date and written beside it as STEP. `report.json` says how good the result is. Either all
    files appear or none; those that SheetMorph did not write stay, unless `force`. Raises
    MorphError, ValueError, OSError.
    """
    require_assembly(assembly)
    morph = solving.read_morph(assembly)
    update_shapes(assembly)
    cache = solving.cache_of(assembly)
    positions = solving.deform(assembly)
    report = cache.result(morph).report() if morph.is_held() else None
    return written.write_parts(assembly, morph, positions, (Path(folder), report), force=force)


def export_recipe(assembly, path: str | os.PathLike, *, force: bool = False) -> Path:
    """Write an assembly as a recipe, its parts at rest beside it, and return the path.

    `python3 -m sheetmorph run` and `import_recipe` give the same morph again, to the last digit.
    Imported parts whose source was moved have the coordinates of their file and a `placement`.
    Files that SheetMorph did not write stay, unless `force`. Raises MorphError, ValueError,
    OSError; then nothing is written.
    """
    require_assembly(assembly)
    return write_recipe(assembly, Path(path), force=force)


def write_recipe(assembly, path: Path, *, is_placed: bool = True, force: bool = False) -> Path:
    """Do what `export_recipe` does; if not `is_placed`, parts are written where they stand, as
    `write_parts` writes them."""
    morph = solving.read_morph(assembly)
    if not morph.rests:
        raise ValueError(f"The morph '{assembly.Label}' has no part yet; add one first.")
    poses = named_poses(assembly, morph.names)
    return written.write_recipe(assembly, morph, path, poses, is_placed=is_placed, force=force)


@together()
def import_recipe(document, path: str | os.PathLike):
    """Build the assembly that a recipe file describes and return it.

    What the recipe leaves to a search (`"auto"`) is found now. Raises ValueError
    (sheetmorph.RecipeError) with every fault of the recipe, OSError if it cannot be read; then the
    document is as before.
    """
    path = Path(path)
    package = kernel.load()
    written = package.recipe.read_json(path)
    read = package.recipe.prepare(written, path.parent)
    recipe = with_sentences(with_names(package.recipe.with_ids(read)), written)
    assembly = create_assembly(document)
    found = {}
    for entry in recipe["parts"]:
        found.update(add_entry(assembly, entry, path.parent / entry["file"], meshes=read.meshes))
    if "primary" in recipe:
        set_primary(assembly, found[recipe["primary"]])
    set_energy(assembly, recipe.get("energy", "neumann"))
    set_operator(assembly, recipe.get("operator", "cotangent"))
    apply_propagation(assembly, recipe)
    regions = add_regions(assembly, recipe, found, read.meshes)
    add_driven(assembly, recipe, found, read.meshes)
    add_contacts(assembly, recipe, found, read.meshes)
    add_relations(assembly, recipe, regions)
    apply_options(assembly, recipe)
    apply_pose(regions, recipe)
    keep_extras(assembly, recipe, regions, found)
    keep_files(assembly, recipe, path.parent)
    add_named_poses(assembly, recipe, regions)
    assembly.Label = path.stem  # last: where labels clash, those of the parts stay
    return assembly


def add_entry(assembly, entry: dict, file: Path, *, meshes: dict) -> dict:
    """Add what one entry of a recipe's parts stands for; return parts by name in the recipe.

    The parts of a split file other than a deck, and those that are welded or remeshed, and placed
    decks, become parts of their own, that know nothing of the file: only so can each be exchanged,
    removed and written. A placed part has the placement of its source, and can be moved by that.
    """
    placed = kernel.load().recipe.placement.Placement.of_entry(entry.get("placement") or {})
    is_as_read = all(mesh.preparation is None for mesh in meshes.values())

    def own(name: str):
        """The mesh in the coordinates of its file."""
        mesh = meshes[name].with_indices()
        return replace(mesh, points=placed.taken_back(mesh.points))

    if is_deck(file) and is_as_read and not placed:
        added = add_deck_entry(assembly, entry, file)
    elif entry.get("split"):
        stem = kernel.load().files.unpacked_name(file).stem
        names = [name for name in meshes if name.startswith(f"{stem}/")]
        added = {name: add_mesh(assembly, own(name), name) for name in names}
    elif meshes[entry["name"]].preparation is not None or is_deck(file):
        added = {entry["name"]: add_mesh(assembly, own(entry["name"]), entry["name"])}
    else:
        meshing = entry.get("mesh")
        added = {entry["name"]: import_part(assembly, file, entry["name"], mesh=meshing)}
    for part in added.values():
        if placed:
            place_source(part, placed)
        set_mode(part, entry.get("mode", 0))
        thin = entry.get("thin", "auto" if kernel.load().files.is_cad(file) else False)
        set_thin(part, thin["thickness"] if isinstance(thin, dict) else thin)
        thickness = entry.get("thickness") or number_of(part, "SheetThickness")
        set_sheet(part, thickness, entry.get("poisson", 0.3))
    return added


def place_source(part, placed) -> None:
    """Let a part stand where a recipe's placement of its file, a Placement, puts it."""
    turn, shift = np.array(placed.rotation), np.array(placed.translation)
    part.Source.Placement = conversion.standing(turn, shift, read_kept(part).frame.origin)


def add_deck_entry(assembly, entry: dict, file: Path) -> dict:
    """Add the deck of an entry; return its parts by name in the recipe."""
    split = {True: "components"}.get(entry.get("split"), entry.get("split") or "")
    settings = {key: entry[key] for key in ("passengers", "joints") if key in entry}
    parts = import_deck(assembly, file, split, settings=settings)
    if not split:
        parts[0].Label = entry["name"]
        return {entry["name"]: parts[0]}
    stem = kernel.load().files.unpacked_name(file).stem
    return {f"{stem}/{part.DeckPart}": part for part in parts}
