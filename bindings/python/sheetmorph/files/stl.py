# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL, text and binary: facets welded exactly, written back in the same order with new normals."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..arrays import Bools, Floats, Ints
from ..part_mesh import PartMesh
from .part_file import PartFile
from .text import CoordinateText, Source, check_points, read_bytes, show

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
_LAST = re.compile(rb"\s*endsolid\b.*", re.IGNORECASE | re.DOTALL)


@dataclass(frozen=True)
class _Weld:
    """points (n, 3) in order of first appearance; corner (3 m,): the vertex of every corner."""

    points: Floats
    corner: Ints
    first: Ints


def _weld(corners: Floats) -> _Weld:
    """Corners (3 m, 3) with exactly equal coordinates become one vertex."""
    rows = np.ascontiguousarray(corners + 0.0)  # -0.0 and 0.0 are one place
    keys = rows.view(np.dtype((np.void, rows.dtype.itemsize * 3))).ravel()
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return _Weld(corners[first[order]], rank[inverse], first[order])


class StlFile(PartFile):
    """What both kinds share: vertices are the welded corners; ids count their first appearance."""

    def __init__(self, source: Source, corners: Floats, precision: str):
        weld = _weld(corners)
        self._corner = weld.corner
        self._first = weld.first
        mesh = PartMesh(weld.points, weld.corner.reshape(-1, 3), name=source.path.stem)
        super().__init__(source.path, mesh, precision)

    def stored_positions(self, path: Path) -> Floats:
        # Rounding may bring two vertices to one place; the order of the corners stays.
        return read_corners(path)[self._first]

    def _changes(self, positions: Floats) -> tuple[Bools, Floats, Floats]:
        """Facets that changed (m,) bool, corners (m, 3, 3) and unit normals (m, 3)."""
        moved = (positions != self.mesh.points).any(axis=1)[self._corner].reshape(-1, 3).any(axis=1)
        corners = positions[self._corner].reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(normals, axis=1)
        normals /= np.where(length > 0.0, length, 1.0)[:, None]
        return moved, corners, normals


class BinaryStlFile(StlFile):
    """Binary STL; header and attributes are kept, coordinates are float32."""

    def __init__(self, source: Source):
        self._data = source.data
        super().__init__(source, _binary_corners(source), "float32")

    def save(self, path: Path, positions: Floats) -> None:
        data = bytearray(self._data)
        records = np.frombuffer(data, _RECORD, offset=_HEADER_SIZE)
        moved, corners, normals = self._changes(positions)
        records["corners"][moved] = corners[moved]
        records["normal"][moved] = normals[moved]
        path.write_bytes(data)


class AsciiStlFile(StlFile):
    """Text STL; names and layout are kept, a facet that did not move keeps its text."""

    def __init__(self, source: Source):
        spans, numbers = _ascii_facets(source)
        self._text = CoordinateText(source.data, spans, numbers)
        corners = numbers.reshape(-1, 4, 3)[:, 1:].reshape(-1, 3)
        super().__init__(source, corners, "double")

    def save(self, path: Path, positions: Floats) -> None:
        moved, corners, normals = self._changes(positions)
        rows = self._text.values.reshape(-1, 4, 3).copy()
        rows[moved, 1:] = corners[moved]
        rows[moved, 0] = normals[moved]
        path.write_bytes(self._text.rewritten(rows.reshape(-1, 3)))


def _ascii_facets(source: Source) -> tuple[Ints, Floats]:
    """Spans (4 m, 3, 2) and values (4 m, 3) of the normal and the three corners of every facet."""
    spans: list[tuple[int, int]] = []
    done = 0
    for facet in _FACET.finditer(source.data):
        _check_between(source, done, facet.start())
        spans += [facet.span(k) for k in range(1, 13)]
        done = facet.end()
    if not spans:
        raise source.error(0, "no facet was found", "check that it is an STL file")
    if not _LAST.fullmatch(source.data, done):
        raise source.error(done, "a facet or the closing endsolid is incomplete")
    numbers = [source.number(source.data[b:e], b) for b, e in spans]
    return np.array(spans, dtype=np.int64).reshape(-1, 3, 2), np.array(numbers).reshape(-1, 3)


def _check_between(source: Source, begin: int, end: int) -> None:
    for line in source.data[begin:end].splitlines():
        if not _NAME_LINE.fullmatch(line):
            raise source.error(begin, f'"{show(line.strip())}" is not a facet')


def _binary_corners(source: Source) -> Floats:
    """Corners (3 m, 3) float64 of a binary STL. Raises FileError."""
    records = np.frombuffer(source.data, _RECORD, offset=_HEADER_SIZE)
    with np.errstate(invalid="ignore"):  # a NaN that signals; it is refused in words
        corners = records["corners"].reshape(-1, 3).astype(np.float64)
    check_points(source.path, corners)
    return corners


def _is_binary(source: Source) -> bool:
    data = source.data
    if len(data) < _HEADER_SIZE:
        return False
    count = int.from_bytes(data[80:84], "little")
    if count > 0 and len(data) == _HEADER_SIZE + count * _RECORD.itemsize:
        return True
    if data.lstrip()[:5].lower() == b"solid":
        return False
    expected = _HEADER_SIZE + count * _RECORD.itemsize
    what = f"{count} facets need {expected} bytes, the file has {len(data)}"
    raise source.error(0, what, "copy or export it again")


def read_corners(path: Path) -> Floats:
    """Corners (3 m, 3) float64 of an STL file in its own order. Raises FileError."""
    source = Source(path, read_bytes(path))
    if _is_binary(source):
        return _binary_corners(source)
    return _ascii_facets(source)[1].reshape(-1, 4, 3)[:, 1:].reshape(-1, 3)


def read_stl(path: Path) -> StlFile:
    """A text or binary STL file. Raises FileError."""
    source = Source(path, read_bytes(path))
    return BinaryStlFile(source) if _is_binary(source) else AsciiStlFile(source)
