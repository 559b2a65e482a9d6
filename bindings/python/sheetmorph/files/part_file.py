# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interface of all file formats: a mesh, and the same file with other coordinates."""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import InputError
from ..base.part_mesh import PartMesh
from .atomic import FileSet


class PartFile(ABC):
    """A part with its file.

    Attributes
    ----------
    path : Path
        The file that was read.
    mesh : PartMesh
        The mesh of the part.
    precision : str
        Number format of a coordinate: "double", "float32", "8 characters" or "16 characters".
    notes : list of str
        Remarks for the report.
    missing : list of str
        A sentence for content that the mesh lacks or that the file seems to have lost.
    properties : array (m,) or None
        Property id of every triangle of a deck.
    property_names : dict
        Property id to part name, if the format has names.
    bodies : dict or None
        Body name to triangle indices (k,), for CAD files.
    origin : Path
        The file of the user; it differs from path if the file was unpacked.
    unpacked_in : TemporaryDirectory or None
        Folder of the unpacked copy.
    is_wide : bool
        Write numbers in the longest fields of the format.
    stem : str
        Name of the output file without suffix.
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
        """Name of the file that a run writes."""
        return f"{self.stem}{self.path.suffix}"

    @property
    def files_read(self) -> list[Path]:
        """All files that belong to the input."""
        return [self.origin]

    def targets(self, folder: Path) -> list[Path]:
        """Return all files that a run writes into a folder.

        Parameters
        ----------
        folder : Path
            The output folder.

        Returns
        -------
        list of Path
            The files.
        """
        return [folder / self.output_name]

    def thickness_of(self, _rows: Ints) -> float:
        """Return the thickness that the file gives some triangles, mm.

        Parameters
        ----------
        _rows : array (k,), int
            The triangles.

        Returns
        -------
        float
            The thickness, 0 if the file has none.
        """
        return 0.0

    def told(self, positions: Floats) -> dict[str, Any] | None:
        """Return the report entry on content besides the mesh.

        Parameters
        ----------
        positions : array (n, 3)
            Vertices, mm.

        Returns
        -------
        dict or None
            The entry; its ``failures`` are reasons not to write the file. None if there is only the
            mesh.
        """
        self._checked(positions)
        return None

    @abstractmethod
    def save(self, path: Path, positions: Floats) -> None:
        """Write the file directly to `path`.

        Parameters
        ----------
        path : Path
            The output file.
        positions : array (n, 3)
            Vertices, mm.
        """

    @abstractmethod
    def stored_positions(self, path: Path) -> Floats:
        """Read back a file that save() wrote.

        Parameters
        ----------
        path : Path
            The written file.

        Returns
        -------
        array (n, 3)
            Positions of the vertices of ``mesh``, mm.
        """

    def write(self, path: str | Path, positions: Floats, *, force: bool = False) -> None:
        """Write the deformed part; the file appears complete or not at all.

        Parameters
        ----------
        path : str or path
            The output file.
        positions : array (n, 3), float64
            Vertices of ``mesh``, mm.
        force : bool
            Overwrite a file that SheetMorph did not write.

        Raises
        ------
        ValueError
            For another shape or non-finite numbers.
        FileError, OSError
            If the file cannot be written.
        """
        with FileSet(force=force) as files:
            self.write_into(files, Path(path), positions)
            files.commit()

    def write_into(self, files: FileSet, path: Path, positions: Floats) -> Path:
        """Write the part as write() does; the file gets its name when `files` commits.

        Parameters
        ----------
        files : FileSet
            The set of files.
        path : Path
            The output file.
        positions : array (n, 3), float64
            Vertices of ``mesh``, mm.

        Returns
        -------
        Path
            The temporary file.
        """
        checked = self._checked(positions)
        temporary = files.temporary_for(path)
        with files.named(temporary):
            self.save(temporary, checked)
        return temporary

    def read_back_error(self, path: str | Path, positions: Floats) -> float:
        """Return the largest distance between positions and those in a file.

        Parameters
        ----------
        path : str or path
            The written file.
        positions : array (n, 3)
            Vertices, mm.

        Returns
        -------
        float
            The distance, mm.
        """
        stored = self.stored_positions(Path(path))
        return float(np.linalg.norm(stored - self._checked(positions), axis=1).max(initial=0.0))

    def _checked(self, positions: Floats) -> Floats:
        array = np.asarray(positions, dtype=np.float64)
        if array.shape != self.mesh.points.shape:
            what = f"positions must be {self.mesh.points.shape}, not {array.shape}"
            raise InputError(what, "give a position for each vertex")
        if not np.isfinite(array).all():
            raise InputError("a position is not a finite number", "nothing was written")
        return array
