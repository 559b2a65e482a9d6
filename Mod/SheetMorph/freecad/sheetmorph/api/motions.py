# SPDX-License-Identifier: LGPL-2.1-or-later
"""What moves: handles, prescribed rotations of form features, and the deformed positions."""

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
    """Move a handle, always from rest; what is left out stays as it is.

    `translation` (3,) mm; `axis` (3,) and `angle` in degrees, any number of turns; `pivot` (3,)
    mm, the point it turns about, or "centroid". All global. Raises ValueError.
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
    elif pivot is not None and not handle.PivotAtCentroid:  # where it is costs reading the mesh
        handle.PivotAtCentroid, handle.Pivot = True, rest_centroid(handle)


def put(region, motion: Motion) -> None:
    """Give a handle a motion, or a form feature its rotation."""
    if region.Role == HANDLE:
        set_motion(region, **motion.arguments())
    else:
        set_rotation(region, (motion.axis, motion.angle))


def reset_motion(handle) -> None:
    """Put a handle back to rest: no translation, no rotation, turning about its centroid."""
    require_role(handle, HANDLE)
    put(handle, Motion())


def pivot(handle) -> FreeCAD.Vector:
    """Return the point a handle turns about, global at rest, mm."""
    require_role(handle, HANDLE)
    if handle.PivotAtCentroid:
        return rest_centroid(handle)
    return FreeCAD.Vector(*vector_of(handle, "Pivot"))


def rest_centroid(region) -> FreeCAD.Vector:
    """Return the mean of the rest positions of a region's vertices, global, mm."""
    points = read_rest(region.Part).points[model.vertices(region)]
    return FreeCAD.Vector(*np.mean(points, axis=0).tolist())


def set_free_rotation(handle, free: bool) -> None:
    """Let the sheet decide how a handle turns: it is only shifted then; or turn it yourself."""
    require_role(handle, HANDLE)
    handle.FreeRotation = bool(free)


def set_rotation(feature, rotation: str | Sequence) -> None:
    """Say how a form feature turns: "free", "interpolated", or `(axis (3,), degrees)`.

    Free: as a rigid body in an elastic sheet; interpolated: as the handles around it turn.
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

    The properties of the document decide; nothing in it is changed and no recompute is needed.
    Not `exact` is good to 1e-6 of the size. Raises freecad.sheetmorph.objects.errors.MorphError, a
    ValueError, with one sentence.
    """
    require_assembly(assembly)
    return solving.deform(assembly, exact)
