# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bytes of a deck file, its lines, and its bytes with some numbers replaced."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..base.arrays import Codes, Ints
from ..base.blocks import chunks
from ..base.errors import FileError

_BLANK = 32
_UTF_8, _UTF_16 = b"\xef\xbb\xbf", (b"\xff\xfe", b"\xfe\xff")


class DeckText:
    """A file of a deck.

    path is shown to the user. mark is a leading byte order mark or empty, and data has the bytes
    after it. codes (n,) has them as uint8. begins and ends (l,) are the offsets of its lines
    without line ends (LF, CR LF or CR). Raises FileError for UTF-16.
    """

    def __init__(self, path: Path, data: bytes):
        self.path = path
        if data[:2] in _UTF_16:
            what = "the file is text in UTF-16, which no solver reads"
            raise FileError(path, what, "save it as UTF-8 or ASCII")
        self.mark = _UTF_8 if data.startswith(_UTF_8) else b""
        data = self.data = data[len(self.mark) :]
        self.codes = np.frombuffer(data, np.uint8)
        newline = 10 if b"\n" in data else 13
        kind = np.int32 if len(data) < 2**31 - 1 else np.int64
        stops = _offsets_of(self.codes, newline).astype(kind)
        if len(data) and (not len(stops) or stops[-1] != len(data) - 1):
            stops = np.append(stops, np.array([len(data)], kind))
        self.begins = np.concatenate(
            [np.zeros(min(1, len(stops)), kind), stops[:-1] + np.ones(1, kind)]
        )
        self.ends = stops
        if newline == 10 and b"\r" in data:
            filled = stops > self.begins
            back = filled & (self.codes[np.maximum(stops - 1, 0)] == 13)
            self.ends = stops - back.astype(kind)

    def __len__(self) -> int:
        return len(self.begins)

    @property
    def name(self) -> str:
        """Printable file name, even if its bytes are not valid text."""
        return os.fsencode(self.path.name).decode("utf-8", "backslashreplace")

    @property
    def whole(self) -> bytes:
        """All bytes of the file."""
        return self.mark + self.data

    def line(self, number: int) -> str:
        """Return the line with an index, without its line end."""
        return self.data[self.begins[number] : self.ends[number]].decode("latin-1")

    def line_of(self, offset: int) -> int:
        """Return the index of the line with a byte."""
        return max(int(np.searchsorted(self.begins, offset, side="right")) - 1, 0)

    def first_per_line(self, code: int) -> Ints:
        """Return the first offset of a character in every line (l,), or the end of the line."""
        found = _offsets_of(self.codes, code).astype(self.begins.dtype)
        if not len(found):
            return self.ends
        found = np.append(found, np.iinfo(found.dtype).max)
        first = self.ends.copy()
        for part in chunks(len(first)):
            place = np.searchsorted(found, self.begins[part])
            first[part] = np.minimum(found[place], first[part])
        return first

    def columns(self, begins: Ints, ends: Ints, width: int) -> Codes:
        """Return character codes (n, width) from offsets (n,); all after `ends` (n,) is blank."""
        at = begins[:, None].astype(np.int64) + np.arange(width)
        inside = at < ends[:, None]
        found = self.codes[np.where(inside, at, 0)] if len(self.codes) else inside.astype(np.uint8)
        return np.where(inside, found, np.uint8(_BLANK))

    def matches(self, pattern: bytes) -> list[re.Match[bytes]]:
        """Return the matches of a pattern, with the flags i and m."""
        return list(re.finditer(pattern, self.data, re.IGNORECASE | re.MULTILINE))

    def error(self, line: int, what: str, todo: str = "correct the card") -> FileError:
        """Return a FileError at a line, from 0."""
        return FileError(self.path, what, todo, int(line) + 1)


def _offsets_of(codes: Codes, code: int) -> Ints:
    size = 1 << 20
    kind = np.int32 if len(codes) < 2**31 - 1 else np.int64
    found = [
        (np.flatnonzero(codes[at : at + size] == code) + at).astype(kind)
        for at in range(0, len(codes), size)
    ]
    return np.concatenate(found) if found else np.empty(0, dtype=kind)


Edit = tuple[Ints, Ints, list[bytes]]


def write_edited(text: DeckText, out: BinaryIO, blocks: Iterable[Edit]) -> None:
    """Write a file with some of its bytes replaced.

    blocks has offsets (n,), lengths (n,) and new texts, in ascending order of the offsets.
    """
    done = 0
    out.write(text.mark)
    for begins, widths, texts in blocks:
        pieces = []
        for begin, width, new in zip(begins.tolist(), widths.tolist(), texts):
            pieces += [text.data[done:begin], new]
            done = begin + width
        out.write(b"".join(pieces))
    out.write(memoryview(text.data)[done:])
