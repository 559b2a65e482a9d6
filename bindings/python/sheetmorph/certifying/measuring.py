# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run wrote, read again beside what it was made from, and measured."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..certificate import feature_edges
from ..decks.following import rigid_motion
from ..decks.materials import STEEL, Material
from ..part_mesh import PartMesh
from .criteria import Criteria
from .quality import MEASURES, areas, measured, step_length

_ROUND = 0.12
_BINS = 20


@dataclass(frozen=True)
class Written:
    """A part as it was and as it was written: its mesh at rest, (n, 3) places read from the file,
    faces (m, 4) with -1 in the last corner of triangles, thickness mm (0 if it is not known), and
    what a coordinate in the file is good for, mm; material: of its sheet."""

    mesh: PartMesh
    places: np.ndarray
    faces: np.ndarray
    thickness: float
    width_error: float
    material: Material = STEEL


def feature_entry(core: Any, part: Written, name: str, vertices: np.ndarray) -> dict[str, Any]:
    """How a form feature came out: worst edge error against the best rigid motion, and round rims
    before and after."""
    rest, moved = part.mesh.points, part.places
    edges = feature_edges(part.mesh, vertices)
    found = rigid_motion(rest[vertices], moved[vertices])
    turn = np.eye(3) if found is None else found[0]
    before = rest[edges[:, 0]] - rest[edges[:, 1]]
    after = moved[edges[:, 0]] - moved[edges[:, 1]]
    if found is None:
        error = np.abs(np.linalg.norm(after, axis=1) - np.linalg.norm(before, axis=1))
    else:
        error = np.linalg.norm(after - before @ turn.T, axis=1)
    return {
        "name": name,
        "part": part.mesh.name,
        "vertices": len(vertices),
        "edge_error": float(error.max(initial=0.0)),
        "allowed": 4.0 * part.width_error + 1e-9 * float(np.abs(moved).max(initial=1.0)),
        "rims": _rims(core, part, vertices),
    }


def _rims(core: Any, part: Written, vertices: np.ndarray) -> list[dict[str, float]]:
    """Diameter and roundness (the worst distance from the fitted circle) of round rims inside."""
    inside = np.zeros(len(part.mesh.points), dtype=bool)
    inside[vertices] = True
    near = inside[part.mesh.triangles].any(axis=1)
    rows, corners = np.unique(part.mesh.triangles[near], return_inverse=True)
    mesh = core.TriangleMesh(
        part.mesh.points[rows], np.ascontiguousarray(corners.reshape(-1, 3), np.int32)
    )
    found = []
    for loop in core.boundary_loops(mesh):
        rim = rows[np.asarray(loop)]
        if len(rim) < 6 or not inside[rim].all():
            continue
        one, two = (core.fit_circle(points[rim]) for points in (part.mesh.points, part.places))
        if one.residual <= _ROUND * one.radius:
            found.append(
                {
                    "diameter_before": 2.0 * float(one.radius),
                    "diameter_after": 2.0 * float(two.radius),
                    "roundness_before": float(one.residual),
                    "roundness_after": float(two.residual),
                }
            )
    return found


def contact_entry(core: Any, name: str, sides: tuple[tuple[Written, np.ndarray], ...]) -> dict:
    """The gap of a contact before and after, and its worst change: from the vertices of the one
    side to the surface of the other part, both ways."""
    gaps: tuple[list[float], list[float]] = ([], [])
    for (one, vertices), (other, _) in (sides, sides[::-1]):
        for places, points, target in (
            (gaps[0], one.mesh.points, other.mesh.points),
            (gaps[1], one.places, other.places),
        ):
            tree = core.PickingTree(target, other.mesh.triangles)
            hits = [tree.nearest_point(points[k]) for k in vertices]
            places += [0.0 if hit is None else float(hit.distance) for hit in hits]
    before, after = np.array(gaps[0]), np.array(gaps[1])
    return {
        "name": name,
        "gap_before": float(before.mean()) if len(before) else 0.0,
        "gap_after": float(after.mean()) if len(after) else 0.0,
        "worst_change": float(np.abs(after - before).max(initial=0.0)),
    }


def part_entry(core: Any, part: Written, criteria: Criteria) -> dict[str, Any]:
    """Quality before and after, flipped triangles, mass, time step."""
    rest, moved, faces = part.mesh.points, part.places, part.faces
    flipped = core.compare_quality(rest, moved, part.mesh.triangles).flipped
    thickness = part.thickness or 1.0
    weight = thickness * part.material.density
    sizes = [measured(areas, points, faces) * weight for points in (rest, moved)]
    return {
        "name": part.mesh.name,
        "elements": len(faces),
        "largest_displacement": float(np.linalg.norm(moved - rest, axis=1).max(initial=0.0)),
        "flipped": int(flipped),
        "quality": [
            _quality_entry(part, measure, criteria.elements.get(measure, {}))
            for measure in MEASURES
        ],
        "newly_failing": int(_newly_failing(part, criteria).sum()),
        "thickness": part.thickness or None,
        "material": {"name": part.material.name, "density_t_mm3": part.material.density},
        "mass": None if not part.thickness else _change(*(float(s.sum()) for s in sizes)),
        "area_change": _relative(*(float(s.sum()) for s in sizes)),
        "time_step": _steps(part, sizes, criteria.target),
    }


def _change(before: float, after: float) -> dict[str, float]:
    return {"before_t": before, "after_t": after, "change": _relative(before, after)}


def _relative(before: float, after: float) -> float:
    return (after - before) / before if before > 0.0 else 0.0


def _quality_entry(part: Written, name: str, limits: dict[str, float]) -> dict[str, Any]:
    before = measured(MEASURES[name], part.mesh.points, part.faces)
    after = measured(MEASURES[name], part.places, part.faces)
    worst = np.min if name in ("jacobian", "min_angle", "min_length") else np.max
    low, high = (f([before.min(initial=np.inf), after.min(initial=np.inf)]) for f in (min, min))
    high = max(float(before.max(initial=low)), float(after.max(initial=low)))
    bins = np.linspace(low, high if high > low else low + 1.0, _BINS + 1) if len(before) else None
    return {
        "measure": name,
        **limits,
        "worst_before": float(worst(before)) if len(before) else None,
        "worst_after": float(worst(after)) if len(after) else None,
        "failing_before": int(_fails(before, limits).sum()),
        "failing_after": int(_fails(after, limits).sum()),
        "largest_change": float(np.abs(after - before).max(initial=0.0)),
        "histogram": None if bins is None else {
            "edges": bins.tolist(),
            "before": np.histogram(before, bins)[0].tolist(),
            "after": np.histogram(after, bins)[0].tolist(),
        },
    }  # fmt: skip


def _fails(values: np.ndarray, limits: dict[str, float]) -> np.ndarray:
    slack = 1e-9
    low, high = limits.get("min", -np.inf), limits.get("max", np.inf)
    return (values < low - slack * abs(low)) | (values > high + slack * abs(high))


def _newly_failing(part: Written, criteria: Criteria) -> np.ndarray:
    """(m,) whether an element that met the criteria does so no more."""
    found = np.zeros(len(part.faces), dtype=bool)
    for name, limits in criteria.elements.items():
        before = _fails(measured(MEASURES[name], part.mesh.points, part.faces), limits)
        found |= _fails(measured(MEASURES[name], part.places, part.faces), limits) & ~before
    return found


def _steps(part: Written, masses: list[np.ndarray], target: float | None) -> dict[str, Any]:
    """The explicit time step in ms, and the share of mass that scaling to a target adds."""
    entry: dict[str, Any] = {"sound_m_s": part.material.sound, "target_ms": target}
    for word, points, mass in zip(("before", "after"), (part.mesh.points, part.places), masses):
        step = measured(step_length, points, part.faces) / part.material.sound
        entry[f"{word}_ms"] = float(step.min(initial=np.inf)) if len(step) else None
        added = None
        if target is not None and len(step):
            short = (step < target) & (step > 0.0)
            more = mass[short] * ((target / step[short]) ** 2 - 1.0)
            added = float(more.sum() / mass.sum()) if mass.sum() > 0.0 else 0.0
        entry[f"added_mass_{word}"] = added
    return entry


def penetrations(core: Any, one: Written, other: Written) -> dict[str, Any] | None:
    """Vertices of a part that newly come nearer to another than half of both thicknesses."""
    room = 0.5 * (one.thickness + other.thickness)
    if room <= 0.0:
        return None
    low, high = other.places.min(axis=0) - room, other.places.max(axis=0) + room
    near = np.flatnonzero(((one.places >= low) & (one.places <= high)).all(axis=1))
    if not len(near):
        return None
    before = core.PickingTree(other.mesh.points, other.mesh.triangles)
    after = core.PickingTree(other.places, other.mesh.triangles)
    count, worst = 0, 0.0
    for k in near.tolist():
        now = float(after.nearest_point(one.places[k]).distance)
        if now >= room:
            continue
        then = min(float(before.nearest_point(one.mesh.points[k]).distance), room)
        if then - now > max(0.1 * room, 4.0 * (one.width_error + other.width_error)):
            count, worst = count + 1, max(worst, room - now)
    if not count:
        return None
    return {"part": one.mesh.name, "into": other.mesh.name, "vertices": count, "depth": worst}


def digest(path: Path) -> str:
    """The SHA-256 of a file."""
    found = hashlib.sha256()
    with path.open("rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            found.update(block)
    return found.hexdigest()
