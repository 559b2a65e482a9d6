# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK, VTU and other formats through meshio."""

from __future__ import annotations

import contextlib
import copy
import io
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import FileError, InputError
from ..base.foreign_meshes import faces_of_meshio, in_space
from ..base.part_mesh import PartMesh
from .part_file import PartFile
from ..base.polygons import SPLIT_IT, triangulate
from .text import check_points, read_bytes

# Single-file formats whose coordinates meshio reads and writes without loss.
SUFFIXES = {
    ".vtk": "vtk",
    ".vtu": "vtu",
    ".avs": "avsucd",
    ".mesh": "medit",
}
_VTK_CELLS = re.compile(rb"^CELL_TYPES[ \t]+(\d+)", re.MULTILINE)


class MeshioFile(PartFile):
    """A file that meshio reads and writes as a whole: data arrays are kept, comments are not."""

    def __init__(self, path: Path):
        self._mesh = _read(path)
        points = np.asarray(self._mesh.points)
        precision = "float32" if points.dtype == np.float32 else "double"
        try:
            space, faces = in_space(points), faces_of_meshio(self._mesh.cells)
        except InputError as error:
            raise FileError.of(path, error) from None
        super().__init__(path, _part_mesh(path, space, faces), precision)
        if path.suffix.lower() == ".mesh" and not read_bytes(path).rstrip().endswith(b"End"):
            self.missing.append("the closing End is missing: check that the file is complete")
        self.notes.append(
            "written through meshio, which drops comments and sections that it does not know"
        )

    def save(self, path: Path, positions: Floats) -> None:
        import meshio

        kind = np.float32 if self.precision == "float32" else np.float64
        changed = copy.copy(self._mesh)
        changed.points = positions.astype(kind)
        form, options = _form(self.path)
        try:
            with _quiet():
                meshio.write(path, changed, file_format=form, **options)
        except Exception as error:  # meshio's writers raise errors of any type
            what = f"meshio cannot write it ({_reason(error)})"
            raise FileError(self.path, what, "convert the part to VTU or PLY") from error
        if form == "vtu" and not options["binary"]:
            _write_all_digits(path, changed.points)

    def stored_positions(self, path: Path) -> Floats:
        points = MeshioFile(path).mesh.points
        if points.shape != self.mesh.points.shape:
            what = "meshio does not read back the vertices that it wrote"
            raise FileError(self.path, what, "convert the part to VTU or PLY")
        return points


def _quiet() -> contextlib.ExitStack:
    """Suppress the output of meshio, which the reader replaces by one line."""
    stack = contextlib.ExitStack()
    stack.enter_context(warnings.catch_warnings())
    # numpy only warns if a text file has other data than the promised numbers.
    warnings.filterwarnings("error", message="string or file could not be read")
    stack.enter_context(contextlib.redirect_stdout(io.StringIO()))
    stack.enter_context(contextlib.redirect_stderr(io.StringIO()))
    stack.enter_context(np.errstate(all="ignore"))
    return stack


def _reason(error: BaseException) -> str:
    text = " ".join(str(error).split())
    return (text[:100] or type(error).__name__) if not isinstance(error, SystemExit) else "corrupt"


def _read(path: Path) -> Any:
    import meshio

    data = read_bytes(path)
    try:
        with _quiet():
            mesh = meshio.read(path, file_format=SUFFIXES[path.suffix.lower()])
    # meshio raises any type and may even exit the interpreter
    except (Exception, SystemExit) as error:
        what = f"meshio cannot read it ({_reason(error)})"
        raise FileError(path, what, "check the file, or export it as VTU or PLY") from error
    wanted = _VTK_CELLS.search(data) if path.suffix.lower() == ".vtk" else None
    count = sum(len(block.data) for block in mesh.cells)
    if wanted and count != int(wanted.group(1)):
        what = f"meshio reads {count} of the {wanted.group(1).decode()} cells of the file"
        raise FileError(path, what, "copy or export it again")
    return mesh


def _part_mesh(path: Path, points: Floats, faces: list[list[int]]) -> PartMesh:
    check_points(path, points)
    numbers = [index for face in faces for index in face]
    if min(numbers) < 0 or max(numbers) >= len(points) or min(map(len, faces)) < 3:
        raise FileError(path, "a cell names vertices that do not exist", "export it again")

    def refusal(number: int, what: str) -> FileError:
        return FileError(path, f"cell {number}: {what}", SPLIT_IT)

    return PartMesh(points, triangulate(points, faces, refusal), name=path.stem)


def _write_all_digits(path: Path, points: Floats) -> None:
    """Rewrite the points of a text VTU, because meshio's 12 digits truncate doubles."""
    numbers = "\n".join(map(repr, points.astype(np.float64).ravel().tolist()))
    pattern = rb"(<Points>.*?<DataArray[^>]*>)[^<]*(</DataArray>)"
    text = re.sub(
        pattern,
        lambda found: found.group(1) + numbers.encode() + found.group(2),
        path.read_bytes(),
        count=1,
        flags=re.DOTALL,
    )
    path.write_bytes(text)


def _form(path: Path) -> tuple[str, dict[str, bool]]:
    """Return meshio's format name, and text or binary as in the file at `path`."""
    form = SUFFIXES[path.suffix.lower()]
    head = path.read_bytes()
    if form == "vtk":
        return form, {"binary": b"BINARY" in head[:400].upper()}
    if form == "vtu":
        return form, {"binary": not re.search(rb"""format=["']ascii["']""", head)}
    return form, {}
