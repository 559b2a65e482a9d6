# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every file format offers: a mesh, and the same file again with other coordinates."""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from ..arrays import Floats, Ints
from ..part_mesh import PartMesh
from .atomic import FileSet


class PartFile(ABC):
    """A part as it stands in a file.

    path; mesh: PartMesh; precision: how the file stores a coordinate ("double", "float32", "8
    characters", "16 characters"); notes: what a user should know, for the report; missing: a
    sentence for everything that stands in the file and not in the mesh, or that the file seems to
    have lost; properties: (m,) property id of every triangle of a deck, None for other formats;
    property_names: by which parts of properties are called, where the format calls them by name;
    bodies: (k,) indices of the triangles of every part of a CAD file by name, None for other
    formats; origin: the file of the user, another than path where it was unpacked into the folder
    unpacked_in; is_wide: numbers get the longest fields that the format has; stem: of the file
    that a run writes.
    """

    def __init__(self, path: Path, mesh: PartMesh, precision: str = "double"):
        self.path = path
        self.origin = path
        self.unpacked_in: TemporaryDirectory[str] | None = None
        self.mesh = mesh
        self.precision = precision
        self.notes: list[str] = []
        self.missing: list[str] = []
        self.properties: Ints | None = None
        self.property_names: dict[int, str] = {}
        self.bodies: dict[str, Ints] | None = None
        self.is_wide = False
        self.stem = path.stem

    @property
    def output_name(self) -> str:
        """The name of the file that a run writes."""
        return f"{self.stem}{self.path.suffix}"

    @property
    def files_read(self) -> list[Path]:
        """All files that it was read from."""
        return [self.origin]

    def targets(self, folder: Path) -> list[Path]:
        """All files that a run writes into a folder."""
        return [folder / self.output_name]

    def thickness_of(self, _rows: Ints) -> float:
        """What the file says of how thick some of its triangles (k,) are, mm; 0: nothing."""
        return 0.0

    def told(self, positions: Floats) -> dict[str, Any] | None:
        """For the report, what else than its mesh moves, holds or stays with its vertices at (n, 3)
        positions; None if there is nothing else in it. ``failures`` are reasons not to write it."""
        self._checked(positions)
        return None

    @abstractmethod
    def save(self, path: Path, positions: Floats) -> None:
        """Write the file with its vertices at (n, 3) positions, straight to `path`."""

    @abstractmethod
    def stored_positions(self, path: Path) -> Floats:
        """Read `path`, a file written by save(), again: (n, 3) positions of the same vertices."""

    def write(self, path: str | Path, positions: Floats, *, force: bool = False) -> None:
        """Write the deformed part beside `path`, then rename: never a half file.

        positions: (n, 3) float64, mm, one row a vertex of ``mesh``; force: over a file that
        SheetMorph did not write, too. Raises ValueError for another shape or numbers that are not
        finite, FileError, OSError.
        """
        with FileSet(force=force) as files:
            self.write_into(files, Path(path), positions)
            files.commit()

    def write_into(self, files: FileSet, path: Path, positions: Floats) -> Path:
        """As write(), but named `path` only when `files` commits; returns the temporary's path."""
        checked = self._checked(positions)
        temporary = files.temporary_for(path)
        with files.named(temporary):
            self.save(temporary, checked)
        return temporary

    def read_back_error(self, path: str | Path, positions: Floats) -> float:
        """Largest distance (mm) between (n, 3) positions and what the file at `path` holds."""
        stored = self.stored_positions(Path(path))
        return float(np.linalg.norm(stored - self._checked(positions), axis=1).max(initial=0.0))

    def _checked(self, positions: Floats) -> Floats:
        array = np.asarray(positions, dtype=np.float64)
        if array.shape != self.mesh.points.shape:
            raise ValueError(f"positions must be {self.mesh.points.shape}, not {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError("a position is not a finite number; nothing was written")
        return array
