# SPDX-License-Identifier: LGPL-2.1-or-later
"""OFF and its variants (COFF, NOFF, STOFF): only the coordinates are rewritten."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from ..base.part_mesh import PartMesh
from ..base.polygons import triangulate
from .text import CUT_LINE, CoordinateText, Source, TextPartFile, TOKEN, show

_LINE = re.compile(rb"[^\n]*\S[^\n]*")
_COMMENT = re.compile(rb"#[^\n]*")
_HEADER = re.compile(rb"(ST)?C?N?OFF")
_OTHER_SPACE = re.compile(rb"(ST)?C?N?(4|n|4n)OFF")

Tokens = list[re.Match[bytes]]


def _lines(data: bytes) -> Iterator[Tokens]:
    """Yield the tokens of every non-empty line; comments become blanks, so offsets stay correct.

    Blank lines are skipped.
    """
    text = _COMMENT.sub(lambda m: b" " * len(m.group()), data.replace(b"\r", b"\n"))
    for line in _LINE.finditer(text):
        yield list(TOKEN.finditer(text, *line.span()))


class OffFile(TextPartFile):
    """An OFF file; colours, normals, comments and blank lines stay unchanged."""

    @classmethod
    def parse(cls, source: Source) -> tuple[PartMesh, CoordinateText, list[str]]:
        lines = _lines(source.data)
        vertex_count, face_count = _counts(source, lines)
        spans, numbers = [], []
        for _ in range(vertex_count):
            tokens = _next(source, lines, f"{vertex_count} vertices")
            if len(tokens) < 3:
                raise source.error(tokens[0].start(), "a vertex with fewer than 3 coordinates")
            spans += [token.span() for token in tokens[:3]]
            numbers += [source.number(token.group(), token.start()) for token in tokens[:3]]
        faces, offsets = [], []
        for _ in range(face_count):
            tokens = _next(source, lines, f"{face_count} faces")
            face = _face(source, tokens, vertex_count)
            # The face list can contain vertices and edges, which have no area.
            if len(face) > 2:
                faces.append(face)
                offsets.append(tokens[0].start())
        more = next(lines, None)
        if more is not None:
            what = f"the file continues after its {vertex_count} vertices and {face_count} faces"
            raise source.error(more[0].start(), what, "correct the counts in the header")
        if not faces:
            raise source.error(0, "the file has no faces", "export a surface mesh")
        points = np.array(numbers).reshape(-1, 3)
        triangles = triangulate(points, faces, lambda k, what: source.error(offsets[k], what))
        mesh = PartMesh(points, triangles, name=source.path.stem)
        where = np.array(spans, dtype=np.int64).reshape(-1, 3, 2)
        missing = [CUT_LINE] if source.ends_within_a_line else []
        return mesh, CoordinateText(source.data, where, points), missing


def _next(source: Source, lines: Iterator[Tokens], wanted: str) -> Tokens:
    tokens = next(lines, None)
    if tokens is None:
        what = f"the file ends early; it should have {wanted}"
        raise source.error(len(source.data), what, "copy or export it again")
    return tokens


def _counts(source: Source, lines: Iterator[Tokens]) -> tuple[int, int]:
    tokens = _next(source, lines, "a header")
    word = tokens[0].group()
    if _OTHER_SPACE.fullmatch(word):
        raise source.error(0, f"{show(word)} is not three-dimensional", "export a plain OFF file")
    if len(tokens) > 1 and tokens[1].group().upper() == b"BINARY":
        raise source.error(0, "binary OFF is not read", "export it as text, or as PLY")
    if _HEADER.fullmatch(word):
        tokens = tokens[1:] or _next(source, lines, "the counts of vertices and faces")
    if len(tokens) < 2:
        raise source.error(tokens[0].start(), "the counts of vertices and faces are missing")
    counts = [source.integer(token.group(), token.start()) for token in tokens[:2]]
    if min(counts) < 1:
        raise source.error(tokens[0].start(), "the file has no vertices or no faces")
    return counts[0], counts[1]


def _face(source: Source, tokens: Tokens, vertex_count: int) -> list[int]:
    offset = tokens[0].start()
    size = source.integer(tokens[0].group(), offset)
    if size < 1 or len(tokens) < size + 1:
        raise source.error(offset, f"a face of {size} vertices names {len(tokens) - 1}")
    face = [source.integer(token.group(), token.start()) for token in tokens[1 : size + 1]]
    if min(face) < 0 or max(face) >= vertex_count:
        what = f"a face names vertex {max(face) if min(face) >= 0 else min(face)}"
        raise source.error(offset, f"{what}, the file has 0 .. {vertex_count - 1}")
    return face
