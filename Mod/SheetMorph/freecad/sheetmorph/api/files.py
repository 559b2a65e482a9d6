# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files: parts read and written in double precision, and whole morphs as recipes."""

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
    """Read a mesh file into an assembly and return the part; its positions stay in double
    precision.

    The formats are those of `sheetmorph.read_part` (OBJ, OFF, PLY, STL, Nastran, VTK, ...). The
    document stores the file, so that `write_parts` can write it again with other coordinates. A CAD
    file becomes one part; see `import_cad`. A deck becomes one part; see `import_deck`.

    Parameters
    ----------
    assembly : object
        The assembly.
    path : str or path
        The file.
    label : str, optional
        Label of the part; by default the file name.
    mesh : dict, optional
        Mesh sizes for a CAD file.

    Raises
    ------
    ValueError, OSError
        If the file cannot be read.
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
    """Return whether `import_deck` reads a file, by its name."""
    package = kernel.load()
    return package.decks.is_deck(package.files.unpacked_name(path))


def in_the_way(assembly, place: str | os.PathLike) -> list[Path]:
    """Return the existing files that a write would need `force` to overwrite.

    The path is a folder for `write_parts` and `certify`, or a file with the suffix .json or
    .toml for `export_recipe`.
    """
    require_assembly(assembly)
    return written.in_the_way(assembly, solving.read_morph(assembly), Path(place))


def write_parts(assembly, folder: str | os.PathLike, *, force: bool = False) -> list[Path]:
    """Write every part, deformed exactly, into `folder` and return the files with the report.

    An imported part keeps its format, and only its coordinates change. Any other part is written as
    OBJ. Coordinates are global and in double precision. A deformed shape is updated and written as
    STEP as well. `report.json` gives the accuracy. Either all files appear or none.

    Parameters
    ----------
    assembly : object
        The assembly.
    folder : str or path
        Folder for the parts.
    force : bool
        Overwrite files that SheetMorph did not write.

    Raises
    ------
    MorphError, ValueError, OSError
    """
    require_assembly(assembly)
    morph = solving.read_morph(assembly)
    update_shapes(assembly)
    cache = solving.cache_of(assembly)
    positions = solving.deform(assembly)
    report = cache.result(morph).report() if morph.is_held() else None
    return written.write_parts(assembly, morph, positions, (Path(folder), report), force=force)


def export_recipe(assembly, path: str | os.PathLike, *, force: bool = False) -> Path:
    """Write an assembly as a recipe with its parts at rest, and return the path.

    `python3 -m sheetmorph run` and `import_recipe` give the same morph again, to the last digit. An
    imported part whose source was moved keeps the coordinates of its file and gets a `placement`.
    If an error is raised, nothing is written.

    Parameters
    ----------
    assembly : object
        The assembly.
    path : str or path
        The recipe file, in TOML if it ends in .toml and otherwise in JSON.
    force : bool
        Overwrite files that SheetMorph did not write.

    Raises
    ------
    MorphError, ValueError, OSError
    """
    require_assembly(assembly)
    return write_recipe(assembly, Path(path), force=force)


def write_recipe(assembly, path: Path, *, is_placed: bool = True, force: bool = False) -> Path:
    """Write a recipe as `export_recipe` does.

    If not `is_placed`, parts are written in global coordinates, as `write_parts` does.
    """
    morph = solving.read_morph(assembly)
    if not morph.rests:
        raise ValueError(f"The morph '{assembly.Label}' has no part yet; add one first.")
    poses = named_poses(assembly, morph.names)
    return written.write_recipe(assembly, morph, path, poses, is_placed=is_placed, force=force)


@together()
def import_recipe(document, path: str | os.PathLike):
    """Build the assembly of a recipe file in a document and return it.

    Entries that the recipe leaves to a search (`"auto"`) are found now. If an error is raised, the
    document is unchanged.

    Parameters
    ----------
    document : App.Document
        The document.
    path : str or path
        The recipe file.

    Raises
    ------
    ValueError
        With every fault of the recipe (sheetmorph.RecipeError).
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    package = kernel.load()
    written = package.recipe.read_json(path)
    read = package.checking.prepare(written, path.parent)
    recipe = with_sentences(with_names(package.checking.with_ids(read)), written)
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
    assembly.Label = path.stem  # last, so that the labels of parts stay unchanged if they clash
    return assembly


def add_entry(assembly, entry: dict, file: Path, *, meshes: dict) -> dict:
    """Add the parts of one entry of a recipe and return them by their recipe names.

    Parts of a split file other than a deck, prepared parts and placed decks become parts without a
    file. Only then can each of them be replaced, removed and written. The placement of a part
    becomes that of its source, which moves the part.
    """
    placed = kernel.load().recipe.placement.Placement.of_entry(entry.get("placement") or {})
    is_as_read = all(mesh.preparation is None for mesh in meshes.values())

    def own(name: str):
        """Return the mesh in the coordinates of its file."""
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
    """Place a part as a recipe's Placement of its file."""
    turn, shift = np.array(placed.rotation), np.array(placed.translation)
    part.Source.Placement = conversion.standing(turn, shift, read_kept(part).frame.origin)


def add_deck_entry(assembly, entry: dict, file: Path) -> dict:
    """Add the deck of an entry and return its parts by their recipe names."""
    split = {True: "components"}.get(entry.get("split"), entry.get("split") or "")
    settings = {key: entry[key] for key in ("passengers", "joints") if key in entry}
    parts = import_deck(assembly, file, split, settings=settings)
    if not split:
        parts[0].Label = entry["name"]
        return {entry["name"]: parts[0]}
    stem = kernel.load().files.unpacked_name(file).stem
    return {f"{stem}/{part.DeckPart}": part for part in parts}
