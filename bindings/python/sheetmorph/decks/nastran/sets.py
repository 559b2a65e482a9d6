# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in a Nastran deck: SET, SET1 and SET3, and property names in comments."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ..model import NamedSet
from ..text import DeckText
from .cards import Card
from .table import CARDS

_SET = re.compile(r"^\s*SET\s+(\d+)\s*=\s*(.*)$", re.IGNORECASE)
_LARGEST = 100_000_000
# Members of SET3; other kinds are not regions of a mesh.
_KINDS = {"GRID": "nodes", "POINT": "nodes", "ELEM": "elements", "ELEMENT": "elements"}


# Comments of HyperMesh, Femap and ANSA; HyperMesh components are alternative property names.
_NAMES = (
    rb'^\$HMNAME\s+COMP\s+(\d+)\s*"([^"\r\n]*)"',
    rb"^\$ANSA_NAME_COMMENT;(\d+);PSHELL;([^;\r\n]*);",
    rb"^\$ Femap Property (\d+) : ([^\r\n]*)",
    rb'^\$HMNAME\s+PROP\s+(\d+)\s*"([^"\r\n]*)"',
)


def comment_names(text: DeckText) -> dict[int, str]:
    """Return the property names in comments."""
    return {
        int(mark.group(1)[:18]): mark.group(2).decode("latin-1").strip()
        for pattern in _NAMES
        for mark in text.matches(pattern)
    }


def control_sets(text: DeckText, end: int) -> Iterator[NamedSet]:
    """Yield the sets of the case control, before a line."""
    whole = ""
    for number in range(end):
        body = text.line(number).split("$", 1)[0].rstrip()
        whole = whole + body.strip() if whole else body
        if whole.endswith(","):
            continue
        if match := _SET.match(whole):
            yield NamedSet(
                f"SET {match.group(1)}", "", _listed(re.split(r"[,\s]+", match.group(2)))
            )
        whole = ""


def card_sets(cards: Sequence[Card]) -> Iterator[NamedSet]:
    """Yield the sets of SET1 and SET3 cards."""
    for card in cards:
        layout = CARDS[card.name]
        kind = _KINDS.get(card.text(layout["kind"][0]).upper(), "") if "kind" in layout else ""
        if "kind" not in layout or kind:
            fields = [card.text(k) for k in range(layout["members"][0], len(card.fields))]
            yield NamedSet(f"SET {card.text(0)}", kind, _listed(fields))


def _listed(words: Sequence[str]) -> list[int]:
    """Return the ids of a list with THRU between the ends of a range."""
    found: list[int] = []
    is_range = False
    for word in words:
        if word.upper() == "THRU":
            is_range = bool(found)
        elif word.isdecimal() and len(word) < 10:
            last = int(word)
            start = found[-1] + 1 if is_range else last
            found += range(start, min(last, start + _LARGEST) + 1)
            is_range = False
        elif word.upper() in ("EXCEPT", "BY"):
            break  # exclusions and steps are not supported
    return found
