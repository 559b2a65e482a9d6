# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLY as text or as binary of either byte order: only the coordinates are rewritten."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.part_mesh import PartMesh
from ..base.words import counted
from .part_file import PartFile
from .ply_header import Element, Header, check_faces, checked_elements, parse_header, scalar_dtype
from ..base.polygons import triangulate
from .text import (
    CUT_LINE,
    CoordinateText,
    Source,
    TextPartFile,
    TOKEN,
    check_points,
    read_bytes,
    without_mark,
)

_LINE = re.compile(rb"[^\n]*\S[^\n]*")
_IS_TEXT = re.compile(rb"[\r\n]format\s+ascii\s")

Tokens = list[re.Match[bytes]]


class AsciiPlyFile(TextPartFile):
    """A text PLY; colours, normals, comments and other elements stay unchanged."""

    @classmethod
    def parse(cls, source: Source) -> tuple[PartMesh, CoordinateText, list[str]]:
        header = parse_header(source)
        vertex, face = checked_elements(source, header)
        lines = _lines(source.data, header.begin)
        spans: list[tuple[int, int]] = []
        faces: list[list[int]] = []
        for element in header.elements:
            for _ in range(element.size):
                tokens = next(lines, None)
                if tokens is None:
                    what = f"the file ends early, among its {element.size} {element.name} lines"
                    raise source.error(len(source.data), what, "copy or export it again")
                if element is vertex:
                    spans += _vertex_spans(source, element, tokens)
                elif element is face:
                    faces.append(_ascii_face(source, element, tokens))
        more = next(lines, None)
        if more is not None:
            what = "the file continues after all elements of its header"
            raise source.error(more[0].start(), what, "correct the counts in the header")
        check_faces(source, faces, vertex.size)
        text = source.data
        points = np.array([source.number(text[b:e], b) for b, e in spans]).reshape(-1, 3)
        mesh = PartMesh(points, _triangles(source, points, faces), name=source.path.stem)
        where = np.array(spans, dtype=np.int64).reshape(-1, 3, 2)
        missing = [CUT_LINE] if source.ends_within_a_line else []
        return mesh, CoordinateText(source.data, where, points), missing


def _triangles(source: Source, points: Floats, faces: list[list[int]]) -> Ints:
    return triangulate(points, faces, lambda k, what: source.error(0, f"face {k}: {what}"))


def _lines(data: bytes, begin: int) -> Iterator[Tokens]:
    text = data.replace(b"\r", b"\n")
    for line in _LINE.finditer(text, begin):
        yield list(TOKEN.finditer(text, *line.span()))


def _vertex_spans(source: Source, element: Element, tokens: Tokens) -> list[tuple[int, int]]:
    if any(entry.count for entry in element.properties):
        raise source.error(tokens[0].start(), "vertices with lists are not read")
    if len(tokens) != len(element.properties):
        what = f"a vertex with {len(tokens)} numbers instead of {len(element.properties)}"
        raise source.error(tokens[0].start(), what)
    return [tokens[element.index(name)].span() for name in "xyz"]


def _ascii_face(source: Source, element: Element, tokens: Tokens) -> list[int]:
    wanted = element.index("vertex_indices", "vertex_index")
    face: list[int] = []
    at = 0
    for k, entry in enumerate(element.properties):
        if at >= len(tokens):
            raise source.error(tokens[0].start(), "a face with too few numbers")
        size = source.integer(tokens[at].group(), tokens[at].start()) if entry.count else 0
        if size < 0 or at + size >= len(tokens):
            raise source.error(tokens[0].start(), "a face with too few numbers")
        if k == wanted:
            chosen = tokens[at + 1 : at + 1 + size]
            face = [source.integer(token.group(), token.start()) for token in chosen]
        at += 1 + size
    if at < len(tokens):
        raise source.error(tokens[0].start(), "a face with too many numbers")
    return face


class BinaryPlyFile(PartFile):
    """A binary PLY; it keeps its property types, so float coordinates are rounded to float32."""

    def __init__(self, source: Source, header: Header):
        vertex, face = checked_elements(source, header)
        blocks = {e.name: block for e, block in _blocks(source, header, vertex, face)}
        extra = len(source.data) - blocks.pop("")
        self._data = source.data
        self._record = scalar_dtype(vertex, header.order)
        self._begin = blocks["vertex"]
        self._size = vertex.size
        self._fields = [f"p{vertex.index(name)}" for name in "xyz"]
        records = np.frombuffer(source.data, self._record, self._size, self._begin)
        points = np.stack([records[name].astype(np.float64) for name in self._fields], axis=1)
        check_points(source.path, points)
        faces = blocks["face"]
        check_faces(source, faces, vertex.size)
        is_single = any(self._record[name].itemsize == 4 for name in self._fields)
        mesh = PartMesh(points, _triangles(source, points, faces), name=source.path.stem)
        super().__init__(source.path, mesh, "float32" if is_single else "double")
        if extra:
            what = counted(extra, "byte follows", "bytes follow")
            self.missing.append(f"{what} the elements that the header counts, and cannot be read")

    def save(self, path: Path, positions: Floats) -> None:
        data = bytearray(self._data)
        records = np.frombuffer(data, self._record, self._size, self._begin)
        for axis, name in enumerate(self._fields):
            changed = positions[:, axis] != self.mesh.points[:, axis]
            records[name][changed] = positions[changed, axis]
        path.write_bytes(data)

    def stored_positions(self, path: Path) -> Floats:
        return read_ply(path).mesh.points


def _blocks(
    source: Source, header: Header, vertex: Element, face: Element
) -> Iterator[tuple[Element, Any]]:
    """Yield the byte offset of the vertex element, and the vertex lists of the face element.

    Other elements are skipped. The last item is an unnamed element with the end offset.
    """
    offset = header.begin
    for element in header.elements:
        begin = offset
        if not any(entry.count for entry in element.properties):
            offset += scalar_dtype(element, header.order).itemsize * element.size
            if offset > len(source.data):
                raise _ends_early(source, element)
            if element is vertex:
                yield element, begin
            continue
        if element is vertex:
            raise source.error(0, "vertices with lists are not read")
        same = _equal_lists(source, element, header.order, begin) if element is face else None
        if same is not None:
            yield element, same.tolist()
            offset += element.size * (
                same[0].nbytes + np.dtype(element.properties[0].count).itemsize
            )
            continue
        column = element.index("vertex_indices", "vertex_index") if element is face else -1
        lists, offset = _walk(source, element, header.order, begin, column)
        if element is face:
            yield element, lists
    yield Element("", 0), offset


def _ends_early(source: Source, element: Element) -> Exception:
    what = f"the file ends early, among its {element.size} {element.name} records"
    return source.error(len(source.data), what, "copy or export it again")


def _walk(
    source: Source, element: Element, order: str, offset: int, column: int
) -> tuple[list[list[int]], int]:
    """Return the lists in a column of an element (-1: none), and the offset after the element.

    offset is that of the element.
    """
    lists: list[list[int]] = []
    for _ in range(element.size):
        for k, entry in enumerate(element.properties):
            item = np.dtype(order + entry.dtype)
            size = 1
            if entry.count:
                size = _list_size(source, element, np.dtype(order + entry.count), offset)
                offset += np.dtype(entry.count).itemsize
            if size < 0 or offset + size * item.itemsize > len(source.data):
                raise _ends_early(source, element)
            if k == column:
                lists.append(np.frombuffer(source.data, item, size, offset).tolist())
            offset += size * item.itemsize
    return lists, offset


def _list_size(source: Source, element: Element, count_type: np.dtype[Any], offset: int) -> int:
    if offset + count_type.itemsize > len(source.data):
        raise _ends_early(source, element)
    return int(np.frombuffer(source.data, count_type, 1, offset)[0])


def _equal_lists(source: Source, element: Element, order: str, begin: int) -> Ints | None:
    """Return the faces (m, k) of an element if all have the same number of vertices, else None.

    This is the fast path for triangle meshes; it needs a single list property.
    """
    if len(element.properties) != 1:
        return None
    entry = element.properties[0]
    size = _list_size(source, element, np.dtype(order + entry.count), begin)
    record = np.dtype([("size", order + entry.count), ("items", order + entry.dtype, (abs(size),))])
    if begin + record.itemsize * element.size > len(source.data):
        return None
    records = np.frombuffer(source.data, record, element.size, begin)
    return records["items"] if (records["size"] == size).all() else None


def read_ply(path: Path) -> PartFile:
    """Read a text or binary PLY file. Raises FileError."""
    source = Source(path, without_mark(read_bytes(path)))
    if _IS_TEXT.search(source.data, 0, 1000):
        source = Source.of_text(path, source.data)
    if parse_header(source).order == "":
        return AsciiPlyFile(path, *AsciiPlyFile.parse(source))
    return BinaryPlyFile(source, parse_header(source))
