# SPDX-License-Identifier: LGPL-2.1-or-later
"""Diagnosis of meshes: properties, faults, and a cure for each; the mesh is not changed."""

from __future__ import annotations

import math
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from ..base.kernel import load_kernel
from ..base.packaged import packaged_json
from ..base.part_mesh import PartMesh
from ..files import PartFile, read_part, unpacked_name
from ..files.deck_file import DeckFile
from .advice import findings_of, for_deck, missing_findings, part_entry
from ..base.file_unit import unit_of

# Default distance below which two vertices coincide, as a share of the size.
_NEAR = 1e-6
# A sliver has a longest edge above this multiple of its height, as in the kernel. Two triangles
# fold if the cosine between their normals is below the second value.
_SLIVER, _FOLDED = 25.0, -0.9


def schema() -> dict[str, Any]:
    """Return the published JSON Schema for the output of the command `doctor`."""
    return packaged_json(__package__, "doctor.schema.json")


def diagnose_files(
    files: list[str | Path], tolerance: float | None = None, unit: str | None = None
) -> dict[str, Any]:
    """Return the diagnosis of every file, as the command `doctor` prints it.

    See diagnose() for tolerance and unit. Raises FileError, KernelError, OSError.
    """
    found = []
    for file in map(str, files):
        diagnosis = diagnose_file(read_part(file), tolerance, unit)
        name = {} if "split" in diagnosis["part"] else {"name": unpacked_name(file).stem}
        found.append(
            {"file": file, **diagnosis, "part": {**name, "file": file, **diagnosis["part"]}}
        )
    return {"sheetmorph_doctor": 1, "files": found}


def diagnose_file(
    file: PartFile, tolerance: float | None = None, unit: str | None = None
) -> dict[str, Any]:
    """Return the diagnosis of a file: its mesh, and content that the reader skipped.

    For a deck, cures that need a new mesh are left out, and the section thickness helps to guess
    the unit. Raises the errors of diagnose().
    """
    diagnosis = diagnose(file.mesh, tolerance, unit)
    if isinstance(file, DeckFile):
        thickness = file.thickness_of(np.arange(len(file.mesh.triangles))) or None
        if diagnosis["thickness"] is None and thickness is not None:
            diagnosis["unit"] = unit_of(diagnosis["size"], thickness, unit)
            diagnosis["findings"] = findings_of(diagnosis)
        diagnosis["findings"] = for_deck(diagnosis["findings"])
        diagnosis["part"] = part_entry(diagnosis["findings"])
    return {**diagnosis, "findings": missing_findings(file.missing) + diagnosis["findings"]}


def diagnose(
    mesh: PartMesh, tolerance: float | None = None, unit: str | None = None
) -> dict[str, Any]:
    """Diagnose a mesh, and propose a cure for each fault.

    Parameters
    ----------
    mesh : PartMesh
        The mesh to examine.
    tolerance : float, optional
        Distance in the unit of the mesh below which two vertices coincide; by default a millionth
        of the size of the used vertices.
    unit : str, optional
        Unit of the mesh, one of ``file_unit.UNITS``; guessed by default.

    Returns
    -------
    dict
        The diagnosis, ready for JSON; see ``doctor.schema.json``.

    Raises
    ------
    KernelError
        If the compiled kernel cannot be loaded.
    ValueError
        If the kernel refuses the tolerance (InvalidInput).
    """
    core = load_kernel()
    kernel_mesh = core.TriangleMesh(mesh.points, mesh.triangles)
    if tolerance is None:
        used = mesh.points[np.unique(mesh.triangles)] if len(mesh.triangles) else mesh.points
        tolerance = _NEAR * float(np.linalg.norm(np.ptp(used, axis=0))) if len(used) else 0.0
    found = core.diagnose(kernel_mesh, tolerance)
    thickness = _thickness(found.pieces)
    guess = unit_of(found.size, thickness, unit)
    diagnosis = {
        "vertices": len(mesh.points),
        "triangles": len(mesh.triangles),
        "size": found.size,
        "tolerance": found.tolerance,
        "kind": _kind(found.pieces),
        "thickness": thickness,
        "unit": guess,
        "edge_lengths": dict(zip(("shortest", "median", "longest"), found.edge_lengths)),
        "round_rims": _rims(found),
        "components": [_piece(piece) for piece in found.pieces],
        "counts": {
            **{name: getattr(found, name) for name in _COUNTS},
            "folded_slivers": _folded_slivers(mesh) if found.slivers else 0,
        },
        "is_one_sided": found.is_one_sided,
        "suggested_edge": _in_mm(_suggested_edge(found), guess["scale"]),
    }
    findings = findings_of(diagnosis)
    return {**diagnosis, "findings": findings, "part": part_entry(findings)}


_COUNTS = (
    "unused_vertices",
    "duplicate_vertices",
    "near_duplicate_vertices",
    "duplicate_triangles",
    "degenerate_triangles",
    "slivers",
    "flipped_triangles",
    "t_junctions",
    "open_edges",
    "open_edges_welded",
    "non_manifold_edges",
    "non_manifold_edges_welded",
)


def _folded_slivers(mesh: PartMesh) -> int:
    """Count the slivers that fold back onto a neighbour."""
    corners = mesh.points[mesh.triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    doubled = np.cross(sides[:, 0], sides[:, 1])
    twice = np.linalg.norm(doubled, axis=1)
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    is_sliver = longest**2 > _SLIVER * twice
    normals = doubled / np.maximum(twice, np.finfo(float).tiny)[:, None]
    ends = np.sort(np.stack([mesh.triangles, np.roll(mesh.triangles, -1, axis=1)], axis=2), axis=2)
    ends = ends.reshape(-1, 2)
    order = np.lexsort(ends.T)
    is_same = (ends[order[1:]] == ends[order[:-1]]).all(axis=1)
    pairs = np.column_stack([order[:-1], order[1:]])[is_same] // 3
    is_folded = np.einsum("ij,ij->i", normals[pairs[:, 0]], normals[pairs[:, 1]]) < _FOLDED
    folded = np.unique(pairs[is_folded & is_sliver[pairs].any(axis=1)])
    return int(is_sliver[folded].sum())


def _kind(pieces: list[Any]) -> str:
    kinds = {piece.kind for piece in pieces}
    found: str = kinds.pop() if len(kinds) == 1 else "mixed" if kinds else "empty"
    return found


def _piece(piece: Any) -> dict[str, Any]:
    is_thin = piece.kind == "thin solid"
    return {
        "kind": piece.kind,
        "triangles": piece.triangles,
        "area": piece.area,
        "volume": None if piece.kind == "open shell" else piece.volume,
        "is_inside_out": piece.is_inside_out,
        "thickness": piece.thickness if is_thin else None,
        "thickness_range": list(piece.thickness_range) if is_thin else None,
    }


def _thickness(pieces: list[Any]) -> float | None:
    """Return the thickness of thin solids, mm, weighted by area."""
    areas: Counter[float] = Counter()
    for piece in pieces:
        if piece.kind == "thin solid":
            areas[float(f"{piece.thickness:.2g}")] += piece.area
    if not areas:
        return None
    most = areas.most_common(1)[0][0]
    thin = [piece for piece in pieces if piece.kind == "thin solid"]
    found: float | None = min(
        (piece.thickness for piece in thin), key=lambda t: abs(float(t) - most)
    )
    return found


def _rims(found: Any) -> dict[str, Any]:
    smallest, largest = found.rim_radii
    return {
        "count": found.round_rims,
        "smallest_radius": smallest if found.round_rims else None,
        "largest_radius": largest if found.round_rims else None,
        "fewest_vertices": found.fewest_rim_vertices if found.round_rims else None,
    }


def _in_mm(length: float | None, scale: float) -> float | None:
    """Convert a length of the file to mm, as in a recipe."""
    return length and float(f"{scale * length:.6g}")


def _suggested_edge(found: Any) -> float | None:
    """Return an edge length of 1, 2, 3 or 5 times a power of ten for about 30,000 triangles."""
    area = sum(piece.area for piece in found.pieces)
    if not area > 0.0:
        return None
    wanted = max(math.sqrt(area / 13_000.0), found.size / 400.0)
    power = 10.0 ** math.floor(math.log10(wanted))
    return float(f"{max(s * power for s in (1, 2, 3, 5) if s * power <= wanted * 1.0001):.1g}")
