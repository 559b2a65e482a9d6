# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found, in the form of find.schema.json: entries that a recipe takes as they are."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import resources
from typing import TYPE_CHECKING, Any

from ..arrays import Ints
from ..part_mesh import PartMesh
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
    """The published JSON Schema of what is found."""
    text = resources.files("sheetmorph").joinpath("find.schema.json").read_text("utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


@dataclass(frozen=True, eq=False)
class FindPart:
    """A part to look at. thickness: of a sheet without one in its mesh, mm, 0 if not known; exact:
    what its CAD surfaces say, as entries with vertices that are indices, angles in radians; bodies:
    the vertices (indices) of each rigid body of a deck; kept:
    what the last search found on the mesh, by its tolerances: whoever keeps it saves another one.
    """

    name: str
    mesh: PartMesh
    thickness: float = 0.0
    exact: list[dict[str, Any]] = field(default_factory=list)
    bodies: list[list[int]] = field(default_factory=list)
    kept: dict[tuple[float | None, ...], list[_core.Feature]] = field(default_factory=dict)


def body_entries(part: FindPart) -> list[dict[str, Any]]:
    """The rigid bodies of a part as features of a recipe: a morph keeps them rigid, too."""
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
    """features and contacts as a recipe takes them; gap: the one used, mm; primary: names of parts,
    the likeliest first; seconds: of the search."""

    features: list[dict[str, Any]] = field(default_factory=list)
    contacts: list[dict[str, Any]] = field(default_factory=list)
    gap: float = 0.0
    primary: list[str] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=dict)


def feature_entry(part: FindPart, found: _core.Feature) -> dict[str, Any]:
    """A feature of the kernel as a recipe's entry, still without name and part; what its kind has
    not is left out."""
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
    """A contact of the kernel as a recipe's entry."""

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
