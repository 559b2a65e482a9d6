# SPDX-License-Identifier: LGPL-2.1-or-later
"""*ELEMENT keywords of LS-DYNA."""

from __future__ import annotations

import numpy as np

from ...base.arrays import Ints
from ..cut import Cut, small
from ..model import Elements
from ..numbers import parse_integer
from .cards import DynaCards, Section
from .table import ELEMENTS as KINDS
from .table import SHARED, SOLID_NODES, Element

ELEMENTS = (
    "ELEMENT_SHELL", "ELEMENT_SOLID", "ELEMENT_TSHELL", "ELEMENT_BEAM", "ELEMENT_MASS",
    "ELEMENT_DISCRETE", "ELEMENT_SEATBELT", "ELEMENT_INERTIA", "ELEMENT_PLOTEL",
)  # fmt: skip


_MORE_NODES = {"H20": 20, "H27": 27, "T15": 15, "T20": 20, "P21": 21, "P40": 40, "H64": 64}


def add_elements(cards: DynaCards, section: Section, width: int, _real: int) -> None:
    """Add the elements of a keyword to the deck. Raises FileError."""
    name, _, options = section.name[len("ELEMENT_") :].partition("_")
    known = KINDS.get(name)
    if known is None:
        return
    words = [word for word in options.split("_") if word] if options != "SHL4_TO_SHL8" else []
    strange = [word for word in words if word not in known.options and word not in _MORE_NODES]
    rows = cards.filled(section.rows)
    if strange or not len(rows):
        if strange:
            told = f"{cards.text.name}, line {section.line + 1}: *{section.name} is not read"
            cards.raw.notes.append(told)
        return
    extra = sum(known.options.get(word, 0) for word in words)
    # Thickness, angle and material system share one line.
    extra -= max(0, sum(word in SHARED for word in words) - 1) if name == "SHELL" else 0
    extra += 2 if name == "INERTIA" else 0
    if name == "SOLID":
        _solids(cards, section, rows, (width, extra, words))
        return
    if name == "SHELL" and extra and any(word in SHARED for word in words):
        heads = _shells_with_more(cards, section, rows, (width, extra))
    else:
        heads = _heads(cards, section, rows, 1 + extra)
    _add(cards, section, heads, (known, width))


def _heads(cards: DynaCards, section: Section, rows: Ints, each: int) -> Ints:
    """Return the first line of every element with `each` lines."""
    if len(rows) % each:
        what = (
            f"*{section.name}: {len(rows)} cards are not a multiple of the {each} "
            "cards of an element"
        )
        raise cards.raw.error((cards.file, section.line), what)
    return rows[::each]


def _shells_with_more(
    cards: DynaCards, section: Section, rows: Ints, layout: tuple[int, int]
) -> Ints:
    """Return the first lines of shells with nodal values; mid-side nodes add a line."""
    width, extra = layout
    size = cards.text.ends[rows] - cards.text.begins[rows]
    if not (size > 6 * width).any():
        return _heads(cards, section, rows, 1 + extra)
    heads, at = [], 0
    while at < len(rows):
        heads.append(rows[at])
        fields = cards.fields(int(rows[at]), width)
        has_mid = any((parse_integer(text) or 0) > 0 for text in fields[6:10])
        at += 1 + extra + int(has_mid)
    if at != len(rows):
        return _heads(cards, section, rows[:-1], len(rows) + 1)
    return np.array(heads)


def _add(cards: DynaCards, section: Section, heads: Ints, layout: tuple[Element, int]) -> None:
    known, width = layout
    plain = cards.plain(heads)
    cut = Cut(cards.raw, cards.file, heads[plain], cards.stops, f"*{section.name}")
    first, most = known.nodes.at, known.nodes.count
    size = cards.stops[cut.rows] - cards.text.begins[cut.rows]
    there = int(-(-int(size.max(initial=0)) // width)) - first
    count = max(1, min(most, there))
    ids = cut.integers(0, width)
    has_part = known.part is not None
    at = known.part.at if known.part else 0
    parts = cut.integers(at * width, width, 0) if has_part else np.zeros_like(ids)
    nodes = cut.table(first * width, width, count)
    blocks = [(ids, parts, nodes, cut.rows)] if len(cut.rows) else []
    odd = heads[~plain]
    if len(odd):
        numbers = np.array([_numbers(cards, section, line, (width, most + first)) for line in odd])
        parts = numbers[:, at] if has_part else np.zeros(len(odd), np.int64)
        blocks.append((numbers[:, 0], parts, numbers[:, first : first + most], odd))
    for ids, parts, nodes, rows in blocks:
        nodes = np.maximum(nodes, 0)
        cards.raw.elements.append(
            Elements(
                f"*{section.name}", known.kind, small(ids), small(parts), nodes, cards.file,
                rows.astype(np.int32),
            )
        )  # fmt: skip


def _numbers(cards: DynaCards, section: Section, line: int, layout: tuple[int, int]) -> list[int]:
    """Return the first integers of a card in free fields or with parameters."""
    width, count = layout
    found = []
    for text in cards.fields(int(line), width)[:count]:
        number = parse_integer(text) if text else 0
        if number is None:
            what = f'*{section.name}: "{text}" is not a whole number'
            raise cards.raw.error((cards.file, int(line)), what)
        found.append(number)
    return found + [0] * (count - len(found))


def _solids(
    cards: DynaCards, section: Section, rows: Ints, layout: tuple[int, int, list[str]]
) -> None:
    """Add solids, whose nodes are in the line of the part or in separate lines."""
    width, extra, words = layout
    most = max([_MORE_NODES.get(word, 0) for word in words] or [0])
    each_line = SOLID_NODES.count
    lines = -(-most // each_line) if most else 1
    size = cards.text.ends[rows] - cards.text.begins[rows]
    single = bool(size[0] > 2 * width) and not most
    if single and cards.plain(rows[:1])[0]:
        shown = cards.text.line(int(rows[0]))
        single = bool(shown[2 * width :].strip())
    if single:
        heads = _heads(cards, section, rows, 1 + extra)
        _add(cards, section, heads, (KINDS["SOLID"], width))
        return
    heads = _heads(cards, section, rows, 1 + lines + extra)
    each = 1 + lines + extra
    cut = Cut(cards.raw, cards.file, heads, cards.stops, f"*{section.name}")
    ids, parts = cut.integers(0, width), cut.integers(width, width, 0)
    tables = [
        Cut(
            cards.raw,
            cards.file,
            rows[SOLID_NODES.card + k :: each],
            cards.stops,
            f"*{section.name}",
        ).table(0, width, each_line)
        for k in range(lines)
    ]
    nodes = np.maximum(np.concatenate(tables, axis=1), 0)
    cards.raw.elements.append(
        Elements(
            f"*{section.name}", "solid", small(ids), small(parts), nodes, cards.file,
            heads.astype(np.int32),
        )
    )  # fmt: skip
