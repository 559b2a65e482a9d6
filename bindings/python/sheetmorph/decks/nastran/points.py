# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points with three coordinates in fields of a card, collected into blocks."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from ..model import FIXED, FREE, PADDED, Block, Raw
from ..numbers import parse_real
from .cards import Card, Field


# Line, node, system, values, and begins, widths, leads of the three fields.
_Row = tuple[int, int, int, list[float | None], list[int], list[int], list[int]]


class Points:
    """Points of one file; those in the same form become one block."""

    def __init__(self, raw: Raw, file: int):
        self._raw = raw
        self._file = file
        self._rows: dict[tuple[int, int], list[_Row]] = defaultdict(list)

    def add(self, card: Card, node: int, system: int, fields: list[Field]) -> None:
        """Add a point with an id, in a coordinate system and three fields of a card."""
        values = [parse_real(field.text) for field in fields]
        for field, value in zip(fields, values):
            if value is None:
                what = f'node {node}: "{field.text.strip()}" is not a number'
                line = self._raw.texts[self._file].line_of(field.begin)
                raise self._raw.error((self._file, line), what)
        kind, room = self._layout(card, fields)
        begins = [field.begin for field in fields]
        widths = [field.width for field in fields]
        leads = self._leads(fields)
        row = (card.line, node, system, values, begins, widths, leads)
        self._rows[kind, room].append(row)

    @staticmethod
    def _layout(card: Card, fields: list[Field]) -> tuple[int, int]:
        """Return kind and room of a point."""
        width = 16 if card.is_large else 8
        if any(field.kind == "free" for field in fields):
            longest = max(len(field.text.strip()) for field in fields)
            return FREE, 16 if width == 16 or longest > 8 else 8
        if all(field.kind == "fixed" for field in fields):
            return FIXED, width
        return PADDED, width

    def _leads(self, fields: list[Field]) -> list[int]:
        """Return the filler before missing fields, for full fields before them."""
        leads, before = [], -1
        text = self._raw.texts[self._file]
        for axis, field in enumerate(fields):
            if field.width or not field.lead:
                leads.append(0)
                continue
            line = text.line_of(field.begin)
            before = text.line_of(fields[axis - 1].begin) if axis else -1
            if axis == 0 or before != line:
                leads.append(field.lead)
            elif field.kind == "free":
                leads.append(1)
            else:
                leads.append(0)
        return leads

    def blocks(self) -> list[Block]:
        """Return the collected blocks."""
        return [self._block(kind, room, rows) for (kind, room), rows in self._rows.items()]

    def _block(self, kind: int, room: int, rows: list[_Row]) -> Block:
        lines, ids, systems, values, begins, widths, leads = zip(*rows)
        some = {
            (row, axis): lead
            for row, three in enumerate(leads)
            for axis, lead in enumerate(three)
            if lead
        }
        return Block(
            self._file, np.array(lines, np.int32), np.array(ids, np.int64), np.array(values),
            np.array(begins, np.int64), np.array(widths, np.uint8), room, kind,
            np.array(systems, np.int32), some,
        )  # fmt: skip
