# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form features: admissible motions, sizes and relations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.api import checks
from freecad.sheetmorph.api.checks import (
    number,
    require_features_of,
    require_role,
    vector,
)
from freecad.sheetmorph.api.picking import rest_mesh
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import AXIS, FORM_FEATURE, FREE, LINE, MOTIONS, PLANE
from freecad.sheetmorph.objects.relation import COAXIAL, DISTANCE, GROUP, RelationProxy


class Shape(NamedTuple):
    """The shape of a form feature whose size can be set."""

    kind: str  # "hole", "slot" or "cylinder"
    measure: str  # "diameter", "length" or "radius"
    size: float  # at rest, mm


def set_feature_motion(
    feature,
    kind: str = FREE,
    *,
    direction: Sequence[float] | None = None,
    point: Sequence[float] | None = None,
) -> None:
    """Set the admissible motion of a form feature; omitted arguments stay unchanged.

    Parameters
    ----------
    feature : object
        The form feature.
    kind : str
        "free", "fixed", "translation" (no rotation), "plane" (shifts perpendicular to `direction`
        and rotations about it), "line" (shifts along `direction`) or "axis" (rotations about the
        axis through `point` along `direction`).
    direction : sequence of float, optional
        Direction (3,), global.
    point : sequence of float, optional
        Point (3,), global, mm.

    Raises
    ------
    ValueError
        For an invalid combination.
    """
    require_role(feature, FORM_FEATURE)
    if kind not in MOTIONS:
        raise ValueError(f"The motion '{kind}' does not exist; choose {', '.join(MOTIONS)}.")
    if direction is not None and kind not in (PLANE, LINE, AXIS):
        raise ValueError(f"The motion '{kind}' has no direction; leave it out.")
    along = None if direction is None else checks.direction(direction, "direction")
    place = None if point is None else vector(point, "point")
    feature.Motion = kind
    if along is not None:
        feature.MotionDirection = along
    if place is not None:
        feature.MotionPoint = place


def set_size(feature, size: float | None) -> None:
    """Set the diameter of a hole, the length of a slot or the radius of a cylinder, mm.

    The rim becomes an exact circle, slot or cylinder of this size. None restores the size of the
    mesh. The recompute reports a size that is too large for the sheet. Raises ValueError if the
    feature has another shape, or if the size is not positive.
    """
    require_role(feature, FORM_FEATURE)
    if size is None:
        feature.Size = 0.0
        return
    wanted = number(size, "size")
    found = shape_of(feature)
    if found is None:
        raise ValueError(
            f"'{feature.Label}' is not a hole, slot or cylinder, so it has no size; "
            "pick a whole rim or wall."
        )
    if wanted <= 0.0:
        raise ValueError(f"The {found.measure} is {wanted} mm; pass more than 0.")
    feature.Size = wanted


def shape_of(feature) -> Shape | None:
    """Return kind, measure and size of a form feature whose size can be set, or None."""
    require_role(feature, FORM_FEATURE)
    points, triangles = rest_mesh(feature.Part)
    found = kernel.core().feature_shape(points, triangles, model.vertices(feature))
    return None if found is None else Shape(found.kind, found.measure, found.size)


def group(assembly, features: Iterable, label: str = "Group"):
    """Make form features of one part move as one rigid body and return the relation.

    Raises ValueError for fewer than two features, or for features of several parts.
    """
    members = list(features)
    require_features_of(assembly, members)
    if len({feature.Part for feature in members}) > 1:
        raise ValueError(
            "A group needs form features of one part, and these are on several; "
            "join the parts with a rigid contact."
        )
    return add_relation(assembly, GROUP, members, label)


def coaxial(assembly, a, b, label: str = "Coaxial"):
    """Make two form features, on one or two parts, keep their common axis; return the relation.

    They must share it at rest; otherwise the recompute reports the deviation.
    """
    require_features_of(assembly, [a, b])
    return add_relation(assembly, COAXIAL, [a, b], label)


def keep_distance(assembly, a, b, label: str = "Distance"):
    """Make two form features, on one or two parts, keep the distance of their centres."""
    require_features_of(assembly, [a, b])
    return add_relation(assembly, DISTANCE, [a, b], label)


def add_relation(assembly, kind: str, features: list, label: str):
    """Add a relation of any type, for `group`, `coaxial` and `keep_distance`."""
    relation = assembly.Document.addObject("App::FeaturePython", "Relation")
    RelationProxy(relation)
    relation.Label = label
    relation.Type = kind
    relation.Features = features
    assembly.addObject(relation)
    return relation
