# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of the files of a run, compared with the rest state."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.part_mesh import PartMesh
from ..decks.materials import STEEL, Material
from ..measuring.gaps import ContactGap, Surface
from ..measuring.quality import MEASURES, areas, measured, step_length
from ..measuring.rigidity import best_turn, edge_error, feature_edges
from .criteria import Criteria

if TYPE_CHECKING:
    from .. import _core

_ROUND = 0.12
_BINS = 20


class Shape(Surface):
    """A part in one state with faces (m, 4), -1 last for triangles; it caches its measures."""

    def __init__(self, places: Floats, faces: Ints, triangles: Ints):
        super().__init__(places, triangles)
        self.faces = faces
        self._known: dict[Any, Floats] = {}

    def measured(self, measure: Callable[[Floats], Floats]) -> Floats:
        """Return a measure of the elements (m,)."""
        if measure not in self._known:
            self._known[measure] = measured(measure, self.places, self.faces)
        return self._known[measure]


@dataclass(frozen=True, eq=False)
class Sheet:
    """A part at rest, with the data of its elements and its file.

    name is that in the recipe, faces (m, 4) are the element corners, thickness is in mm and 0 if
    not given. width_error is the rounding error of a coordinate in the file, mm. material is that
    of the sheet.
    """

    name: str
    mesh: PartMesh
    faces: Ints
    thickness: float
    width_error: float
    material: Material = STEEL

    @cached_property
    def shape(self) -> Shape:
        """The part at rest."""
        return Shape(self.mesh.points, self.faces, self.mesh.triangles)


class Written:
    """A part at rest and with the positions (n, 3) read from its file."""

    def __init__(self, sheet: Sheet, places: Floats):
        self.sheet, self.mesh, self.faces = sheet, sheet.mesh, sheet.faces
        self.places, self.rest = places, sheet.shape
        self.now = Shape(places, sheet.faces, sheet.mesh.triangles)


class RestFeature:
    """A form feature at rest: its vertices, edges (e, 2) and round rims."""

    def __init__(self, core: ModuleType, sheet: Sheet, name: str, vertices: Ints):
        self._core, self._mesh = core, sheet.mesh
        self.name, self.part, self.vertices = name, sheet.name, vertices
        self.edges = feature_edges(sheet.mesh, vertices)
        self.rims = _round_rims(core, sheet.mesh, vertices)

    @cached_property
    def _form(self) -> _core.FeatureShape | None:
        found: _core.FeatureShape | None = self._core.feature_shape(
            self._mesh.points, self._mesh.triangles, self.vertices
        )
        return found

    def rest(self, size: float | None) -> Floats:
        """Return the rest positions (n, 3) of the part with the given feature size."""
        points = self._mesh.points
        if size is None or self._form is None:
            return points
        found = points.copy()
        found[self.vertices] = self._form.resized(points[self.vertices], size)
        return found


class RestContact:
    """A contact at rest: the names of its parts, and its gap."""

    def __init__(self, name: str, sheets: tuple[Sheet, Sheet], rows: tuple[Ints, Ints]):
        self.name = name
        self.parts = sheets[0].name, sheets[1].name
        self.gap = ContactGap((sheets[0].shape, sheets[1].shape), rows)


def feature_entry(
    core: ModuleType, part: Written, feature: RestFeature, size: float | None
) -> dict[str, Any]:
    """Return the worst edge error of a form feature, and its round rims before and after.

    The error is relative to the best rigid motion. size is in mm, None for the size at rest.
    """
    rest, moved, vertices = feature.rest(size), part.places, feature.vertices
    turn = best_turn(rest, moved, vertices)
    return {
        "name": feature.name,
        "part": feature.part,
        "vertices": len(vertices),
        "edge_error": edge_error(rest, moved, feature.edges, turn),
        "allowed": 4.0 * part.sheet.width_error + 1e-9 * float(np.abs(moved).max(initial=1.0)),
        "rims": [_rim_entry(core, one, moved[rim]) for rim, one in feature.rims],
    }


def _round_rims(
    core: ModuleType, mesh: PartMesh, vertices: Ints
) -> list[tuple[Ints, _core.CircleFit]]:
    """Return the round rims among the vertices, with their fitted circles."""
    inside = np.zeros(len(mesh.points), dtype=bool)
    inside[vertices] = True
    near = inside[mesh.triangles].any(axis=1)
    rows, corners = np.unique(mesh.triangles[near], return_inverse=True)
    around = core.TriangleMesh(
        mesh.points[rows], np.ascontiguousarray(corners.reshape(-1, 3), np.int32)
    )
    found = []
    for loop in core.boundary_loops(around):
        rim = rows[np.asarray(loop)]
        if len(rim) >= 6 and inside[rim].all():
            circle = core.fit_circle(mesh.points[rim])
            found += [(rim, circle)] if circle.residual <= _ROUND * circle.radius else []
    return found


def _rim_entry(core: ModuleType, one: _core.CircleFit, places: Floats) -> dict[str, float]:
    """Return diameter and roundness of a rim: the largest distance from the fitted circle."""
    two = core.fit_circle(places)
    return {
        "diameter_before": 2.0 * float(one.radius),
        "diameter_after": 2.0 * float(two.radius),
        "roundness_before": float(one.residual),
        "roundness_after": float(two.residual),
    }


def contact_entry(contact: RestContact, parts: tuple[Written, Written]) -> dict[str, Any]:
    """Return the gap of a contact before and after, and its worst change."""
    change = contact.gap.change((parts[0].now, parts[1].now))
    return {
        "name": contact.name,
        "gap_before": change.before,
        "gap_after": change.after,
        "worst_change": change.worst,
    }


def part_entry(core: ModuleType, part: Written, criteria: Criteria) -> dict[str, Any]:
    """Return quality before and after, flipped triangles, mass and time step."""
    sheet, rest, moved = part.sheet, part.mesh.points, part.places
    flipped = core.compare_quality(rest, moved, part.mesh.triangles).flipped
    weight = (sheet.thickness or 1.0) * sheet.material.density
    sizes = [shape.measured(areas) * weight for shape in (part.rest, part.now)]
    return {
        "name": part.sheet.name,
        "elements": len(part.faces),
        "largest_displacement": float(np.linalg.norm(moved - rest, axis=1).max(initial=0.0)),
        "flipped": int(flipped),
        "quality": [
            _quality_entry(part, measure, criteria.elements.get(measure, {}))
            for measure in MEASURES
        ],
        "newly_failing": int(_newly_failing(part, criteria).sum()),
        "thickness": sheet.thickness or None,
        "material": {"name": sheet.material.name, "density_t_mm3": sheet.material.density},
        "mass": None if not sheet.thickness else _change(*(float(s.sum()) for s in sizes)),
        "area_change": _relative(*(float(s.sum()) for s in sizes)),
        "time_step": _steps(part, sizes, criteria.target),
    }


def _change(before: float, after: float) -> dict[str, float]:
    return {"before_t": before, "after_t": after, "change": _relative(before, after)}


def _relative(before: float, after: float) -> float:
    return (after - before) / before if before > 0.0 else 0.0


def _quality_entry(part: Written, name: str, limits: dict[str, float]) -> dict[str, Any]:
    before, after = (shape.measured(MEASURES[name]) for shape in (part.rest, part.now))
    worst = np.min if name in ("jacobian", "min_angle", "min_length") else np.max
    return {
        "measure": name,
        **limits,
        "worst_before": float(worst(before)) if len(before) else None,
        "worst_after": float(worst(after)) if len(after) else None,
        "failing_before": int(_fails(before, limits).sum()),
        "failing_after": int(_fails(after, limits).sum()),
        "largest_change": float(np.abs(after - before).max(initial=0.0)),
        "histogram": _histogram(before, after) if len(before) else None,
    }


def _histogram(before: Floats, after: Floats) -> dict[str, Sequence[float]]:
    low = float(min(before.min(), after.min()))
    high = float(max(before.max(), after.max()))
    span = (low, high if high > low else low + 1.0)
    edges = np.linspace(*span, _BINS + 1)
    return {
        "edges": edges.tolist(),
        "before": _counts(before, edges),
        "after": _counts(after, edges),
    }


def _counts(values: Floats, edges: Floats) -> list[int]:
    """Count the values in each interval; the last one includes its upper edge."""
    before = np.searchsorted(np.sort(values), edges)
    before[-1] = len(values)
    found: list[int] = np.diff(before).tolist()
    return found


def _fails(values: Floats, limits: dict[str, float]) -> Bools:
    slack = 1e-9
    low, high = limits.get("min", -np.inf), limits.get("max", np.inf)
    return (values < low - slack * abs(low)) | (values > high + slack * abs(high))


def _newly_failing(part: Written, criteria: Criteria) -> Bools:
    """Return which elements (m,) met the criteria before and fail them now."""
    found = np.zeros(len(part.faces), dtype=bool)
    for name, limits in criteria.elements.items():
        before, after = (shape.measured(MEASURES[name]) for shape in (part.rest, part.now))
        found |= _fails(after, limits) & ~_fails(before, limits)
    return found


def _steps(part: Written, masses: list[Floats], target: float | None) -> dict[str, Any]:
    """Return the explicit time step, ms, and the share of mass that scaling to the target adds."""
    sound = part.sheet.material.sound
    entry: dict[str, Any] = {"sound_m_s": sound, "target_ms": target}
    for word, shape, mass in zip(("before", "after"), (part.rest, part.now), masses):
        step = shape.measured(step_length) / sound
        entry[f"{word}_ms"] = float(step.min(initial=np.inf)) if len(step) else None
        added = None
        if target is not None and len(step):
            short = (step < target) & (step > 0.0)
            more = mass[short] * ((target / step[short]) ** 2 - 1.0)
            added = float(more.sum() / mass.sum()) if mass.sum() > 0.0 else 0.0
        entry[f"added_mass_{word}"] = added
    return entry


def penetrations(one: Written, other: Written) -> dict[str, Any] | None:
    """Return the number of new penetrating vertices and the largest depth, or None.

    Such a vertex newly comes closer to the other part than half of both thicknesses.
    """
    room = 0.5 * (one.sheet.thickness + other.sheet.thickness)
    if room <= 0.0:
        return None
    low, high = other.places.min(axis=0) - room, other.places.max(axis=0) + room
    near = np.flatnonzero(((one.places >= low) & (one.places <= high)).all(axis=1))
    if not len(near):
        return None
    now = other.now.distances(one.places[near])
    then = np.minimum(other.rest.distances(one.mesh.points[near]), room)
    rounding = 4.0 * (one.sheet.width_error + other.sheet.width_error)
    nearer = (now < room) & (then - now > max(0.1 * room, rounding))
    if not nearer.any():
        return None
    depth = float((room - now[nearer]).max())
    names = {"part": one.sheet.name, "into": other.sheet.name}
    return {**names, "vertices": int(nearer.sum()), "depth": depth}


def digest(path: Path) -> str:
    """Return the SHA-256 of a file."""
    found = hashlib.sha256()
    with path.open("rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            found.update(block)
    return found.hexdigest()
