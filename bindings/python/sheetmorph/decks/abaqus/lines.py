# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of an input file: keywords with options, and data."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...base.arrays import Ints
from ...base.blocks import chunks
from ..model import Raw
from ..numbers import parse_integer, parse_real


@dataclass(frozen=True)
class Keyword:
    """A keyword.

    name is in capitals with single blanks. options maps names in capitals to values. line counts
    from 0. rows are its data lines without comments and blank lines.
    """

    name: str
    options: dict[str, str]
    line: int
    rows: Ints


class AbaqusLines:
    """The lines of one file."""

    def __init__(self, raw: Raw, file: int):
        self.raw = raw
        self.file = file
        self.text = raw.texts[file]
        text = self.text
        codes = np.empty((2, len(text)), dtype=np.uint8)
        for part in chunks(len(text)):
            codes[:, part] = text.columns(text.begins[part], text.ends[part], 2).T
        first, second = codes
        # Blanks may precede any text.
        loose = np.flatnonzero((first == 32) & (text.ends > text.begins) | (first == 9))
        for line in loose.tolist():
            shown = text.line(line).lstrip()
            first[line] = ord(shown[0]) if shown and ord(shown[0]) < 256 else 32
            second[line] = ord(shown[1]) if len(shown) > 1 and ord(shown[1]) < 256 else 32
        is_star = first == ord("*")
        self._heads = np.flatnonzero(is_star & (second != ord("*")))
        self._is_data = ~is_star & (first != 32)

    @property
    def has_keywords(self) -> bool:
        """Whether the file has keywords."""
        return len(self._heads) > 0

    def data_rows(self) -> Ints:
        """Return all data lines."""
        return np.flatnonzero(self._is_data).astype(np.int32)

    def keywords(self) -> Iterator[Keyword]:
        """Yield the keywords of the file in order."""
        ends = np.append(self._heads[1:], len(self.text))
        for line, end in zip(self._heads.tolist(), ends.tolist()):
            shown, begin = self.text.line(line).strip(), line + 1
            while shown.endswith(",") and begin < end:
                shown += self.text.line(begin).strip()
                begin += 1
            name, options = _options(shown)
            rows = np.flatnonzero(self._is_data[begin:end]).astype(np.int32)
            rows += np.int32(begin)
            yield Keyword(name, options, line, rows)

    def reals(self, line: int) -> list[float | None]:
        """Return the numbers of a data line, None for any other field."""
        words = self.text.line(line).strip().rstrip(",").split(",")
        return [parse_real(word) for word in words]

    def numbers(self, line: int) -> list[int] | None:
        """Return the integers of a data line, or None if it has other fields."""
        words = [word.strip() for word in self.text.line(line).split(",")]
        found = [parse_integer(word) for word in words if word]
        sound = [number for number in found if number is not None]
        return sound if len(sound) == len(found) else None

    def words(self, line: int) -> list[str]:
        """Return the fields of a data line in capitals."""
        return [word.strip().upper() for word in self.text.line(line).split(",")]


def _options(shown: str) -> tuple[str, dict[str, str]]:
    parts = shown[1:].split(",")
    name = re.sub(r"\s+", " ", parts[0].strip().upper())
    options = {}
    for part in parts[1:]:
        key, _, value = part.partition("=")
        key = re.sub(r"\s+", " ", key.strip().upper())
        if key:
            options[key] = value.strip().strip('"')
    return _NAMES.get(name.replace(" ", ""), name), options


# Names that may be written without their blanks.
_NAMES = {
    name.replace(" ", ""): name
    for name in ("END PART", "END INSTANCE", "SHELL SECTION", "RIGID BODY", "INITIAL CONDITIONS",
                 "KINEMATIC COUPLING", "NODAL THICKNESS")
}  # fmt: skip
