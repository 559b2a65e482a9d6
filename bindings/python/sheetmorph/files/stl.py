# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL as text or binary: equal corners are merged, facets keep their order and get new normals."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.part_mesh import PartMesh
from ..base.words import counted
from .part_file import PartFile
from .text import CoordinateText, Source, check_points, read_bytes, show, without_mark

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER_SIZE = 84
_THREE = rb"\s+([^\s]+)\s+([^\s]+)\s+([^\s]+)"
_FACET = re.compile(
    rb"facet\s+normal" + _THREE + rb"\s+outer\s+loop"
    rb"\s+vertex" + _THREE + rb"\s+vertex" + _THREE + rb"\s+vertex" + _THREE + rb"\s+"
    rb"endloop\s+endfacet",
    re.IGNORECASE,
)
_NAME_LINE = re.compile(rb"\s*((end)?solid\b.*)?", re.IGNORECASE)
# A file may lack the attribute of its last facet, which does not affect the shape.
_ATTRIBUTE_SIZE = 2
_NO_END = "the closing endsolid is missing: check that its {0} facets are all there"


@dataclass(frozen=True)
class _Weld:
    """The merged corners: points (n, 3) by first appearance, and corner (3 m,) with their index."""

    points: Floats
    corner: Ints
    first: Ints


def _weld(corners: Floats) -> _Weld:
    """Merge corners (3 m, 3) with exactly equal coordinates."""
    rows = np.ascontiguousarray(corners + 0.0)  # -0.0 and 0.0 are the same position
    keys = rows.view(np.dtype((np.void, rows.dtype.itemsize * 3))).ravel()
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return _Weld(corners[first[order]], rank[inverse], first[order])


class StlFile(PartFile):
    """The common part of both kinds; vertices are merged corners, numbered by first appearance."""

    def __init__(self, source: Source, corners: Floats, precision: str):
        weld = _weld(corners)
        self._corner = weld.corner
        self._first = weld.first
        mesh = PartMesh(weld.points, weld.corner.reshape(-1, 3), name=source.path.stem)
        super().__init__(source.path, mesh, precision)

    def stored_positions(self, path: Path) -> Floats:
        # Rounding may make two vertices equal, so the order of the corners identifies them.
        return read_corners(path)[self._first]

    def _changes(self, positions: Floats) -> tuple[Bools, Floats, Floats]:
        """Return changed facets (m,) bool, corners (m, 3, 3) and unit normals (m, 3)."""
        moved = (positions != self.mesh.points).any(axis=1)[self._corner].reshape(-1, 3).any(axis=1)
        corners = positions[self._corner].reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(normals, axis=1)
        normals /= np.where(length > 0.0, length, 1.0)[:, None]
        return moved, corners, normals


class BinaryStlFile(StlFile):
    """A binary STL; header and attributes are kept, coordinates are float32."""

    def __init__(self, source: Source):
        count = int.from_bytes(source.data[80:84], "little")
        short = _HEADER_SIZE + count * _RECORD.itemsize - len(source.data)
        self._data = source.data + bytes(short)
        super().__init__(source, _binary_corners(Source(source.path, self._data)), "float32")
        if short:
            what = counted(short, "byte is", "bytes are")
            self.missing.append(
                f"{what} missing at the end of the file; all {count} facets are there"
            )

    def save(self, path: Path, positions: Floats) -> None:
        data = bytearray(self._data)
        records = np.frombuffer(data, _RECORD, offset=_HEADER_SIZE)
        moved, corners, normals = self._changes(positions)
        records["corners"][moved] = corners[moved]
        records["normal"][moved] = normals[moved]
        path.write_bytes(data)


class AsciiStlFile(StlFile):
    """A text STL; names and layout are kept, and an unchanged facet keeps its text."""

    def __init__(self, source: Source):
        spans, numbers, is_ended = _ascii_facets(source)
        self._text = CoordinateText(source.data, spans, numbers)
        corners = numbers.reshape(-1, 4, 3)[:, 1:].reshape(-1, 3)
        super().__init__(source, corners, "double")
        if not is_ended:
            self.missing.append(_NO_END.format(len(corners) // 3))

    def save(self, path: Path, positions: Floats) -> None:
        moved, corners, normals = self._changes(positions)
        rows = self._text.values.reshape(-1, 4, 3).copy()
        rows[moved, 1:] = corners[moved]
        rows[moved, 0] = normals[moved]
        path.write_bytes(self._text.rewritten(rows.reshape(-1, 3)))


def _ascii_facets(source: Source) -> tuple[Ints, Floats, bool]:
    """Return spans (4 m, 3, 2) and values (4 m, 3) of the normal and corners of every facet.

    The last value states whether the last solid is closed.
    """
    spans: list[tuple[int, int]] = []
    done = 0
    for facet in _FACET.finditer(source.data):
        _check_between(source, done, facet.start())
        spans += [facet.span(k) for k in range(1, 13)]
        done = facet.end()
    if not spans:
        raise source.error(0, "no facet was found", "check that it is an STL file")
    is_ended = _is_ended(source, done)
    numbers = [source.number(source.data[b:e], b) for b, e in spans]
    where = np.array(spans, dtype=np.int64).reshape(-1, 3, 2)
    return where, np.array(numbers).reshape(-1, 3), is_ended


def _is_ended(source: Source, done: int) -> bool:
    """Return whether the text after the last facet closes its solid.

    Raises FileError for other text.
    """
    lines = [line.strip().lower() for line in source.data[done:].splitlines() if line.strip()]
    if lines and b"endsolid".startswith(lines[-1]):
        lines.pop()  # a truncated or unnamed endsolid
        is_ended = source.data.rstrip().lower().endswith(b"endsolid")
    else:
        is_ended = bool(lines) and lines[-1].startswith(b"endsolid")
    if not all(_NAME_LINE.fullmatch(line) for line in lines):
        raise source.error(done, "a facet or the closing endsolid is incomplete")
    return is_ended


def _check_between(source: Source, begin: int, end: int) -> None:
    for line in source.data[begin:end].splitlines():
        if not _NAME_LINE.fullmatch(line):
            raise source.error(begin, f'"{show(line.strip())}" is not a facet')


def _binary_corners(source: Source) -> Floats:
    """Return corners (3 m, 3) float64 of a binary STL. Raises FileError."""
    records = np.frombuffer(source.data, _RECORD, offset=_HEADER_SIZE)
    with np.errstate(invalid="ignore"):  # a signalling NaN; check_points() reports it
        corners = records["corners"].reshape(-1, 3).astype(np.float64)
    check_points(source.path, corners)
    return corners


def _is_binary(source: Source) -> bool:
    data = source.data
    if len(data) < _HEADER_SIZE:
        return False
    count = int.from_bytes(data[80:84], "little")
    expected = _HEADER_SIZE + count * _RECORD.itemsize
    if count > 0 and expected - _ATTRIBUTE_SIZE <= len(data) <= expected:
        return True
    head = without_mark(data[:1000]).lower()
    if head.lstrip().startswith(b"solid") and (b"facet" in head or b"\0" not in data):
        return False
    what = f"{count} facets need {expected} bytes, the file has {len(data)}"
    raise source.error(0, what, "copy or export it again")


def read_corners(path: Path) -> Floats:
    """Return corners (3 m, 3) float64 of an STL file in its own order. Raises FileError."""
    source = Source(path, read_bytes(path))
    if _is_binary(source):
        return _binary_corners(source)
    text = Source.of_text(path, source.data)
    return _ascii_facets(text)[1].reshape(-1, 4, 3)[:, 1:].reshape(-1, 3)


def read_stl(path: Path) -> StlFile:
    """Read a text or binary STL file. Raises FileError."""
    source = Source(path, read_bytes(path))
    if _is_binary(source):
        return BinaryStlFile(source)
    return AsciiStlFile(Source.of_text(path, source.data))
