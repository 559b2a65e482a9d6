# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bytes of a deck's file, its lines, and the same bytes with some numbers written anew."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import BinaryIO

import numpy as np

from ..arrays import Codes, Ints
from ..blocks import chunks
from ..errors import FileError

_BLANK = 32
_UTF_8, _UTF_16 = b"\xef\xbb\xbf", (b"\xff\xfe", b"\xfe\xff")


class DeckText:
    """A file of a deck.

    path: the place people know; mark: a byte order mark in front of it, or nothing; data: its bytes
    behind that; codes: the same as (n,) uint8; begins, ends: (l,) offsets in them of its lines,
    their ends (LF, CR LF or CR) left out. Raises FileError for text in UTF-16.
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
        """The file's name as it can be shown, whatever bytes the disk has for it."""
        return os.fsencode(self.path.name).decode("utf-8", "backslashreplace")

    @property
    def whole(self) -> bytes:
        """All bytes of the file."""
        return self.mark + self.data

    def line(self, number: int) -> str:
        """The line with an index, without its end."""
        return self.data[self.begins[number] : self.ends[number]].decode("latin-1")

    def line_of(self, offset: int) -> int:
        """The index of the line with a byte."""
        return max(int(np.searchsorted(self.begins, offset, side="right")) - 1, 0)

    def first_per_line(self, code: int) -> Ints:
        """(l,) the first offset of a character in every line, its end where it has none."""
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
        """(n, width) character codes from offsets (n,) on; behind `ends` (n,) all is blank."""
        at = begins[:, None].astype(np.int64) + np.arange(width)
        inside = at < ends[:, None]
        found = self.codes[np.where(inside, at, 0)] if len(self.codes) else inside.astype(np.uint8)
        return np.where(inside, found, np.uint8(_BLANK))

    def matches(self, pattern: bytes) -> list[re.Match[bytes]]:
        """Where a pattern, with the flags i and m, is found."""
        return list(re.finditer(pattern, self.data, re.IGNORECASE | re.MULTILINE))

    def error(self, line: int, what: str, todo: str = "correct the card") -> FileError:
        """A FileError at a line, from 0."""
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
    """Write a file with some of its bytes exchanged.

    blocks: offsets of what is replaced (n,), lengths (n,), and what is put there; all in the order
    of the offsets.
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
