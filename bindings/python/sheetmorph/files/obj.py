# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefront OBJ: only the coordinates of its `v` lines are rewritten."""

from __future__ import annotations

import re

import numpy as np

from ..labels import Labels
from ..part_mesh import PartMesh
from .polygons import triangulate
from .text import CoordinateText, Source, TextPartFile, TOKEN, show

_COMMENT_OR_JOIN = re.compile(rb"^[ \t]*#[^\r\n]*|\\(?:\r\n|\n|\r)", re.MULTILINE)
_STATEMENT = re.compile(rb"^[ \t]*(v|f|g|o|usemtl)(?=[ \t\n]|\Z)([^\n#]*)", re.MULTILINE)


def _blank_join(match: re.Match[bytes]) -> bytes:
    found = match.group()
    return b" " * len(found) if found.startswith(b"\\") else found


def _logical_lines(data: bytes) -> bytes:
    """The same text, offset for offset, continued lines joined and every line end a \\n."""
    joined = _COMMENT_OR_JOIN.sub(_blank_join, data) if b"\\" in data else data
    return joined.replace(b"\r", b"\n")


class _Groups:
    """The names that `g`, `o` and `usemtl` give to the faces behind them."""

    def __init__(self) -> None:
        self._now: dict[str, list[str]] = {}
        self._begun: dict[str, int] = {}
        self._ranges: dict[str, list[tuple[int, int]]] = {}

    def begin(self, key: bytes, names: bytes, face: int) -> None:
        """A statement before the face with this number; of `g` every word is a name."""
        kind, text = key.decode(), names.decode("utf-8", "replace").strip()
        self._end(kind, face)
        words = text.split() if kind == "g" else [" ".join(text.split())]
        self._now[kind] = [f"{kind} {word}" for word in dict.fromkeys(words) if word]
        self._begun[kind] = face

    def _end(self, kind: str, face: int) -> None:
        for name in self._now.get(kind, ()):
            if self._begun[kind] < face:
                self._ranges.setdefault(name, []).append((self._begun[kind], face))

    def labels(self, faces: list[list[int]]) -> Labels | None:
        """The names of groups of triangles; None if the file has none."""
        for kind in self._now:
            self._end(kind, len(faces))
        first = np.cumsum([0, *(len(face) - 2 for face in faces)])
        groups = {
            name: np.concatenate([np.arange(first[a], first[b]) for a, b in ranges])
            for name, ranges in self._ranges.items()
        }
        return Labels(groups) if groups else None


class ObjFile(TextPartFile):
    """An OBJ file: groups, normals, colours, comments and continued lines come back untouched."""

    @classmethod
    def parse(cls, source: Source) -> tuple[PartMesh, CoordinateText]:
        text = _logical_lines(source.data)
        spans: list[tuple[int, ...]] = []
        faces: list[list[int]] = []
        offsets: list[int] = []
        groups = _Groups()
        for statement in _STATEMENT.finditer(text):
            tokens = list(TOKEN.finditer(text, *statement.span(2)))
            if statement.group(1) == b"v":
                spans.append(_vertex_span(source, tokens, statement.start()))
            elif statement.group(1) == b"f":
                faces.append(_face(source, tokens, len(spans), statement.start()))
                offsets.append(statement.start())
            else:
                groups.begin(statement.group(1), statement.group(2), len(faces))
        if not spans or not faces:
            missing = "vertices" if not spans else "faces"
            raise source.error(
                0, f"no {missing} were found", "check that it is an OBJ surface mesh"
            )
        _check_range(source, faces, offsets, len(spans))
        where = np.array(spans, dtype=np.int64).reshape(-1, 3, 2)
        numbers = [source.number(text[b:e], b) for b, e in where.reshape(-1, 2).tolist()]
        points = np.array(numbers).reshape(-1, 3)
        mesh = PartMesh(
            points, triangulate(points, faces), name=source.path.stem, labels=groups.labels(faces)
        )
        return mesh, CoordinateText(source.data, where, points)


def _vertex_span(source: Source, tokens: list[re.Match[bytes]], offset: int) -> tuple[int, ...]:
    if len(tokens) < 3:
        raise source.error(offset, f"a vertex with {len(tokens)} coordinates instead of 3")
    return tokens[0].span() + tokens[1].span() + tokens[2].span()


def _face(source: Source, tokens: list[re.Match[bytes]], count: int, offset: int) -> list[int]:
    if len(tokens) < 3:
        raise source.error(offset, f"a face with {len(tokens)} vertices; it needs 3 or more")
    face = []
    for token in tokens:
        number = source.integer(token.group().split(b"/", 1)[0], token.start())
        # Negative indices count back from the last vertex before this line.
        index = number - 1 if number > 0 else count + number
        if number == 0 or index < 0:
            raise source.error(offset, f"a face names vertex {show(token.group())}, there is none")
        face.append(index)
    return face


def _check_range(source: Source, faces: list[list[int]], offsets: list[int], count: int) -> None:
    for face, offset in zip(faces, offsets):
        if max(face) >= count:
            what = f"a face names vertex {max(face) + 1}, the file has {count}"
            raise source.error(offset, what)
