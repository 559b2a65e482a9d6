# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search results in the form of find.schema.json, which is also that of recipe entries."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from ..base.arrays import Ints
from ..base.packaged import packaged_json
from ..base.part_mesh import PartMesh
from .options import HOLES

if TYPE_CHECKING:
    from .. import _core

_LENGTHS = {
    "slotted hole": ("length", "width"),
    "rectangular hole": ("length", "width"),
    "hole": ("length", "width"),
    "plane": ("length", "width"),
    "cylinder": ("length",),
    "cone": ("length",),
    "flange": ("length", "width"),
    "bead": ("length", "width"),
    "emboss": ("length", "width"),
    "bend": ("length",),
}
_WITH_RADIUS = ("round hole", "slotted hole", "rectangular hole", "round edge", "bend")
_CURVED = ("cylinder", "cone", "sphere")


def find_schema() -> dict[str, Any]:
    """Return the published JSON Schema of search results."""
    return packaged_json(__package__, "find.schema.json")


@dataclass(frozen=True, eq=False)
class FindPart:
    """A part to search.

    thickness is that of a sheet, mm, 0 if not given. exact has the features of its CAD surfaces,
    with vertex indices and angles in radians. bodies has the vertex indices of each rigid body of a
    deck. kept caches the features of the last search by its tolerances.
    """

    name: str
    mesh: PartMesh
    thickness: float = 0.0
    exact: list[dict[str, Any]] = field(default_factory=list)
    bodies: list[list[int]] = field(default_factory=list)
    kept: dict[tuple[float | None, ...], list[_core.Feature]] = field(default_factory=dict)


def body_entries(part: FindPart) -> list[dict[str, Any]]:
    """Return the rigid bodies of a part as features, so that a morph keeps them rigid."""
    return [
        {
            "name": f"{part.name}: rigid body {number}",
            "part": part.name,
            "kind": "rigid body",
            "center": part.mesh.points[rows].mean(axis=0).tolist(),
            "axis": [0.0, 0.0, 1.0],
            "residual": 0.0,
            "vertices": part.mesh.file_ids(rows),
        }
        for number, rows in enumerate(part.bodies, 1)
    ]


@dataclass
class Findings:
    """Search results: features and contacts in the form of the recipe.

    gap is the contact gap of the search, mm. primary has part names, the most likely first. seconds
    is the duration of each step.
    """

    features: list[dict[str, Any]] = field(default_factory=list)
    contacts: list[dict[str, Any]] = field(default_factory=list)
    gap: float = 0.0
    primary: list[str] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=dict)


def feature_entry(part: FindPart, found: _core.Feature) -> dict[str, Any]:
    """Return a feature of the kernel as a recipe entry without name and part.

    Values that its kind does not have are left out.
    """
    mesh = part.mesh
    entry = {"kind": found.kind, "center": found.center.tolist(), "axis": found.axis.tolist()}
    if found.kind in (*_WITH_RADIUS, *_CURVED):
        entry["radius"] = found.radius
    entry |= {key: getattr(found, key) for key in _LENGTHS.get(found.kind, ())}
    if found.kind in (*HOLES, "bead", "emboss", "bend") and found.depth > 0.0:
        entry["depth"] = found.depth
    if found.kind in ("cone", "bend"):
        entry["angle"] = found.angle
    if found.kind in _CURVED:
        entry["hollow"] = found.is_hollow
    entry["residual"] = found.residual
    if found.scatter > 0.0:
        entry["scatter"] = found.scatter
    if found.unsettled:
        entry["unsettled"] = found.unsettled
    entry["vertices"] = mesh.file_ids(found.vertices)
    if found.rims:
        entry["rims"] = [mesh.file_ids(rim) for rim in found.rims]
    if found.washer:
        entry["washer"] = [mesh.file_ids(ring) for ring in found.washer]
    return entry


def contact_entry(
    parts: Sequence[FindPart], found: _core.FoundContact, name: str
) -> dict[str, Any]:
    """Return a contact of the kernel as a recipe entry."""

    def side(index: int, vertices: Ints) -> dict[str, Any]:
        part = parts[index]
        return {"part": part.name, "vertices": part.mesh.file_ids(vertices)}

    entry = {
        "name": name,
        "type": found.type,
        "kind": found.kind,
        "a": side(found.part_a, found.a),
        "b": side(found.part_b, found.b),
        "distance": found.distance,
        "center": found.center.tolist(),
        "size": found.size,
    }
    if found.connections:
        entry["connections"] = found.connections
    return entry
