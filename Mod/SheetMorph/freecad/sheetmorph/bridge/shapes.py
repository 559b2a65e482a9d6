# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CAD shape that a part was meshed from, and the same shape where the part is now."""

from __future__ import annotations

import os
from pathlib import Path

import FreeCAD
import numpy as np
import Part

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import conversion, kernel, stored_arrays
from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.objects.errors import MorphError

# Of the size of a part: what is nearer is the same vertex.
_SAME = 1e-9


def kept_shape(model, number: int) -> dict[str, np.ndarray]:
    """The shape that one part of a CadModel was meshed from, as a document keeps it.

    Ask for it before the document changes: the model's worker may have ended. Raises ValueError.
    """
    mesh = np.frombuffer(model.kept_mesh(number), dtype=np.uint8)
    return {"brep": stored_arrays.of_text(model.brep(number)), "mesh": mesh}


def keep_shape(part, kept: dict[str, np.ndarray]) -> None:
    """Keep a `kept_shape` in a part of the document."""
    with conversion.temporary_folder() as folder:
        stored = os.path.join(folder, "shape.npz")
        stored_arrays.write(stored, **kept)
        part.ShapeData = stored


def kept_model(part):
    """The CadModel of the kept shape. Raises ValueError."""
    with stored_arrays.opened(part.ShapeData) as data:
        brep, mesh = stored_arrays.text_in(data["brep"]), data["mesh"].tobytes()
    return kernel.cad_module().kept_model(brep, mesh, part.Label)


def has_shape(part) -> bool:
    """Whether a part was meshed from a shape, and its mesh is that one still."""
    return bool(part.ShapeData) and part.Original is None and read_kept(part).is_exact


def carried_shape(part, positions: np.ndarray) -> tuple[Part.Shape, dict]:
    """The shape of a part at global positions (n, 3) of its mesh, and what it was measured to be.

    The shape has the part's file coordinates; see `placement_of`. Raises MorphError.
    """
    if not has_shape(part):
        raise MorphError(
            f"Part '{part.Label}' was not made from a shape, or its mesh was changed since: add "
            "the shape again."
        )
    kept, files = read_kept(part), kernel.load().files
    model = kept_model(part)
    points = model.parts[0].points
    size = float(np.linalg.norm(np.ptp(kept.points, axis=0)))
    if points.shape != kept.points.shape or np.abs(points - kept.points).max() > _SAME * size:
        raise MorphError(
            f"The shape of part '{part.Label}' is not the one of its mesh: add it again."
        )
    local = kept.frame.to_local(positions) + kept.frame.origin
    if kept.frame.is_unmoved():
        local = np.array(positions)
    with conversion.temporary_folder() as folder:
        path = Path(folder) / "shape.brep"
        writing = files.cad_writing.CadWriting("brep")
        write = files.cad_writing.write_model
        (body,) = reporting.waited_for(
            lambda told: write(model, path, [local], writing, progress=told)
        )
        shape = Part.Shape()
        shape.importBrep(str(path))
    return shape, body


def placement_of(part) -> FreeCAD.Placement:
    """Where a shape in the part's file coordinates stands."""
    frame = read_kept(part).frame
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = (frame.rotation, frame.base - frame.rotation @ frame.origin)
    return FreeCAD.Placement(FreeCAD.Matrix(*matrix.ravel().tolist()))
