# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD: parts from STEP, IGES and BREP files and from the shapes of a document."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.api.checks import refuse_link, require_assembly
from freecad.sheetmorph.api.meshes import add_mesh
from freecad.sheetmorph.bridge.reading import read_file
from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.bridge.shapes import keep_shape, kept_shape
from freecad.sheetmorph.objects import shape_source
from freecad.sheetmorph.objects.part import THIN_AUTOMATIC


def import_cad(assembly, path: str | os.PathLike, mesh: dict | None = None) -> list:
    """Read a STEP, IGES or BREP file into an assembly and return its parts.

    One part for every solid and for every shell outside of solids, named and placed as in the
    file. `mesh`: how finely they are meshed, `{"edge": 5, "deflection": 0.1, "angle": 20}` (mm,
    mm, degrees); what is left out follows from the size of what is in the file.
    Raises ValueError or OSError if the file cannot be read.
    """
    require_assembly(assembly)
    package = kernel.load()
    if not package.files.is_cad(path):
        raise ValueError(f"{Path(path).name} is not a CAD file; use import_part.")
    return add_model(assembly, read_file(path, mesh).model)


def add_shape(assembly, source, label: str | None = None, mesh: dict | None = None) -> list:
    """Add the shape of an object of the document to an assembly and return its parts.

    `source`: a Part::Feature, anywhere in the document; it is hidden and never changed. When it is
    edited, `follow_shape` lets the parts follow. One part a solid or free shell, called `label`,
    default the source's; `mesh` as for `import_cad`. Raises ValueError: no shape, empty, broken.
    """
    require_assembly(assembly)
    check_shape(assembly, source)
    placement = source.getGlobalPlacement()
    read = read_shape(source, placement, label or source.Label, mesh)
    parts = add_model(assembly, read)
    numbers = [number for number, one in enumerate(read.parts) if len(one.triangles)]
    how = {"mesh": mesh or {}, "placement": list(placement.toMatrix().A), "of": len(read.parts)}
    for part, number in zip(parts, numbers):
        shape_source.remember(part, source, {**how, "number": number})
    source.Visibility = False
    return parts


def read_shape(source, placement, label: str, mesh: dict | None):
    """Return the CadModel of the kernel of the shape of an object that stands at `placement`."""
    shape = source.Shape.copy()
    shape.Placement = placement
    return kernel.load().files.cad_file.read_shape(shape.exportBrepToString(), label, mesh)


def check_shape(assembly, source) -> None:
    """Raise ValueError if the shape of `source` cannot become parts of `assembly`."""
    refuse_link(source)
    label = getattr(source, "Label", repr(source))
    if not (hasattr(source, "isDerivedFrom") and source.isDerivedFrom("Part::Feature")):
        raise ValueError(f"'{label}' has no shape; add it with add_part if it is a mesh.")
    if source.Document != assembly.Document:
        raise ValueError(f"'{label}' is in another document; copy it into this one first.")
    if source.Shape.isNull() or not source.Shape.Faces:
        raise ValueError(f"The shape '{label}' has no faces; choose another one.")


def add_model(assembly, model) -> list:
    """Add all parts of a CadModel of the kernel that have triangles; return them.

    They bend as sheets with two skins where they are sheets.
    """
    cad_file = kernel.load().files.cad_file
    found = [
        (mesh, cad_file.exact_features(part), kept_shape(model, number))
        for number, (part, mesh) in enumerate(zip(model.parts, cad_file.part_meshes(model)))
        if len(mesh.triangles)
    ]
    parts = []
    for mesh, features, kept in reporting.one_by_one(found, "adding the parts"):
        parts.append(add_mesh(assembly, mesh, mesh.name, features))
        keep_shape(parts[-1], kept)
        parts[-1].Thin = THIN_AUTOMATIC
    return parts


def exact_features(part) -> list[dict]:
    """Return the holes, cylinders, planes, cones and spheres of a part, from its CAD surfaces.

    Each a dict with `kind`, `center`, `axis`, `vertices`, `residual` (mm) and, where it has them,
    `radius`, `length`, `angle` (degrees) and `hollow`; exact to rounding, in global coordinates.
    Empty for a part that does not come from CAD, or whose mesh was edited since.
    """
    return [in_degrees(feature) for feature in known_features(part)]


def known_features(part) -> list[dict]:
    """Return the same with angles in radians, as the package has them."""
    kept = read_kept(part)
    return [globally(feature, kept.frame) for feature in kept.features]


def globally(feature: dict, frame) -> dict:
    """Return a feature in file coordinates as a user sees it."""
    placed = dict(feature)
    placed["center"] = frame.to_global(np.array([feature["center"]]))[0].tolist()
    placed["axis"] = (frame.rotation @ np.array(feature["axis"])).tolist()
    return placed


def in_degrees(feature: dict) -> dict:
    """Return a feature with its angle in degrees."""
    angle = {"angle": math.degrees(feature["angle"])} if "angle" in feature else {}
    return {**feature, **angle}
