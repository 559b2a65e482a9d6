# SPDX-License-Identifier: LGPL-2.1-or-later
"""The content of a CAD file, as the CAD worker meshes it."""

from __future__ import annotations

import os
import struct
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.progress import Progress
from .worker import Worker


@dataclass(frozen=True)
class CadSurface:
    """The surface under a face, as the file has it; lengths in mm.

    kind: plane, cylinder, cone, sphere, torus or other; point: (3,) on a plane, on the axis, a
    cone's apex, a centre; axis: (3,) of length 1, a plane's normal; radius: of a torus, the circle
    of centres; minor_radius: of a torus' tube; half_angle: of a cone, radians; fit_error: 0, or how
    well a spline surface is of this kind; name, colour ("#rrggbb"): of the face, empty if none.
    """

    kind: str
    point: Floats
    axis: Floats
    radius: float
    minor_radius: float
    half_angle: float
    fit_error: float
    name: str
    colour: str


@dataclass(frozen=True)
class CadFeature:
    """Faces of a part that are one shape, from their surfaces.

    kind: round hole, cylinder, plane, cone or sphere; center: (3,) mm, of a hole, cylinder or cone
    on the axis, halfway along it; axis: (3,) of length 1; radius: mm, 0 for a plane and a cone;
    half_angle: of a cone, radians; length: along the axis, mm; is_hollow: curved, and seen from
    inside; vertices: (k,) int32, ascending; residual: largest distance of a vertex from the
    surface, mm.
    """

    kind: str
    center: Floats
    axis: Floats
    radius: float
    half_angle: float
    length: float
    is_hollow: bool
    vertices: Ints
    residual: float


@dataclass(frozen=True)
class CadPart:
    """One solid or free shell of a CAD file, meshed; its arrays are read-only.

    points: (n, 3) mm; triangles: (m, 3) int32; face_of_triangle: (m,) int32, index into
    ``surfaces``; deviation: largest distance found between mesh and surfaces, mm; skipped_faces:
    those that were not meshed; faults: why its shape is not valid, a few words each; healed: the
    same before it was healed; healed_within: how far that moved anything, mm; unsettled: empty, or
    that the meshing of a face did not end, and how far it got.
    """

    name: str
    points: Floats
    triangles: Ints
    face_of_triangle: Ints
    surfaces: list[CadSurface]
    found_features: list[CadFeature]
    is_closed: bool
    deviation: float
    skipped_faces: list[int]
    faults: list[str]
    healed: list[str]
    healed_within: float
    unsettled: str

    def features(self) -> list[CadFeature]:
        """The features, holes first."""
        return list(self.found_features)


class CadModel:
    """The parts of a CAD file, in mm, and the worker that holds its shapes.

    parts; edge, deflection (mm), angle (radians): sizes of the mesh; lost_faces: number of faces
    that OpenCASCADE could not build, missing in the parts; lost_in: solids of a STEP file with such
    faces; unread: entities of a STEP file with invalid values, each with its number and the reason.
    """

    def __init__(
        self,
        doing: str,
        request: Sequence[bytes],
        progress: Progress | None = None,
        file: Path | None = None,
    ):
        self._doing, self._request, self._file = doing, list(request), file
        # A worker that reads the shapes again must see the same file.
        self._content = b"" if file is None else file.read_bytes()
        self._worker = Worker()
        answer, _ = self._worker.request(doing, self._request, progress)
        self.parts = [_part(entry) for entry in answer["parts"]]
        self.edge: float = answer["edge"]
        self.deflection: float = answer["deflection"]
        self.angle: float = answer["angle"]
        self.lost_faces: int = answer["lost_faces"]
        self.lost_in: list[str] = answer["lost_in"]
        self.unread: list[str] = answer["unread"]

    def kept_mesh(self, part: int) -> bytes:
        """Return the data from which kept_model restores the mesh of a part."""
        return self._of_part("kept_mesh", part)

    def brep(self, part: int) -> str:
        """Return the shape of a part at rest as the text of a BREP file."""
        return self._of_part("brep", part).decode()

    def write(
        self, request: Sequence[bytes], progress: Progress | None = None
    ) -> list[dict[str, Any]]:
        """Write a file and return a dict of measures for each part; see write_cad."""
        answer, _ = self._ready().request("wrote the shapes", request, progress)
        return [_measures(body) for body in answer["bodies"]]

    def _of_part(self, request: str, part: int) -> bytes:
        if not 0 <= part < len(self.parts):
            raise IndexError(f"there is no part {part}")
        number = struct.pack("=i", part)
        name = self.parts[part].name
        return self._ready().request(f"kept '{name}'", [request.encode(), number])[1]

    def _ready(self) -> Worker:
        """Return a worker with the shapes; a new one reads them again if the first has ended."""
        if not self._worker.is_alive:
            self._worker = self._read_again()._worker
        return self._worker

    def _read_again(self) -> CadModel:
        if self._file is None:
            return CadModel(self._doing, self._request)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, self._file.name)
            path.write_bytes(self._content)
            request = [self._request[0], os.fsencode(path), *self._request[2:]]
            return CadModel(self._doing, request)


def _part(answer: dict[str, Any]) -> CadPart:
    surfaces = [CadSurface(**_with_vectors(one, "point", "axis")) for one in answer["surfaces"]]
    features = [
        CadFeature(**_with_vectors(one, "center", "axis")) for one in answer["found_features"]
    ]
    entries: dict[str, Any] = {**answer, "surfaces": surfaces, "found_features": features}
    return CadPart(**entries)


def _with_vectors(answer: dict[str, Any], *names: str) -> dict[str, Any]:
    return {**answer, **{name: np.array(answer[name]) for name in names}}


def _measures(answer: dict[str, Any]) -> dict[str, Any]:
    """Return the measures of a body, its places as arrays and its cylinders as tuples."""
    places = {key: _with_vectors(answer[key], "place") for key in ("gap", "distance", "kink")}
    return {**answer, **places, "cylinders": [tuple(one) for one in answer["cylinders"]]}
