# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text files in which only the coordinates are rewritten; all other bytes stay the same."""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import FileError
from ..base.part_mesh import PartMesh
from .part_file import PartFile

TOKEN = re.compile(rb"[^\s]+")
# The squares of larger coordinates can overflow.
LARGEST = 1e100
_MARK = b"\xef\xbb\xbf"
_NO_TEXT = re.compile(_MARK + rb"|\0")
# A text without a final line break may be truncated.
CUT_LINE = "the file ends without a line break: check that its last line is complete"
_WHOLE = re.compile(rb"[+-]?\d{1,18}")
_NUMBER = re.compile(rb"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file. Raises FileError if it is unreadable or empty."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise FileError.of(path, error) from None
    if not data:
        raise FileError(path, "the file is empty", "export it again")
    return data


def without_mark(data: bytes) -> bytes:
    """Return the bytes without the byte order mark that some editors add."""
    return data[len(_MARK) :] if data.startswith(_MARK) else data


@dataclass(frozen=True)
class Source:
    """The bytes of a text file, with the line number of each offset for parsers."""

    path: Path
    data: bytes

    @classmethod
    def of_text(cls, path: Path, data: bytes | None = None) -> Source:
        """Return a text file without its byte order mark. Raises FileError if it is not one text.

        data has the bytes of the file; by default they are read from `path`.
        """
        found = cls(path, without_mark(read_bytes(path) if data is None else data))
        if found.data.startswith((b"\xff\xfe", b"\xfe\xff")):
            raise found.error(0, "the file is text in UTF-16", "save it as UTF-8")
        bad = _NO_TEXT.search(found.data)
        if bad and bad.group() == _MARK:
            what = "there is a byte order mark in the middle of the file"
            todo = "remove it; concatenated files have one at every seam"
            raise found.error(bad.start(), what, todo)
        if bad:
            raise found.error(bad.start(), "the text contains a zero byte")
        return found

    @property
    def ends_within_a_line(self) -> bool:
        """Whether the text lacks its final line break, as a truncated file does."""
        return not self.data.endswith((b"\n", b"\r"))

    def line(self, offset: int) -> int:
        """Return the line number of a byte offset, counted from 1."""
        newline = b"\n" if b"\n" in self.data else b"\r"
        return self.data.count(newline, 0, offset) + 1

    def error(self, offset: int, what: str, todo: str = "export the file again") -> FileError:
        """Return a FileError at a byte offset."""
        return FileError(self.path, what, todo, self.line(min(offset, len(self.data))))

    def number(self, token: bytes, offset: int) -> float:
        """Convert a token to a finite float. Raises FileError."""
        # float() also accepts forms that files must not have: 1_000, nan, infinity.
        if not _NUMBER.fullmatch(token):
            raise self.error(offset, f'"{show(token)}" is not a number')
        value = float(token)
        if abs(value) > LARGEST:
            raise self.error(offset, f'"{show(token)}" is too large a number')
        return value

    def integer(self, token: bytes, offset: int) -> int:
        """Convert a token to an int. Raises FileError."""
        # The digit test comes first because it is faster than the regular expression.
        if not (token.isdigit() and len(token) < 19 or _WHOLE.fullmatch(token)):
            raise self.error(offset, f'"{show(token)}" is not a whole number')
        return int(token)


def check_points(path: Path, points: Floats) -> None:
    """Check that the coordinates (n, 3) of a binary file are finite and not too large.

    Raises FileError.
    """
    bad = np.flatnonzero(~(np.abs(points) <= LARGEST).all(axis=1))
    if len(bad):
        what = f"point {bad[0]} has a coordinate that is not a finite number, or too large"
        raise FileError(path, what, "export the file again")


def show(token: bytes) -> str:
    """Return a token of a file in a short, printable form for messages."""
    text = token[:20].decode("ascii", "replace")
    return "".join(c if c.isprintable() else "?" for c in text)


@dataclass(frozen=True)
class CoordinateText:
    """The location of each coordinate in a text file.

    data has the file, spans (n, 3, 2) int64 the byte offsets (begin, end), and values (n, 3) the
    numbers.
    """

    data: bytes
    spans: Ints
    values: Floats

    def rewritten(self, positions: Floats) -> bytes:
        """Return the file with positions (n, 3); an unchanged coordinate keeps its text.

        A changed one gets the shortest text of the same double, with at most 17 digits.
        """
        order, pieces = self._pieces
        changed = np.flatnonzero((positions.ravel() != self.values.ravel())[order])
        numbers = positions.ravel()[order[changed]].tolist()
        texts = "\n".join(map(repr, numbers)).encode().split(b"\n")
        found = [*pieces]
        for k, text in zip((2 * changed + 1).tolist(), texts):
            found[k] = text
        return b"".join(found)

    @cached_property
    def _pieces(self) -> tuple[Ints, list[bytes]]:
        """The coordinates (3 n,) in file order, and the bytes before, at and between them."""
        spans = self.spans.reshape(-1, 2)
        order = np.argsort(spans[:, 0], kind="stable")
        ends = [0, *spans[order].ravel().tolist(), len(self.data)]
        return order, [self.data[begin:end] for begin, end in zip(ends, ends[1:])]

    @cached_property
    def _words(self) -> tuple[list[bytes], list[int]] | None:
        """The words of the file, and the indices of the coordinates among them.

        None if a coordinate is only a part of a word.
        """
        found = list(TOKEN.finditer(self.data))
        places = {word.span(): k for k, word in enumerate(found)}
        try:
            own = [places[begin, end] for begin, end in self.spans.reshape(-1, 2).tolist()]
        except KeyError:
            return None
        return [word.group() for word in found], own

    def read_again(self, data: bytes) -> Floats | None:
        """Return coordinates (n, 3) of a file with new numbers; None if another word differs."""
        if self._words is None:
            return None
        before, own = self._words
        words = data.split()
        if len(words) != len(before):
            return None
        numbers = [words[k] for k in own]
        for k in own:
            words[k] = before[k]
        if words != before or not all(map(_NUMBER.fullmatch, numbers)):
            return None
        values = np.array(list(map(float, numbers)))
        return values.reshape(-1, 3) if (np.abs(values) <= LARGEST).all() else None


class TextPartFile(PartFile):
    """A text format with separate coordinate tokens: OBJ, OFF, text PLY."""

    def __init__(self, path: Path, mesh: PartMesh, text: CoordinateText, missing: Iterable[str]):
        super().__init__(path, mesh)
        self._text = text
        self.missing += missing

    def save(self, path: Path, positions: Floats) -> None:
        path.write_bytes(self._text.rewritten(positions))

    def stored_positions(self, path: Path) -> Floats:
        # The file differs from the written one only in numbers, so a full parse is rarely needed.
        found = self._text.read_again(read_bytes(path))
        return type(self).read(path).mesh.points if found is None else found

    @classmethod
    def read(cls, path: Path) -> TextPartFile:
        """Read a file of this format. Raises FileError."""
        return cls(path, *cls.parse(Source.of_text(path)))

    @classmethod
    @abstractmethod
    def parse(cls, source: Source) -> tuple[PartMesh, CoordinateText, list[str]]:
        """Return the mesh, the locations of its coordinates, and PartFile.missing.

        Raises FileError.
        """
