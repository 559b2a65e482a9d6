# SPDX-License-Identifier: LGPL-2.1-or-later
"""A CAD file written once more, its shapes carried to where their meshes are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import FileError
from ..base.progress import Progress
from ..cad import write_cad
from .cad_file import CadFile
from .part_file import PartFile

_ENDINGS = {
    "step": (".step", ".stp"),
    "iges": (".iges", ".igs"),
    "brep": (".brep", ".brp"),
}


@dataclass(frozen=True)
class CadWriting:
    """How shapes are written. format: "step", "iges", "brep"; tolerance: of faces from the deformed
    mesh; edge_tolerance: between edges and their faces; both mm."""

    format: str
    tolerance: float = 0.01
    edge_tolerance: float = 0.0005

    def name_for(self, file: PartFile) -> str:
        """The file's own name if it has this format, else with the ending of this format."""
        endings = _ENDINGS[self.format]
        own = file.path.suffix.lower() in endings
        return file.stem + (file.path.suffix if own else endings[0])


def write_shapes(
    file: CadFile,
    path: Path,
    positions: Floats,
    writing: CadWriting,
    *,
    progress: Progress | None = None,
) -> list[dict[str, Any]]:
    """Write the file's shapes at (n, 3) positions of its mesh; what `path` holds then, read again.

    One dict a body, in the file's order: see the kernel's write_cad. Raises FileError where the
    shapes cannot be carried, RuntimeError of the kernel.
    """
    ends = np.cumsum([len(part.points) for part in file.model.parts])
    of_bodies = np.split(positions, ends[:-1])
    return write_model(file.model, path, of_bodies, writing, progress=progress)


def write_model(
    model: Any,
    path: Path,
    positions: Sequence[Floats],
    writing: CadWriting,
    *,
    progress: Progress | None = None,
) -> list[dict[str, Any]]:
    """The same for a CadModel of the kernel with positions (n, 3) of each of its parts."""
    wanted = {
        "format": writing.format,
        "tolerance": writing.tolerance,
        "edge_tolerance": writing.edge_tolerance,
    }
    arrays = [np.ascontiguousarray(one, dtype=np.float64) for one in positions]
    try:
        return write_cad(model, arrays, str(path.absolute()), wanted, progress=progress)
    except ValueError as error:
        raise FileError.of(path, error, "check the part") from None
