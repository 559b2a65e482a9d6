# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bulk data lines as cards of fields: small and large fixed fields, and free (comma) fields."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ...base.arrays import Bools, Ints
from ...base.blocks import chunks
from ..numbers import parse_integer, parse_real
from ..text import DeckText


class Field(NamedTuple):
    """The text of a field with its location.

    begin and width are offset and length of its existing part. lead is the number of blanks or
    commas missing between the end of a short line and the field. room is its largest number of
    characters. kind is "fixed", "free" or "tab" (fixed, in a line with tabs).
    """

    text: str
    begin: int
    width: int
    lead: int
    room: int
    kind: str


@dataclass
class Card:
    """A card.

    name has no `*`. line is the index of its first line. fields has all fields after the name.
    is_large means 16 characters per field, and is_free commas between fields. lines is the number
    of lines.
    """

    name: str
    line: int
    is_large: bool
    is_free: bool
    fields: list[Field]
    lines: int = 1

    def text(self, position: int) -> str:
        """Return the stripped text of a field (0: after the name), "" if it is missing."""
        return self.fields[position].text.strip() if position < len(self.fields) else ""

    def number(self, position: int) -> int:
        """Return the integer in a field, 0 if it is blank or invalid."""
        return parse_integer(self.text(position)) or 0

    def real(self, position: int) -> float:
        """Return the number in a field, 0 if it is blank or invalid."""
        return parse_real(self.text(position)) or 0.0


@dataclass(frozen=True)
class Lines:
    """Bulk data lines by type.

    first and end give the range of lines. heads (l,) has the card names in capitals as 8 bytes, b""
    for comments and blank lines, and b"+" for continuations. plain (l,) marks lines with columns
    and without tabs. stops (n,) has the end of the text in each line of the file, without comments.
    """

    first: int
    end: int
    heads: np.ndarray[Any, np.dtype[np.bytes_]]
    plain: Bools
    stops: Ints


def sorted_lines(text: DeckText, first: int, end: int) -> Lines:
    """Classify the lines of a range."""
    stops = text.first_per_line(ord("$"))
    tabs = text.first_per_line(9) < stops
    commas = text.first_per_line(ord(","))
    heads = np.zeros(end - first, dtype="S8")
    plain = np.zeros(end - first, dtype=bool)
    for part in chunks(end - first):
        rows = np.arange(part.start, part.stop) + first
        begins = text.begins[rows]
        codes = text.columns(begins, stops[rows], 8)
        codes = np.where((codes >= 97) & (codes <= 122), codes - 32, codes).astype(np.uint8)
        free = (commas[rows] < stops[rows]) & (commas[rows] - begins < 10)
        simple = ~free & ~tabs[rows] & (codes[:, 0] != 32)
        names = np.ascontiguousarray(codes).view("S8").ravel()
        names = np.char.rstrip(names)
        is_more = np.isin(codes[:, 0], np.frombuffer(b"+*", np.uint8)) & simple
        names[is_more] = b"+"
        blank = stops[rows] == begins
        for k in np.flatnonzero(~simple & ~blank).tolist():
            names[k] = _name_of(text, int(begins[k]), int(stops[rows[k]]))
        heads[part], plain[part] = names, simple
    return Lines(first, end, heads, plain, stops)


def _name_of(text: DeckText, begin: int, stop: int) -> bytes:
    body = text.data[begin:stop].expandtabs(8)
    if not body.strip():
        return b""
    head = (body.split(b",", 1)[0] if b"," in body[:10] else body[:8]).strip().upper()
    return b"+" if not head or head[:1] in b"+*" else head[:8]


def cards(text: DeckText, lines: Lines, wanted: Ints) -> Iterator[Card]:
    """Yield the cards that begin in ascending lines, with their continuation lines."""
    for number in wanted.tolist():
        name = lines.heads[number - lines.first].decode("latin-1")
        card = _open(text, name, number, int(lines.stops[number]))
        follow = number + 1
        while follow < lines.end:
            head = lines.heads[follow - lines.first]
            if head == b"+":
                _continue(text, card, follow, int(lines.stops[follow]))
                card.lines = follow + 1 - number
            elif head:
                break
            follow += 1
        yield card


def _open(text: DeckText, name: str, number: int, stop: int) -> Card:
    begin = int(text.begins[number])
    body = text.data[begin:stop].decode("latin-1")
    is_free = "," in body[:10]
    is_large = name.endswith("*")
    card = Card(name.rstrip("*"), number, is_large, is_free, [])
    card.fields += _fields(body, begin, is_large)
    return card


def _continue(text: DeckText, card: Card, number: int, stop: int) -> None:
    begin = int(text.begins[number])
    body = text.data[begin:stop].decode("latin-1")
    card.fields += _fields(body, begin, body.startswith("*"))


def _fields(body: str, begin: int, is_large: bool) -> list[Field]:
    """Return the data fields of one line, 8 small or 4 large ones, including blank ones."""
    if "," in body[:10]:
        return _free_fields(body, begin, 4 if is_large else 8)
    if "\t" in body:
        return _tab_fields(body, begin, is_large)
    width, length = (16 if is_large else 8), len(body)
    found = []
    for k in range(4 if is_large else 8):
        at = 8 + k * width
        there = max(0, min(width, length - at))
        place, lead = begin + min(at, length), max(0, at - length)
        found.append(Field(body[at : at + there], place, there, lead, width, "fixed"))
    return found


def _free_fields(body: str, begin: int, count: int) -> list[Field]:
    texts = body.split(",")
    found = []
    at = begin + len(texts[0]) + 1
    for k, text in enumerate(texts[1:]):
        # The tenth field names the continuation; fields after it still belong to the card.
        is_name = k == count and (not text.strip() or text.strip()[0] in "+*")
        if not is_name:
            found.append(Field(text, at, len(text), 0, 0, "free"))
        at += len(text) + 1
    end = begin + len(body)
    missing = count - len(texts) + 1
    return found + [Field("", end, 0, k + 1, 0, "free") for k in range(missing)]


def _tab_fields(body: str, begin: int, is_large: bool) -> list[Field]:
    """Return the fields of a line with tabs; each may have fewer characters than its width."""
    columns, at = [], 0
    for char in body:
        columns.append(at)
        at = (at // 8 + 1) * 8 if char == "\t" else at + 1
    width = 16 if is_large else 8
    found = []
    for k in range(4 if is_large else 8):
        left = 8 + k * width
        inside = [j for j, column in enumerate(columns) if left <= column < left + width]
        start = inside[0] if inside else len(body)
        shown = body[start : start + len(inside)].replace("\t", " ")
        lead = max(0, left - at)
        found.append(Field(shown, begin + start, len(inside), lead, width, "tab"))
    return found
