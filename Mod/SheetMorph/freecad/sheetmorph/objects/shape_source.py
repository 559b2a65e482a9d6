# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document shape from which a part was meshed, and detection of its changes."""

from __future__ import annotations

import json

import FreeCAD
import numpy as np

from freecad.sheetmorph.kinds import PART, kind

# Share of the shape size; smaller differences are rounding in FreeCAD's recompute.
_SAME = 1e-9


def remember(part, source, how: dict) -> None:
    """Store the source of a part, and in `how` the way it was read: number, of, mesh, placement."""
    part.ShapeSource = source
    part.ShapeRead = json.dumps({**how, "look": look_of(source.Shape)})
    part.SourceChanged = False


def how_read(part) -> dict:
    """Return the data of `remember`; empty for a part without a source shape."""
    return json.loads(part.ShapeRead) if part.ShapeRead else {}


def look_of(shape) -> list[float]:
    """Return numbers that identify a shape independent of its placement; none for an empty shape.

    These are counts, area and moments of the vertices.
    """
    if shape.isNull():
        return []
    local = shape.copy()
    local.Placement = FreeCAD.Placement()
    points = np.array([vertex.Point for vertex in local.Vertexes]).reshape(-1, 3)
    about = np.vstack([points, np.zeros((1, 3))])  # a sphere would otherwise have no moments
    moments = [about.mean(axis=0), (about**2).mean(axis=0), np.prod(about[:, :2], axis=1).mean()]
    numbers = np.hstack([local.Area, *moments])
    return [len(local.Faces), len(local.Edges), *numbers.tolist()]


def is_another(part) -> bool:
    """Return whether the source shape of a part changed since it was read."""
    known, now = np.array(how_read(part)["look"]), np.array(look_of(part.ShapeSource.Shape))
    if known.shape != now.shape:
        return True
    return bool(np.any(np.abs(known - now) > _SAME * np.abs(known).max()))


def note_change(source) -> None:
    """Record in the parts of a shape whether it changed, and print this once."""
    document = source.Document
    if document.Restoring or document.Transacting:
        return  # FreeCAD restores the record itself
    for part in parts_of(source):
        changed = is_another(part)
        if changed and not part.SourceChanged:
            FreeCAD.Console.PrintWarning(
                f"SheetMorph: '{source.Label}' was edited: use Follow Shape to mesh "
                f"'{part.Label}' again and find its regions.\n"
            )
        if changed != part.SourceChanged:
            part.SourceChanged = changed


def parts_of(source) -> list:
    """Return the parts that were meshed from a shape."""
    every = source.Document.findObjects("Mesh::FeaturePython")
    mine = [obj for obj in every if kind(obj) == PART and "ShapeSource" in obj.PropertiesList]
    return [part for part in mine if part.ShapeSource == source]
