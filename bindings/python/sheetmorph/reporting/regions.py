# SPDX-License-Identifier: LGPL-2.1-or-later
"""Region entries of the report: size, location, and the matches of the selector."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..base.arrays import Ints
from ..base.errors import Caution
from ..base.part_mesh import PartMesh
from ..recipe.model import RegionEntry
from ..solving.preprocessed import Preprocessed


def region_entries(session: Preprocessed) -> list[dict[str, Any]]:
    """Return an entry for every region and contact side, without points on triangles."""
    return [_entry(session, region) for region in session.model.all_regions if not region.is_point]


def region_remarks(session: Preprocessed) -> Iterator[Caution]:
    """Warn about selectors that selected a whole part or something far away."""
    for region in session.model.all_regions:
        for remark in session.model.told.get(region.where, {}).get("remarks", ()):
            yield Caution(remark, region.subject, where=f'"{region.name}" on "{region.part}"')


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
    """Return the area inside a region, mm^2, and its centroid, or that of the vertices."""
    inside = np.zeros(len(mesh.points), dtype=bool)
    inside[vertices] = True
    corners = mesh.points[mesh.triangles[inside[mesh.triangles].all(axis=1)]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = 0.5 * np.linalg.norm(normals, axis=1)
    total = float(areas.sum())
    if total > 0.0:
        return total, (areas @ corners.mean(axis=1) / total).tolist()
    return 0.0, mesh.points[vertices].mean(axis=0).tolist()
