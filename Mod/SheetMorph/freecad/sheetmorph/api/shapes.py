# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deformed CAD shapes of parts that come from a shape."""

from __future__ import annotations

from freecad.sheetmorph.bridge import kernel, shapes, solving
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.objects.errors import MorphError


def deformed_shape(part):
    """Create or update the deformed shape of a part and return it, a Part::Feature.

    It has the faces of the original shape. Faces that moved as one rigid body, such as holes of
    form features, keep their surfaces. The others become splines within 0.01 mm of the deformed
    mesh. `update_shapes` updates it. Raises MorphError if the part has no original shape, if its
    mesh was changed or folds, or if a tolerance is missed.
    """
    positions = solving.deform(assembly_of(part))[part.Name]
    _require_unfolded(part, positions)
    shape, body = shapes.carried_shape(part, positions)
    faults = kernel.load().reporting.shapes.body_faults(body)
    if faults:
        raise MorphError(f"The shape of part '{part.Label}': {'; '.join(faults)}.")
    feature = part.DeformedShape
    if feature is None:
        feature = part.Document.addObject("Part::Feature", "DeformedShape")
        feature.Label = f"{part.Label} deformed"
        part.DeformedShape = feature
    feature.Shape = shape
    feature.Placement = shapes.placement_of(part).multiply(shape.Placement)
    return feature


def _require_unfolded(part, positions) -> None:
    package, rest = kernel.load(), read_rest(part)
    mesh = package.PartMesh(rest.points, rest.triangles)
    fold = package.reporting.shapes.fold_of(kernel.core(), mesh, positions)
    if fold:
        raise MorphError(
            f"The mesh of part '{part.Label}' folds ({fold}), so the faces of its "
            "shape would fold too: turn its handles less, or use a finer mesh."
        )


def update_shapes(assembly) -> list:
    """Update all deformed shapes of an assembly and return them."""
    return [deformed_shape(part) for part in model.parts(assembly) if part.DeformedShape]
