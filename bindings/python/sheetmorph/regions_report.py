# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the report tells of every region: how large it is, where, how its selector came to it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from .arrays import Ints
from .errors import Caution
from .part_mesh import PartMesh
from .preprocessed import Preprocessed
from .recipe.model import RegionEntry


def region_entries(session: Preprocessed) -> list[dict[str, Any]]:
    """One entry a region and side of a contact, those that are points on triangles left out."""
    return [_entry(session, region) for region in session.model.all_regions if not region.is_point]


def region_remarks(session: Preprocessed) -> Iterator[Caution]:
    """What a user should know of the selectors: that they took all, or something far away."""
    for region in session.model.all_regions:
        for remark in session.model.told.get(region.where, {}).get("remarks", ()):
            yield Caution(f'"{region.name}" on "{region.part}": {remark}', region.subject)


def _entry(session: Preprocessed, region: RegionEntry) -> dict[str, Any]:
    mesh, vertices = session.meshes[region.part], session.region_vertices(region)
    area, centre = _extent(mesh, vertices)
    told = session.model.told.get(region.where)
    return {
        "name": region.name,
        "part": region.part,
        "kind": region.kind,
        "vertices": len(vertices),
        "area": area if told is None else told["area"],
        "centre": centre,
        "distance": None if told is None else told["distance"],
        "matches": [] if told is None else told["matches"],
    }


def _extent(mesh: PartMesh, vertices: Ints) -> tuple[float, list[float]]:
    """The area of the triangles within, mm^2, and their centre, that of the vertices if none."""
    inside = np.zeros(len(mesh.points), dtype=bool)
    inside[vertices] = True
    corners = mesh.points[mesh.triangles[inside[mesh.triangles].all(axis=1)]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = 0.5 * np.linalg.norm(normals, axis=1)
    total = float(areas.sum())
    if total > 0.0:
        return total, (areas @ corners.mean(axis=1) / total).tolist()
    return 0.0, mesh.points[vertices].mean(axis=0).tolist()
