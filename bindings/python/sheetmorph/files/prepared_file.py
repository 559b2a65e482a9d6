# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file whose mesh was scaled, merged or remeshed; the prepared mesh is written as OBJ."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.kernel import load_kernel
from ..base.progress import Progress
from ..base.words import preparation
from .obj import ObjFile
from .part_file import PartFile
from .prepared_mesh import Wanted, prepared_mesh


class PreparedFile(PartFile):
    """A part after its preparation; see PreparedMesh. Raises ValueError, KernelError.

    Properties and bodies of the source file are transferred to the new triangles.
    """

    def __init__(self, file: PartFile, wanted: Wanted, progress: Progress | None = None):
        mesh, triangle_of = prepared_mesh(load_kernel(), file.mesh, wanted, progress)
        super().__init__(file.path, mesh)
        self.origin, self.unpacked_in = file.origin, file.unpacked_in
        self.notes = [*file.notes, *_notes(mesh.preparation or {})]
        self.missing = list(file.missing)
        if file.properties is not None:
            self.properties = file.properties[triangle_of]
        if file.bodies is not None:
            self.bodies = {
                name: np.flatnonzero(np.isin(triangle_of, rows))
                for name, rows in file.bodies.items()
            }

    @property
    def output_name(self) -> str:
        """The OBJ file of the same name, which stores doubles and the new vertices."""
        return f"{self.stem}.obj"

    def save(self, path: Path, positions: Floats) -> None:
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in positions.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (self.mesh.triangles + 1).tolist()]
        path.write_text("\n".join(lines) + "\n", "utf-8")

    def stored_positions(self, path: Path) -> Floats:
        return ObjFile.read(path).mesh.points


def _notes(done: dict[str, Any]) -> list[str]:
    notes = [f"prepared: {preparation(done)}"]
    fresh = done["remesh"]
    if fresh:
        notes.append(
            f"remeshed with edges of {fresh['edge']:.6g} mm, at most {fresh['deviation']:.2g} mm "
            f"from the facets of the file ({fresh['flat_deviation']:.2g} mm on flats)"
        )
    if fresh and fresh["least_edge"]:
        notes.append(
            f"edges on bends and next to rims were kept above {fresh['least_edge']:.2g} mm to "
            "limit the size of the mesh; remesh with a shorter edge for finer ones"
        )
    if done["unsettled"]:
        notes.append(done["unsettled"])
    if done["scale"] != 1.0:
        notes.insert(0, f"coordinates times {done['scale']:.6g}: they are in mm now")
    return notes
