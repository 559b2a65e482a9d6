# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a morph: accuracy, certificate, notes and warnings."""

from __future__ import annotations

import math
import platform
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from typing import Any, TypeVar

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Caution, Subject
from ..base.packaged import packaged_json
from ..base.part_mesh import PartMesh
from ..measuring.rigidity import best_turn, edge_error, tolerance
from ..measuring.sizes import NOT_RIGID, measured_size, missed_sizes, not_rigid
from ..measuring.strain import Edge, crushed
from ..recipe.feature_entries import SymmetryEntry
from ..recipe.pose import entries_of
from ..solving.answer import Answer
from ..solving.preprocessed import Preprocessed
from ..solving.results import FeatureResult
from .cautions import unsettled, warnings_of
from .notes import notes_of, shape_notes
from .regions import region_entries
from .shapes import WrittenShapes, kink_notes, shape_failures, shape_report
from .stretch import steel_report, stretch_report
from .thin_solids import crossed, thickness_in_file, thin_failures, thin_report


Shown = TypeVar("Shown", bound=Answer)

__all__ = ["BESIDE", "NOT_RIGID", "make_report", "report_schema"]
BESIDE = "beside"
"""Code of failures of decks and joint files."""


@dataclass(frozen=True)
class WrittenPart:
    """A part's file, read back: name, stored positions (n, 3), precision and notes.

    shapes is the content of a CAD file that was written as well.
    """

    file: str
    positions: Floats
    precision: str
    notes: list[str]
    shapes: WrittenShapes | None = None


@dataclass(frozen=True)
class FilesTold:
    """Report entries of decks and of joint files; missing has a sentence for skipped content."""

    decks: list[dict[str, Any]] = field(default_factory=list)
    joint_files: list[dict[str, Any]] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)

    def texts(self, key: str) -> list[str]:
        """Return the `failures` or `notes` of all files."""
        return [text for file in (*self.decks, *self.joint_files) for text in file[key]]

    def failures(self) -> list[Caution]:
        """Return the failures of all files."""
        return [Caution(text, code=BESIDE) for text in self.texts("failures")]

    def warnings(self) -> list[Caution]:
        """Return a warning for each skipped content."""
        return [Caution(text, code="missing") for text in self.missing]


def report_schema() -> dict[str, Any]:
    """Return the published JSON Schema of the report."""
    return packaged_json(__package__, "report.schema.json")


def make_report(
    result: Answer,
    written: Mapping[str, WrittenPart] | None = None,
    timings: Mapping[str, float] | None = None,
    *,
    beside: FilesTold | None = None,
    is_brief: bool = False,
) -> dict[str, Any]:
    """Return the report of a result.

    written holds the parts as read back from their files, by name. beside holds the entries of
    decks and joint files. is_brief leaves out the stretch of the sheet and the regions.
    """
    session, files, beside = result.session, written or {}, beside or FilesTold()
    stored = as_written(result, files)
    rest = (mesh.points for mesh in session.meshes.values())
    tol = tolerance(session.size, [*rest, *result.positions.values()])
    features = _features(result, files)
    parts = [
        part_report(stored, name, files.get(name), is_brief) | _told_of_file(result, name, files)
        for name in session.parts
    ]
    warnings = [*beside.warnings(), *warnings_of(stored, parts)]
    failures = [*_torn(features, tol), *missed_sizes(features, parts, tol)]
    failures += [*thin_failures(result, tol), *unsettled(parts), *_shape_faults(parts)]
    failures += beside.failures()
    return {
        "sheetmorph_report": 1,
        "versions": _versions(session.core),
        **{"energy": session.model.energy, "operator": session.model.operator},
        "propagation": session.model.propagation.type,
        **{"primary": session.model.primary, "refine": session.model.refine},
        "symmetry": _symmetry(session.model.symmetry),
        **{"pose": entries_of(result.pose), "size": session.size, "tolerance": tol},
        "certificate": {"passed": not failures, "failures": failures},
        **{"features": features, "decks": beside.decks, "joint_files": beside.joint_files},
        **{"contacts": [asdict(contact) for contact in stored.contacts], "spread": result.spread},
        "regions": [] if is_brief else result.once("regions", partial(region_entries, session)),
        **{"parts": parts, "repairs": result.repairs},
        **{"order": session.order, "levels": session.levels, "unreached": session.unreached},
        **{"notes": [*_notes(session, parts, beside), *warnings], "warnings": warnings},
        "cautions": [warning.fault.to_json() for warning in warnings],
        "timings": {**session.timings, **(timings or {})},
        **({} if session.model.found is None else {"found": session.model.found}),
    }


def _notes(session: Preprocessed, parts: list[dict[str, Any]], beside: FilesTold) -> list[str]:
    told = [*_kinks(parts), *beside.texts("notes")]
    return [*notes_of(session), *shape_notes(parts), *told]


def warnings_in(result: Answer) -> list[Caution]:
    """Return the report's warnings for a result without files."""
    return warnings_of(result, [part_report(result, name, None, True) for name in result.positions])


def as_written(result: Shown, files: Mapping[str, WrittenPart]) -> Shown:
    """Return the answer with the positions stored in the files, or itself if they are equal."""
    stored = {name: part.positions for name, part in files.items()}
    if all(np.array_equal(result.positions[name], places) for name, places in stored.items()):
        return result
    return replace(result, positions={**result.positions, **stored})


def _shape_faults(parts: list[dict[str, Any]]) -> list[Caution]:
    """Return everything in written CAD files that misses the requirements."""
    return [
        Caution(text, Subject("part", part["name"]), code="shape")
        for part in parts
        if part["shape"] is not None
        for text in shape_failures(part["name"], part["shape"], part["quality"]["flipped"])
    ]


def _kinks(parts: list[dict[str, Any]]) -> list[str]:
    return [
        text
        for part in parts
        if part["shape"] is not None
        for text in kink_notes(part["name"], part["shape"])
    ]


def _symmetry(plane: SymmetryEntry | None) -> dict[str, list[float]] | None:
    return None if plane is None else {"point": [*plane.point], "normal": [*plane.normal]}


def _torn(features: list[dict[str, Any]], tol: float) -> list[Caution]:
    """Return a failure for every feature whose error exceeds the tolerance, mm."""
    return [
        not_rigid(entry["name"], entry["part"], f"{_worst_error(entry):.3g} mm")
        for entry in features
        if not _worst_error(entry) <= tol
    ]


def _worst_error(feature: Mapping[str, Any]) -> float:
    found: float = max(feature["edge_error"], feature["outline_error"] or 0.0)
    return found


def rigidity(feature: Mapping[str, Any]) -> float:
    """Return the edge error of a feature, mm: from the written file if there is one."""
    written: float | None = feature["file_edge_error"]
    return float(feature["edge_error"] if written is None else written)


def _features(result: Answer, files: Mapping[str, WrittenPart]) -> list[dict[str, Any]]:
    session = result.session
    rests = {part: session.rest_of(part, result.features) for part in session.parts}
    return [_feature(result, feature, files, rests) for feature in result.features]


def _feature(
    result: Answer,
    feature: FeatureResult,
    files: Mapping[str, WrittenPart],
    rests: Mapping[str, Floats],
) -> dict[str, Any]:
    vertices = result.session.feature_vertices(feature.name)
    edges = result.session.feature_edges(feature.name)
    rest, written = rests[feature.part], files.get(feature.part)

    def in_mesh() -> float:
        return edge_error(rest, result.positions[feature.part], edges, feature.rotation)

    def in_file(file: WrittenPart) -> float:
        return edge_error(rest, file.positions, edges, best_turn(rest, file.positions, vertices))

    positions = result.positions[feature.part] if written is None else written.positions
    shape = positions, result.session.meshes[feature.part].triangles, vertices
    return {
        "name": feature.name,
        "part": feature.part,
        "vertices": len(vertices),
        "edge_error": result.once(("edge error", feature.name), in_mesh),
        "file_edge_error": None if written is None else in_file(written),
        "rotation_type": feature.rotation_type,
        "motion": feature.motion,
        "kind": feature.kind,
        "size": feature.size,
        "measured_size": None if feature.size is None else measured_size(*shape),
        "outline_error": feature.outline_error,
        "rotation": feature.rotation.tolist(),
        "translation": feature.translation.tolist(),
        "centre": feature.centre.tolist(),
    }


def part_report(
    result: Answer, name: str, written: WrittenPart | None = None, is_brief: bool = False
) -> dict[str, Any]:
    """Return the report entry of a part without its file; is_brief leaves out the stretch."""
    mesh = result.session.meshes[name]
    positions = result.positions[name]
    report = {
        "name": name,
        "vertices": len(mesh.points),
        "triangles": len(mesh.triangles),
        "is_reached": name not in result.session.unreached,
        "largest_displacement": _largest_distance(mesh.points, positions),
        **result.once((name, is_brief), lambda: _measured(result, name, is_brief)),
        "preparation": mesh.preparation,
        "unsettled": result.unsettled.get(name),
        "file": None,
        "shape": None,
    }
    writing = next(part.write for part in result.session.model.parts if part.name == name)
    if writing is not None:
        shapes = None if written is None else written.shapes
        report["shape"] = shape_report(
            writing, crossed(result, name), shapes, partial(thickness_in_file, result, name)
        )
    return report


def _told_of_file(
    result: Answer, part: str, files: Mapping[str, WrittenPart]
) -> dict[str, dict[str, Any] | None]:
    """Return the entry "file" of a part; result has the expected positions."""
    if part not in files:
        return {"file": None}
    written = files[part]
    told = {
        "name": written.file,
        "precision": written.precision,
        "error": _largest_distance(written.positions, result.positions[part]),
        "notes": written.notes,
    }
    return {"file": told}


def _measured(result: Answer, part: str, is_brief: bool) -> dict[str, Any]:
    """Return the report entries of a part that do not depend on its file."""
    return {
        "quality": _quality(result, part),
        "stretch": None if is_brief else stretch_report(result, part),
        "steel": steel_report(result.session, part),
        "thin": thin_report(result, part),
    }


def _largest_distance(a: Floats, b: Floats) -> float:
    return float(np.linalg.norm(a - b, axis=1).max(initial=0.0))


def _quality(result: Answer, part: str) -> dict[str, Any]:
    core, mesh = result.session.core, result.session.meshes[part]
    positions, edges = result.positions[part], result.session.edge_changes(part)
    change = core.compare_quality(mesh.points, positions, mesh.triangles)
    worst = edges.worst(positions, result.rest.positions[part])
    return {
        "before": _shape_of(core.quality(mesh.points, mesh.triangles)),
        "after": _shape_of(change),
        "flipped": int(change.flipped),
        "flipped_place": _middle_of_first(mesh, positions, change.flipped_triangles),
        "crushed_place": _middle_of_first(mesh, positions, crushed(mesh, positions)),
        "worst_strain": None if worst is None else worst.strain,
        "worst_edge": _edge_entry(worst),
        "collapsed_edges": edges.collapsed(positions),
        "shortest_edge": _edge_entry(edges.shortest(positions)),
        "worst_fold_degrees": edges.worst_fold(positions),
    }


def _middle_of_first(mesh: PartMesh, positions: Floats, triangles: Ints) -> list[float] | None:
    """Return the centroid of the first of some triangles, or None."""
    if not len(triangles):
        return None
    found: list[float] = positions[mesh.triangles[triangles[0]]].mean(axis=0).tolist()
    return found


def _edge_entry(edge: Edge | None) -> dict[str, Any] | None:
    if edge is None:
        return None
    return {"before": edge.before, "after": edge.after, "place": edge.place.tolist()}


def _shape_of(found: Any) -> dict[str, Any]:
    values = {
        "worst_angle_degrees": float(found.worst_angle_degrees),
        "worst_aspect": float(found.worst_aspect),
    }
    # A mesh of degenerate triangles has no such value, and JSON has neither infinity nor NaN.
    measured = {key: value if math.isfinite(value) else None for key, value in values.items()}
    return {**measured, "degenerate": int(found.degenerate)}


def _versions(core: Any) -> dict[str, str]:
    kernel = {key: str(value) for key, value in core.abi_info().items()}
    return {**kernel, "python": platform.python_version(), "numpy": np.__version__}
