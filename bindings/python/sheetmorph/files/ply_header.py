# SPDX-License-Identifier: LGPL-2.1-or-later
"""The header of a PLY file: elements, their properties, and the start of the data."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .text import Source, show

_TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
_FORMATS = {b"ascii": "", b"binary_little_endian": "<", b"binary_big_endian": ">"}
_LONGEST_HEADER = 100_000


@dataclass(frozen=True)
class Property:
    """A property; ``count`` is the dtype of a list's length, or "" for a single number."""

    name: str
    dtype: str
    count: str = ""


@dataclass
class Element:
    """An element, such as vertex or face, with its number of records."""

    name: str
    size: int
    properties: list[Property] = field(default_factory=list)

    def index(self, *names: str) -> int:
        """Return the position of the first property with one of these names, or -1."""
        found = [k for k, entry in enumerate(self.properties) if entry.name in names]
        return found[0] if found else -1


@dataclass(frozen=True)
class Header:
    """A PLY header: order is "" for text, "<" or ">" for binary; begin is the data offset."""

    order: str
    elements: list[Element]
    begin: int


def parse_header(source: Source) -> Header:
    """Parse the header of a PLY file. Raises FileError."""
    if not source.data.startswith(b"ply"):
        raise source.error(0, 'the file does not begin with "ply"', "check that it is a PLY file")
    order = None
    elements: list[Element] = []
    offset = 0
    while True:
        line, following = _line_at(source, offset)
        words = line.split()
        if words[:1] == [b"end_header"]:
            break
        if words[:1] == [b"format"]:
            order = _FORMATS.get(words[1] if len(words) > 1 else b"")
            if order is None:
                raise source.error(offset, f'unknown format "{show(line)}"')
        elif words[:1] == [b"element"]:
            elements.append(_element(source, words, offset))
        elif words[:1] == [b"property"]:
            _add_property(source, elements, words, offset)
        elif words and words[0] not in (b"ply", b"comment", b"obj_info"):
            what = f'"{show(words[0])}" is not a line of a PLY header'
            raise source.error(offset, what, "correct the line or remove it")
        offset = following
    if order is None:
        raise source.error(0, "the header names no format")
    return Header(order, elements, following)


def _line_at(source: Source, offset: int) -> tuple[bytes, int]:
    data = source.data
    end = offset
    while end < len(data) and data[end] not in b"\r\n":
        end += 1
    if end == len(data) or end > _LONGEST_HEADER:
        raise source.error(min(offset, len(data)), "the header has no end_header line")
    following = end + 2 if data[end : end + 2] == b"\r\n" else end + 1
    return data[offset:end], following


def _element(source: Source, words: list[bytes], offset: int) -> Element:
    if len(words) != 3:
        raise source.error(offset, "an element needs a name and a count")
    size = source.integer(words[2], offset)
    if size < 0:
        raise source.error(offset, f"{size} elements are not possible")
    return Element(words[1].decode("latin-1"), size)


def _add_property(source: Source, elements: list[Element], words: list[bytes], offset: int) -> None:
    names = [word.decode("latin-1") for word in words[1:]]
    is_list = names[:1] == ["list"]
    types = names[1:3] if is_list else names[:1]
    if not elements or len(names) != len(types) + 1 + is_list:
        raise source.error(offset, "a property is not valid")
    if any(kind not in _TYPES for kind in types):
        raise source.error(offset, f"unknown type in property {show(names[-1].encode())}")
    count = _TYPES[types[0]] if is_list else ""
    if count.startswith("f"):
        raise source.error(offset, "the length of a list cannot be a fraction")
    elements[-1].properties.append(Property(names[-1], _TYPES[types[-1]], count))


def checked_elements(source: Source, header: Header) -> tuple[Element, Element]:
    """Return the vertex and the face element after checks of their properties. Raises FileError."""
    by_name = {element.name: element for element in header.elements}
    for name in ("vertex", "face"):
        if name not in by_name or by_name[name].size == 0:
            raise source.error(0, f'no element "{name}"', "export a triangle or polygon mesh")
    vertex, face = by_name["vertex"], by_name["face"]
    for name in "xyz":
        k = vertex.index(name)
        if k < 0 or vertex.properties[k].count or vertex.properties[k].dtype[0] != "f":
            raise source.error(0, f"vertices need a property {name}, float or double")
    k = face.index("vertex_indices", "vertex_index")
    if k < 0 or not face.properties[k].count or face.properties[k].dtype[0] == "f":
        raise source.error(0, "faces need a list of vertex_indices")
    return vertex, face


def check_faces(source: Source, faces: list[list[int]], vertex_count: int) -> None:
    """Check that faces have three or more valid vertices. Raises FileError."""
    for number, face in enumerate(faces):
        if len(face) < 3:
            raise source.error(0, f"face {number} has {len(face)} vertices; it needs 3 or more")
        if min(face) < 0 or max(face) >= vertex_count:
            what = f"face {number} names a vertex outside 0 .. {vertex_count - 1}"
            raise source.error(0, what)


def scalar_dtype(element: Element, order: str) -> np.dtype[np.void]:
    """Return the record type of an element without lists."""
    return np.dtype([(f"p{k}", order + p.dtype) for k, p in enumerate(element.properties)])
