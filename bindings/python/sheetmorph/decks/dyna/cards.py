# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a keyword file: keywords, their cards, and fields of single cards."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...base.arrays import Bools, Ints
from ..model import Raw

_HEAD = re.compile(r"\*\s*([A-Za-z0-9_\-]*[A-Za-z0-9_])\s*([%+\-]?)(.*)", re.DOTALL)


@dataclass(frozen=True)
class Section:
    """A keyword with its cards.

    name is in capitals without `*`, and suffix is `%`, `+`, `-` or "". rest is the remainder of its
    line. line counts from 0. rows are the lines of its cards without comments.
    """

    name: str
    suffix: str
    rest: str
    line: int
    rows: Ints


class DynaCards:
    """The cards of one file.

    parameters has numbers by name in lower case. width is that of fields outside of nodes and
    elements.
    """

    def __init__(self, raw: Raw, file: int):
        self.raw = raw
        self.file = file
        self.text = raw.texts[file]
        self.stops = self.text.ends
        self.parameters: dict[str, float] = {}
        self.width = 10
        text = self.text
        first = np.zeros(len(text), np.uint8)
        filled = text.ends > text.begins
        first[filled] = text.codes[text.begins[filled]]
        self._keywords = np.flatnonzero(first == ord("*"))
        self._is_card = (first != ord("$")) & (first != ord("*"))
        self._odd = np.zeros(len(text), dtype=bool)
        for code in b",&\t":
            self._odd |= text.first_per_line(code) < text.ends

    @property
    def has_keywords(self) -> bool:
        """Whether the file has keywords."""
        return len(self._keywords) > 0

    def sections(self) -> Iterator[Section]:
        """Yield the keywords of the file in order."""
        ends = np.append(self._keywords[1:], len(self.text))
        for line, end in zip(self._keywords.tolist(), ends.tolist()):
            found = _HEAD.match(self.text.line(line))
            if not found:
                continue
            rows = np.flatnonzero(self._is_card[line + 1 : end]) + line + 1
            name, suffix, rest = found.groups()
            yield Section(name.upper(), suffix, rest, line, rows)

    def filled(self, rows: Ints) -> Ints:
        """Return the lines that are not blank."""
        text = self.text
        blank = text.ends[rows] == text.begins[rows]
        some = np.flatnonzero(
            ~blank & (text.codes[np.minimum(text.begins[rows], len(text.codes) - 1)] == 32)
        )
        for k in some.tolist():
            row = rows[k]
            blank[k] = not text.data[text.begins[row] : text.ends[row]].strip()
        found: Ints = rows[~blank]
        return found

    def plain(self, rows: Ints) -> Bools:
        """Return which lines have fixed columns with numbers only."""
        return ~self._odd[rows]

    def fields(self, line: int, width: int) -> list[str]:
        """Return the fields of a card, at least ten."""
        shown = self.text.line(line)
        if "," in shown:
            texts = shown.split(",")
        else:
            shown = shown.expandtabs(8)
            texts = [shown[at : at + width] for at in range(0, max(len(shown), 1), width)]
        return [self.value(text) for text in texts] + [""] * 10

    def places(self, line: int, widths: Sequence[int]) -> list[tuple[str, int, int]]:
        """Return (text, offset, length) of the fields of a card.

        Missing fields have a negative offset.
        """
        shown = self.text.line(line)
        begin, found, at = int(self.text.begins[line]), [], 0
        if "," in shown:
            for text in shown.split(","):
                found.append((text, begin + at, len(text)))
                at += len(text) + 1
        else:
            for width in widths:
                text = shown[at : at + width]
                found.append((text, begin + at, len(text)))
                at += width
        end = begin + len(shown)
        found = [one if one[1] <= end else ("", -end, 0) for one in found]
        return found + [("", -end, 0)] * (len(widths) - len(found))

    def value(self, text: str) -> str:
        """Return a field with a parameter replaced by its number."""
        stripped = text.strip()
        sign = stripped[:1] if stripped[:1] == "-" else ""
        name = stripped[len(sign) :]
        if not name.startswith("&"):
            return stripped
        number = self.parameters.get(name[1:].strip().lower())
        if number is None:
            return stripped
        number = -number if sign else number
        return str(int(number)) if number == int(number) else repr(number)

    def names(self, section: Section) -> list[tuple[int, str]]:
        """Return the file names in the cards of a keyword; ` +` at the end continues a name."""
        found: list[tuple[int, str]] = []
        goes_on = False
        for line in self.filled(section.rows).tolist():
            shown = self.text.line(line).strip()
            more = shown.endswith(" +")
            shown = shown[:-2].rstrip() if more else shown
            if goes_on:
                found[-1] = (found[-1][0], found[-1][1] + shown)
            else:
                found.append((line, shown))
            goes_on = more
        return found
