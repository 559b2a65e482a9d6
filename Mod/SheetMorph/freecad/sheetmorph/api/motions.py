# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions: handles, prescribed rotations of form features, and the deformed positions."""

from __future__ import annotations

from collections.abc import Sequence

import FreeCAD
import numpy as np

from freecad.sheetmorph.bridge import solving
from freecad.sheetmorph.api.checks import direction, number, require_assembly, require_role, vector
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.properties import vector_of
from freecad.sheetmorph.objects.region import FORM_FEATURE, FREE, HANDLE, INTERPOLATED, PRESCRIBED
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.tools.motion import CENTROID, Motion


def set_motion(
    handle,
    translation: Sequence[float] | None = None,
    axis: Sequence[float] | None = None,
    angle: float | None = None,
    *,
    pivot: Sequence[float] | str | None = None,
) -> None:
    """Move a handle, always from rest; omitted arguments stay unchanged.

    Parameters
    ----------
    handle : object
        The handle.
    translation : sequence of float, optional
        Translation (3,), global, mm.
    axis : sequence of float, optional
        Rotation axis (3,), global.
    angle : float, optional
        Rotation angle, degrees, with any number of turns.
    pivot : sequence of float or str, optional
        Centre of rotation (3,), global, mm, or "centroid".

    Raises
    ------
    ValueError
        For invalid values.
    """
    require_role(handle, HANDLE)
    shift = None if translation is None else vector(translation, "translation")
    line = None if axis is None else direction(axis, "axis")
    turn = None if angle is None else number(angle, "angle")
    is_point = pivot is not None and not isinstance(pivot, str)
    point = vector(pivot, "pivot") if is_point else None
    if isinstance(pivot, str) and pivot != CENTROID:
        raise ValueError(f"The pivot '{pivot}' is unknown; pass a point (x, y, z) or 'centroid'.")
    if shift is not None:
        handle.TranslationX, handle.TranslationY, handle.TranslationZ = shift
    if line is not None:
        handle.Axis = line
    if turn is not None:
        handle.Angle = turn
    if point is not None:
        handle.PivotAtCentroid, handle.Pivot = False, point
    # the position of the centroid requires reading the mesh
    elif pivot is not None and not handle.PivotAtCentroid:
        handle.PivotAtCentroid, handle.Pivot = True, rest_centroid(handle)


def put(region, motion: Motion) -> None:
    """Set the motion of a handle, or the rotation of a form feature."""
    if region.Role == HANDLE:
        set_motion(region, **motion.arguments())
    else:
        set_rotation(region, (motion.axis, motion.angle))


def reset_motion(handle) -> None:
    """Return a handle to rest: no translation, no rotation, pivot at its centroid."""
    require_role(handle, HANDLE)
    put(handle, Motion())


def pivot(handle) -> FreeCAD.Vector:
    """Return the centre of rotation of a handle, global at rest, mm."""
    require_role(handle, HANDLE)
    if handle.PivotAtCentroid:
        return rest_centroid(handle)
    return FreeCAD.Vector(*vector_of(handle, "Pivot"))


def rest_centroid(region) -> FreeCAD.Vector:
    """Return the mean rest position of a region's vertices, global, mm."""
    points = read_rest(region.Part).points[model.vertices(region)]
    return FreeCAD.Vector(*np.mean(points, axis=0).tolist())


def set_free_rotation(handle, free: bool) -> None:
    """Let the sheet determine the rotation of a handle, or prescribe it.

    A handle with free rotation is only translated.
    """
    require_role(handle, HANDLE)
    handle.FreeRotation = bool(free)


def set_rotation(feature, rotation: str | Sequence) -> None:
    """Set the rotation of a form feature: "free", "interpolated", or `(axis (3,), degrees)`.

    With "free" it rotates as a rigid body in an elastic sheet, with "interpolated" as the handles
    around it.
    """
    require_role(feature, FORM_FEATURE)
    if isinstance(rotation, str) and rotation in (FREE, INTERPOLATED):
        feature.Rotation = rotation
        return
    if isinstance(rotation, str) or len(rotation) != 2:
        raise ValueError(
            f"The rotation '{rotation}' is not available; pass '{FREE}', '{INTERPOLATED}' or "
            "(axis, degrees)."
        )
    axis, degrees = direction(rotation[0], "axis"), number(rotation[1], "angle")
    feature.RotationAxis = axis
    feature.RotationAngle = degrees
    feature.Rotation = PRESCRIBED


def deform(assembly, exact: bool = True) -> dict[str, np.ndarray]:
    """Return the deformed positions (n, 3) float64, global, mm, of every part by `part.Name`.

    The properties of the document define the pose. The document does not change, and no recompute
    is needed. Without `exact` the accuracy is 1e-6 of the size. Raises
    freecad.sheetmorph.objects.errors.MorphError, a ValueError, with one sentence.
    """
    require_assembly(assembly)
    return solving.deform(assembly, exact)
