# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report entries on parts that are solved as thin solids."""

from __future__ import annotations

from typing import Any

from ..base.arrays import Floats, Ints
from ..base.errors import Caution
from ..measuring.crossings import crossings, new_crossings
from ..measuring.sizes import NOT_RIGID
from ..measuring.thickness import thickness_change
from ..solving.answer import Answer


def thin_report(result: Answer, part: str) -> dict[str, Any] | None:
    """Return the entry "thin" of a part: thickness and self-intersections, at rest and deformed.

    Return None if the part is not a thin solid.
    """
    session = result.session
    solid = session.thin_solid(part)
    if solid is None:
        return None
    positions = result.positions[part]
    change = thickness_change(session.meshes[part], solid, positions)
    vertex, rest, deformed = change.place
    lumps = [lump for lump in result.lumps if lump.part == part]
    return {
        "thickness": solid.thickness,
        "holes": len(solid.holes),
        "lumps": [
            {"name": lump.name, "vertices": len(vertices), "edge_error": lump.edge_error}
            for lump, vertices in zip(lumps, solid.lumps)
        ],
        "rest": {"least": change.rest_least, "most": change.rest_most},
        "deformed": {"least": change.least, "most": change.most},
        "largest_change": change.worst,
        "largest_change_at_walls": change.worst_at_walls,
        "worst": (
            {"place": positions[vertex].tolist(), "rest": rest, "deformed": deformed}
            if vertex >= 0
            else None
        ),
        "self_intersections": dict(zip(("rest", "deformed"), crossed(result, part))),
    }


def thickness_in_file(result: Answer, part: str, points: Floats) -> dict[str, Any] | None:
    """Return the thickness of a part on points (n, 3) stored in a file, mm.

    largest_change is relative to the sheet at rest, and in_mesh is that of the deformed mesh.
    Return None if the part is not thin.
    """
    solid, own = result.session.thin_solid(part), result.session.meshes[part]
    if solid is None or len(points) != len(own.points):
        return None
    written, wanted = (
        thickness_change(own, solid, there) for there in (points, result.positions[part])
    )
    return {
        "thickness": solid.thickness,
        "least": written.least,
        "most": written.most,
        "largest_change": max(written.worst, written.worst_at_walls),
        "in_mesh": max(wanted.worst, wanted.worst_at_walls),
    }


def crossed(result: Answer, part: str) -> tuple[int, int]:
    """Count the intersecting pairs of triangles of a part, at rest and in the pose (CGAL)."""
    return len(result.session.rest_crossings(part)), len(_crossings(result, part))


def crossed_anew(result: Answer, part: str) -> Ints:
    """Return the pairs (k, 2) of triangles that intersect in the pose but not at rest."""
    pairs, session = _crossings(result, part), result.session
    if not len(pairs):
        return pairs
    corners = session.cuts(part).first[session.meshes[part].triangles]
    return new_crossings(pairs, session.rest_crossings(part), corners)


def _crossings(result: Answer, part: str) -> Ints:
    positions, triangles = result.positions[part], result.session.meshes[part].triangles
    return result.once(("crossings", part), lambda: crossings(positions, triangles))


def thin_failures(result: Answer, tol: float) -> list[Caution]:
    """Return a failure for every thick region that is not rigid within the tolerance, mm."""
    return [
        Caution(f"{lump.edge_error:.3g} mm", code=NOT_RIGID, where=lump.name)
        for lump in result.lumps
        if not lump.edge_error <= tol
    ]
