# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part in place of which its file or shape, changed since, is read again; what was picked stays
picked."""

from __future__ import annotations

import json
import os
from pathlib import Path

import FreeCAD

from freecad.sheetmorph import reporting
from freecad.sheetmorph.api import following, preparing
from freecad.sheetmorph.api.cad import check_shape, read_shape
from freecad.sheetmorph.bridge import conversion, kernel
from freecad.sheetmorph.bridge.reading import read_file
from freecad.sheetmorph.bridge.rest import read_kept, read_original, write_rest_data
from freecad.sheetmorph.bridge.shapes import keep_shape, kept_shape
from freecad.sheetmorph.objects import assembly_of, model, shape_source
from freecad.sheetmorph.objects.assembly import follow_group


def replace_file(
    part,
    path: str | os.PathLike,
    mesh: dict | None = None,
    bindings: dict | None = None,
) -> dict:
    """Let a part rest on a file, another state of the one it came from, and return what is told.

    `mesh`: how finely a CAD file is meshed, as for `import_cad`; of its solids the one called as
    the part, or the only one. A part that was prepared is prepared again in the same way. Regions
    and sides of contacts that say what they are, are resolved on the new mesh, vertices alone go
    to the nearest places. Returns `told`, a sentence for each that became another one by more than
    3 % of its area or had only its vertices, and `different`, their names. Raises ValueError,
    OSError; then nothing has changed.
    """
    preparing.checked(part)
    if getattr(part, "Deck", None) is not None:
        raise ValueError(f"'{part.Label}' is a part of a deck; import the changed deck again.")
    found = replaced(part, Read(part, Path(path), mesh), bindings)
    part.ShapeSource, part.ShapeRead, part.SourceChanged = None, "", False
    return found


def follow_shape(part, bindings: dict | None = None) -> dict:
    """Let a part that `add_shape` made rest on the shape of its source as that is now.

    It is meshed as it was then, and stays where it stands. Regions and sides of contacts follow,
    and what became different is returned, as by `replace_file`, which explains `bindings` too.
    Raises ValueError; then nothing has changed.
    """
    source = preparing.checked(part).ShapeSource
    if source is None:
        raise ValueError(
            f"'{part.Label}' has no shape to follow: it was not made from a shape "
            "of this document, or that shape was deleted."
        )
    check_shape(assembly_of(part), source)
    how = shape_source.how_read(part)
    placement = FreeCAD.Placement(FreeCAD.Matrix(*how["placement"]))
    model_now = read_shape(source, placement, part.Label, how["mesh"])
    if len(model_now.parts) != how["of"]:
        raise ValueError(
            f"'{source.Label}' now has {len(model_now.parts)} solids instead of "
            f"{how['of']}, so the one for '{part.Label}' is unknown; add the shape "
            "again."
        )
    found = replaced(part, ReadShape(model_now, how["number"]), bindings)
    shape_source.remember(part, source, {k: v for k, v in how.items() if k != "look"})
    return found


def replaced(part, read, bindings: dict | None = None) -> dict:
    """Let a part rest on what was read; what was picked on it is found again, or told."""
    if len(read.mesh.triangles) == 0:
        raise ValueError(f"{read.name}: there are no triangles; choose another one.")
    original, before = read_original(part), read_kept(part)
    made, scale = prepared_again(part, read.mesh)
    old = preparing.package_mesh(before.points, before.triangles)
    placed = preparing.prepared_module().placed_on(kernel.core(), made, old)
    told: dict[str, str] = {}
    moved = following.moved_vertices(
        part, following.Change(placed, made, 1.0, bindings or {}), told
    )
    tell_guessed(part, moved, told)
    tell_of_shape(part, told)
    extras = preparing.moved_extras(part, placed)
    exchange(part, original, read, (made, scale))
    following.keep_moved(moved)
    if extras is not None:
        assembly_of(part).Extras = extras
    found = {"told": list(told.values()), "different": list(told)}
    part.Differences = json.dumps(found)
    return found


class ReadShape:
    """One solid of a CadModel of the kernel, with its mesh and exact features."""

    def __init__(self, cad_model, number: int):
        cad_file = kernel.load().files.cad_file
        self.kept = kept_shape(cad_model, number)
        self.mesh = cad_file.part_meshes(cad_model)[number]
        self.features = cad_file.exact_features(cad_model.parts[number])
        self.name = self.mesh.name


class Read:
    """The mesh, the exact features and the shape of a part in a file. Raises ValueError."""

    def __init__(self, part, path: Path, mesh: dict | None):
        package = kernel.load()
        self.path, self.name, self.kept = path, path.name, None
        self.features: list[dict] = []
        is_cad = package.files.is_cad(path)
        if is_cad and part.FileData or part.ShapeData and not is_cad:
            wanted = "mesh" if is_cad else "CAD"
            raise ValueError(
                f"'{part.Label}' comes from a {wanted} file; choose a changed version "
                "of that file."
            )
        if not is_cad:
            self.mesh = read_file(path).mesh.with_indices()
            return
        file = read_file(path, mesh)
        meshes = package.files.cad_file.part_meshes(file.model)
        read = ReadShape(file.model, solid_like(part, meshes, path))
        self.kept, self.mesh, self.features = read.kept, read.mesh, read.features


def solid_like(part, meshes: list, path: Path) -> int:
    """Return which of the solids of a file a part is: the one of its name, or the only one."""
    names = [mesh.name for mesh in meshes]
    if len(names) == 1:
        return 0
    if names.count(part.Label) != 1:
        shown = ", ".join(f'"{name}"' for name in names[:8])
        raise ValueError(
            f"{path.name} has {len(names)} solids, and not exactly one is called "
            f"'{part.Label}': rename the part to one of {shown}."
        )
    return names.index(part.Label)


def prepared_again(part, mesh) -> tuple:
    """Return a mesh after the cures that a part had, as `preparing.preparation`, and its scale."""
    done = preparing.preparation_of(part)
    if not done:
        return mesh, 1.0
    remesh = done["remesh"] or {}
    cures = {"weld": done["weld"], "edge": remesh.get("edge"), "scale": done["scale"]}
    wanted = preparing.wanted_of({**cures, "rims": remesh.get("rims", "polygon")})
    told = reporting.progress()
    made, _ = preparing.prepared_module().prepared_mesh(kernel.core(), mesh, wanted, told)
    return made, done["scale"]


def tell_guessed(part, moved: list, told: dict[str, str]) -> None:
    """Tell of what has vertices alone: another state of the file has none for them."""
    for owner, _, vertices, where in moved:
        if not where and owner.Name not in told:
            told[owner.Name] = (
                f"'{owner.Label}' had vertices but no selector: it now has the "
                f"{len(vertices)} nearest vertices of '{part.Label}'."
            )


def tell_of_shape(part, told: dict[str, str]) -> None:
    """Tell of a deformed shape, which is of the mesh before."""
    if part.DeformedShape is not None:
        told[part.DeformedShape.Name] = (
            f"'{part.DeformedShape.Label}' is out of date: update it with Deformed "
            "Shape or Export Parts."
        )


def exchange(part, original, read, prepared: tuple) -> None:
    """Let a part rest on what was read from a file, and on what was prepared of that."""
    made, scale = prepared
    is_prepared = bool(part.Preparation)
    gone = [obj for obj in (part.Source, part.Original) if obj is not None and is_ours(part, obj)]
    first = added_source(part, original.frame, read.mesh, 1.0)
    first.Label = f"{part.Label} at rest"
    with conversion.temporary_folder() as folder:
        stored = os.path.join(folder, "rest.npz")
        write_rest_data(stored, read.mesh, conversion.near_origin(read.mesh.points), read.features)
        if is_prepared:
            part.OriginalData = stored
        else:
            part.RestData = stored
    part.Original = first if is_prepared else None
    part.Source = first
    if is_prepared:
        part.Source = added_source(part, original.frame, made, scale)
        part.Source.Label = f"{part.Label} prepared"
        features = preparing.moved_features(read.features, made, scale)
        with conversion.temporary_folder() as folder:
            stored = os.path.join(folder, "rest.npz")
            origin = conversion.near_origin(made.points)
            write_rest_data(stored, made.with_indices(), origin, features)
            part.RestData = stored
        part.Preparation = json.dumps(made.preparation)
    keep_file(part, read)
    for obj in gone:
        part.Document.removeObject(obj.Name)
    part.Mesh = conversion.copy_at(part.Source.Mesh, conversion.result_placement(part))
    follow_group(assembly_of(part))


def is_ours(part, source) -> bool:
    """Whether a mesh at rest was made for a part alone, by an import or by *Prepare Mesh*."""
    was_imported = bool(part.OriginalData if part.Original is not None else part.RestData)
    is_made = was_imported or source != (part.Original or part.Source)
    others = [p for p in model.parts(assembly_of(part)) if p != part]
    return is_made and all(source not in (p.Source, p.Original) for p in others)


def added_source(part, frame, mesh, scale: float):
    """Return a new hidden mesh at rest, standing where the part does."""
    origin = conversion.near_origin(mesh.points)
    source = part.Document.addObject("Mesh::Feature", "Rest")
    placement = conversion.scaled_placement(frame, scale, origin)
    source.Mesh = conversion.MeshWriter(mesh.triangles).mesh(mesh.points - origin, placement)
    source.Visibility = False
    return source


def keep_file(part, read) -> None:
    """Keep the file, or the shape, that a part is of now."""
    if read.kept is not None:
        keep_shape(part, read.kept)
    else:
        part.FileName, part.FileData = read.path.name, str(read.path.absolute())
