# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP, IGES and BREP, meshed by the kernel; what was deformed is written as OBJ."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import FileError
from ..base.labels import CadFace, Labels
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..base.words import counted
from ..cad import read_brep
from ..cad import read_cad as read_model
from .obj import ObjFile
from .part_file import PartFile
from .text import LARGEST, read_bytes

CAD_SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")


class CadFile(PartFile):
    """A CAD file as one mesh of all its solids and free shells, one after the other.

    bodies: (k,) indices of the triangles of each, by its name in the file; model: the kernel's
    CadModel, with the surface under every triangle.
    """

    def __init__(
        self,
        path: Path,
        meshing: Mapping[str, float] | None = None,
        progress: Progress | None = None,
    ):
        self.model = _read(path, meshing or {}, progress)
        parts = self.model.parts
        first = np.cumsum([0, *(len(part.points) for part in parts)])
        points = np.concatenate([part.points for part in parts])
        triangles = np.concatenate([part.triangles + first[k] for k, part in enumerate(parts)])
        super().__init__(path, PartMesh(points, triangles, name=path.stem, labels=_labels(parts)))
        ends = np.cumsum([0, *(len(part.triangles) for part in parts)])
        self.bodies = {p.name: np.arange(ends[k], ends[k + 1]) for k, p in enumerate(parts)}
        self.notes += _notes(self.model)
        self.missing += _missing(self.model)

    @property
    def output_name(self) -> str:
        """The OBJ file of the same name: a CAD file cannot hold the deformed mesh."""
        return f"{self.stem}.obj"

    def save(self, path: Path, positions: Floats) -> None:
        vertices = [f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist()]
        lines: list[str] = []
        for part, others in zip(self.model.parts, self._other_lines):
            lines += [others[0], *vertices[: len(part.points)], *others[1:]]
            del vertices[: len(part.points)]
        path.write_text("\n".join(lines) + "\n", "utf-8")

    def stored_positions(self, path: Path) -> Floats:
        # The file is what was written, so nothing but its numbers has to be understood again.
        lines = read_bytes(path).decode("utf-8").splitlines()
        numbers = " ".join(line[2:] for line in lines if line.startswith("v ")).split()
        others = [line for line in lines if not line.startswith("v ")]
        if others == list(chain(*self._other_lines)) and len(numbers) == self.mesh.points.size:
            values = np.array(list(map(float, numbers))).reshape(-1, 3)
            if (np.abs(values) <= LARGEST).all():
                return values
        return ObjFile.read(path).mesh.points

    @cached_property
    def _other_lines(self) -> list[list[str]]:
        """The lines of every body in its OBJ that are no vertices: its name, and its faces."""
        found, first = [], 1
        for part in self.model.parts:
            faces = [f"f {a} {b} {c}" for a, b, c in (part.triangles + first).tolist()]
            found.append([f"o {' '.join(part.name.split())}", *faces])
            first += len(part.points)
        return found


def read_cad(
    path: Path, meshing: Mapping[str, float] | None = None, progress: Progress | None = None
) -> CadFile:
    """The parts of a CAD file. Raises FileError.

    meshing: `edge` and `deflection` in mm, `angle` in degrees; what is left out follows from the
    size of what is in the file; progress(fraction, task) may return False to cancel (RuntimeError).
    """
    return CadFile(path, meshing, progress)


def read_shape(text: str, name: str, meshing: Mapping[str, float] | None = None) -> Any:
    """The kernel's CadModel of one shape as the text of a BREP file. Raises ValueError."""
    return read_brep(text, name, _sizes(meshing or {}))


def part_meshes(model: Any) -> list[PartMesh]:
    """The meshes of a CadModel, one a solid or free shell, under its name."""
    return [
        PartMesh(part.points, part.triangles, name=part.name, labels=_labels([part]))
        for part in model.parts
    ]


def exact_features(part: Any) -> list[dict[str, Any]]:
    """The features of a CadPart from its surfaces: kind, center, axis, residual, vertices (indices
    of the part) and, where the kind has them, radius, length, angle (radians), hollow."""
    return [_feature(found) for found in part.features()]


def _feature(found: Any) -> dict[str, Any]:
    entry = {"kind": found.kind, "center": found.center.tolist(), "axis": found.axis.tolist()}
    if found.radius > 0.0:
        entry["radius"] = found.radius
    if found.kind in ("cylinder", "cone"):
        entry["length"] = found.length
    if found.kind == "cone":
        entry["angle"] = found.half_angle
    if found.kind in ("cylinder", "cone", "sphere"):
        entry["hollow"] = found.is_hollow
    return {**entry, "residual": found.residual, "vertices": found.vertices.tolist()}


def _labels(parts: list[Any]) -> Labels:
    """The CAD face of every triangle; solids, and names and colours of faces, as groups."""
    faces: list[CadFace] = []
    numbers = []
    for part in parts:
        numbers.append(part.face_of_triangle + len(faces))
        faces += [
            CadFace(part.name, k + 1, surface.kind, surface.name, surface.colour)
            for k, surface in enumerate(part.surfaces)
        ]
    face = np.concatenate(numbers)
    called: dict[str, list[int]] = {}
    for k, one in enumerate(faces):
        for name in filter(None, (f"solid {one.body}", one.name and f"face {one.name}")):
            called.setdefault(name, []).append(k)
        if one.colour:
            called.setdefault(f"colour {one.colour}", []).append(k)
    groups = {name: np.flatnonzero(np.isin(face, wanted)) for name, wanted in called.items()}
    return Labels(groups, face=face, faces=tuple(faces))


def _sizes(meshing: Mapping[str, float]) -> dict[str, float]:
    """The same for the kernel, which counts in radians."""
    sizes = {key: float(value) for key, value in meshing.items()}
    return {**sizes, "angle": math.radians(sizes["angle"])} if "angle" in sizes else sizes


def _read(path: Path, meshing: Mapping[str, float], progress: Progress | None) -> Any:
    if path.stat().st_size == 0:
        raise FileError(path, "the file is empty", "export it again")
    try:
        return read_model(str(path.absolute()), _sizes(meshing), progress)
    except ValueError as error:
        raise FileError.of(path, error, "export it again") from None


def _notes(model: Any) -> list[str]:
    deviation = max(part.deviation for part in model.parts)
    angle = math.degrees(model.angle)
    notes = [
        f"meshed with edges up to {model.edge:.6g} mm, deflection "
        f"{model.deflection:.6g} mm and angle {angle:.4g} degrees; at most "
        f"{deviation:.2g} mm from the CAD surfaces"
    ]
    for part in model.parts:
        if part.healed:
            why, within = "; ".join(part.healed), part.healed_within
            notes.append(
                f"{part.name} was not a valid shape; it was healed within {within:.2g} "
                f"mm: {why}"
            )
        if part.faults:
            faults = "; ".join(part.faults)
            notes.append(
                f"{part.name} is not a valid shape, so it is not written as a CAD file: "
                f"{faults}"
            )
        if part.unsettled:
            notes.append(f"{part.name}: {part.unsettled}")
    return notes


def _missing(model: Any) -> list[str]:
    """What the file holds and the meshes lack."""
    missing = []
    if model.unread:
        entities = counted(len(model.unread), "entity", "entities")
        missing.append(
            f"OpenCASCADE cannot read the values of {entities} of the file (the first is "
            f"{model.unread[0]}); export it again"
        )
    if model.lost_faces:
        faces = counted(model.lost_faces, "face of the file is", "faces of the file are")
        where = f", of {', '.join(model.lost_in)}" if model.lost_in else ""
        missing.append(
            f"{faces} missing{where}: OpenCASCADE cannot read them; export the file again"
        )
    for part in model.parts:
        if part.skipped_faces:
            faces = ", ".join(str(face) for face in part.skipped_faces)
            missing.append(f"faces {faces} of {part.name} are broken and were skipped")
    return missing
