# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefront OBJ: only the coordinates in its `v` lines are rewritten."""

from __future__ import annotations

import re
from collections import Counter

import numpy as np

from ..base.labels import Labels
from ..base.part_mesh import PartMesh
from ..base.words import counted
from ..base.polygons import triangulate
from .text import CUT_LINE, CoordinateText, Source, TextPartFile, TOKEN, show

_COMMENT_OR_JOIN = re.compile(rb"#[^\r\n]*|\\(?:\r\n|\n|\r)")
_NEXT = re.compile(rb"[ \t]*[vf][ \t]")
_STATEMENT = re.compile(rb"^[^\S\n]*([^\s#]+)([^\n#]*)", re.MULTILINE)
_CORNER = re.compile(rb"([+-]?\d+)(?:/(?:[+-]?\d+)?){0,2}")
# Statements besides those of a polygon mesh. The first set does not affect the shape. The second
# set has surfaces, curves and files that the reader skips.
_WITHOUT_SHAPE = frozenset(
    b"vt vn vp l p s mg mtllib cstype deg bmat step parm trim hole scrv sp end con bevel c_interp "
    b"d_interp lod usemap maplib shadow_obj trace_obj ctech stech csh".split()
)
_NOT_READ = frozenset(b"curv curv2 surf fo call bsp bzp cdc cdp res".split())
_NAMES = (b"g", b"o", b"usemtl")


def _logical_lines(source: Source) -> bytes:
    r"""Join continued lines and normalise line ends to \n; all byte offsets stay the same."""

    def joined(match: re.Match[bytes]) -> bytes:
        found = match.group()
        if not found.startswith(b"\\"):
            return found
        if _NEXT.match(source.data, match.end()):
            what = "a line ends with a backslash, but the next line is a new statement"
            raise source.error(match.start(), what, "remove the backslash")
        return b" " * len(found)

    data = source.data
    return (_COMMENT_OR_JOIN.sub(joined, data) if b"\\" in data else data).replace(b"\r", b"\n")


class _Groups:
    """The names that `g`, `o` and `usemtl` give to the faces after them."""

    def __init__(self) -> None:
        self._now: dict[str, list[str]] = {}
        self._begun: dict[str, int] = {}
        self._ranges: dict[str, list[tuple[int, int]]] = {}

    def begin(self, key: bytes, names: bytes, face: int) -> None:
        """Start a group before the face with this number; every word of a `g` line is a name."""
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
        """Return the names of the triangle groups, or None if the file has none."""
        for kind in self._now:
            self._end(kind, len(faces))
        first = np.cumsum([0, *(len(face) - 2 for face in faces)])
        groups = {
            name: np.concatenate([np.arange(first[a], first[b]) for a, b in ranges])
            for name, ranges in self._ranges.items()
        }
        return Labels(groups) if groups else None


class ObjFile(TextPartFile):
    """An OBJ file; groups, normals, colours, comments and continued lines stay unchanged."""

    @classmethod
    def parse(cls, source: Source) -> tuple[PartMesh, CoordinateText, list[str]]:
        text = _logical_lines(source)
        spans: list[tuple[int, ...]] = []
        faces: list[list[int]] = []
        offsets: list[int] = []
        groups = _Groups()
        rows = _Rows(source)
        unread: Counter[bytes] = Counter()
        for statement in _STATEMENT.finditer(text):
            word, begin = statement.group(1), statement.start(1)
            if word == b"v":
                tokens = list(TOKEN.finditer(text, *statement.span(2)))
                spans.append(rows.vertex_span(tokens, begin))
            elif word == b"f":
                tokens = list(TOKEN.finditer(text, *statement.span(2)))
                faces.append(_face(source, tokens, len(spans), begin))
                offsets.append(begin)
            elif word in _NAMES:
                groups.begin(word, statement.group(2), len(faces))
            elif word in _NOT_READ:
                unread[word] += 1
            elif word not in _WITHOUT_SHAPE:
                what = f'"{show(word)}" is not a statement of an OBJ file'
                raise source.error(begin, what, "correct the line or remove it")
        rows.check()
        if not spans or not faces:
            missing = "vertices" if not spans else "faces"
            raise source.error(
                0, f"no {missing} were found", "check that it is an OBJ surface mesh"
            )
        _check_range(source, faces, offsets, len(spans))
        where = np.array(spans, dtype=np.int64).reshape(-1, 3, 2)
        numbers = [source.number(text[b:e], b) for b, e in where.reshape(-1, 2).tolist()]
        points = np.array(numbers).reshape(-1, 3)
        triangles = triangulate(points, faces, lambda k, what: source.error(offsets[k], what))
        mesh = PartMesh(points, triangles, name=source.path.stem, labels=groups.labels(faces))
        return mesh, CoordinateText(source.data, where, points), _missing(source, mesh, unread)


class _Rows:
    """Checks of the `v` lines: the count of their numbers, and their syntax."""

    def __init__(self, source: Source):
        self._source = source
        self._weighted: int | None = None
        self._has_plain = False

    def vertex_span(self, tokens: list[re.Match[bytes]], offset: int) -> tuple[int, ...]:
        """Return the offsets of the three coordinates; a weight and a colour may follow."""
        count = len(tokens)
        if count not in (3, 4, 6, 7):
            what = f"a vertex with {count} coordinates instead of 3"
            raise self._source.error(offset, what)
        more = [self._source.number(token.group(), token.start()) for token in tokens[3:]]
        if count % 3 == 0:
            self._has_plain = True
        elif more[0] != 1.0 and self._weighted is None:
            self._weighted = offset
        return tokens[0].span() + tokens[1].span() + tokens[2].span()

    def check(self) -> None:
        """Reject a weight that other vertices lack, because it can be a split number.

        Raises FileError.
        """
        if self._has_plain and self._weighted is not None:
            what = "a vertex has a fourth number that is not 1, and other vertices have none"
            raise self._source.error(self._weighted, what)


def _missing(source: Source, mesh: PartMesh, unread: Counter[bytes]) -> list[str]:
    """Return sentences on content beside the polygons, and on content that seems lost.

    An OBJ file has no counts and no end mark, so a truncated file can still be valid. Vertices come
    first, so that most lost faces leave vertices without a face.
    """
    found = []
    for word, count in sorted(unread.items()):
        lines = counted(count, "statement", "statements")
        found.append(f'{lines} "{word.decode()}" are not supported and were skipped')
    unused = len(mesh.points) - len(np.unique(mesh.triangles))
    if unused:
        text = counted(unused, "vertex has", "vertices have")
        found.append(f"{text} no face: check that the file is complete")
    return found + ([CUT_LINE] if source.ends_within_a_line else [])


def _face(source: Source, tokens: list[re.Match[bytes]], count: int, offset: int) -> list[int]:
    if len(tokens) < 3:
        raise source.error(offset, f"a face with {len(tokens)} vertices; it needs 3 or more")
    face = []
    forms = set()
    for token in tokens:
        text = token.group()
        corner = None if text.isdigit() else _CORNER.fullmatch(text)
        forms.add((text.count(b"/"), b"//" in text, text.endswith(b"/")))
        number = source.integer(corner.group(1) if corner else text, token.start())
        # Negative indices count back from the last vertex before this line.
        index = number - 1 if number > 0 else count + number
        if number == 0 or index < 0:
            raise source.error(offset, f"a face names vertex {show(token.group())}, there is none")
        face.append(index)
    if len(forms) > 1:
        what = "the corners of a face have different forms, like 1/2 and 1//2"
        raise source.error(offset, what)
    return face


def _check_range(source: Source, faces: list[list[int]], offsets: list[int], count: int) -> None:
    for face, offset in zip(faces, offsets):
        if max(face) >= count:
            what = f"a face names vertex {max(face) + 1}, the file has {count}"
            raise source.error(offset, what)
