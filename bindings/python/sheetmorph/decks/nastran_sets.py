# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sets of a Nastran deck: SET of the case control, SET1 and SET3 of the bulk data."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from .model import NamedSet
from .nastran_cards import Card
from .text import DeckText

_SET = re.compile(r"^\s*SET\s+(\d+)\s*=\s*(.*)$", re.IGNORECASE)
_LARGEST = 100_000_000
# Of SET3: what its ids are of; other kinds are no region of a mesh.
_KINDS = {"GRID": "nodes", "POINT": "nodes", "ELEM": "elements", "ELEMENT": "elements"}


def control_sets(text: DeckText, end: int) -> Iterator[NamedSet]:
    """The sets in the lines of the case control, before a line."""
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
    """The sets of SET1 and SET3 cards."""
    for card in cards:
        skipped = 2 if card.name == "SET3" else 1
        kind = _KINDS.get(card.text(1).upper(), "") if skipped == 2 else ""
        if skipped == 1 or kind:
            fields = [card.text(k) for k in range(skipped, len(card.fields))]
            yield NamedSet(f"SET {card.text(0)}", kind, _listed(fields))


def _listed(words: Sequence[str]) -> list[int]:
    """The ids of a list in which THRU stands between the ends of a range."""
    found: list[int] = []
    is_range = False
    for word in words:
        if word.upper() == "THRU":
            is_range = bool(found)
        elif word.isdigit() and len(word) < 10:
            last = int(word)
            start = found[-1] + 1 if is_range else last
            found += range(start, min(last, start + _LARGEST) + 1)
            is_range = False
        elif word.upper() in ("EXCEPT", "BY"):
            break  # what is left out, or a step: no region can be told from the rest
    return found
