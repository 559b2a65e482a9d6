# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cards that move, make or number nodes after they are read: such a deck is copied, not morphed."""

from __future__ import annotations

from .deck import Deck
from .model import Place, Raw

_MOVES = "moves nodes after they are read"
_MERGES = "merges nodes after they are read"
_MAKES = "makes nodes of others in other places"
_ANEW = "moves or numbers anew what it includes"
# By format: what a name begins with, and what the solver does then.
_REASONS = {
    "LS-DYNA": {
        "NODE_TRANSFORM": _MOVES,
        "NODE_MERGE": _MERGES,
        "NODE_RIGID_SURFACE": "takes nodes from another file",
        "NODE_SCALAR": "makes nodes without places",
        "PART_MOVE": _MOVES,
        "CONTROL_FORMING_AUTOPOSITION": _MOVES,
        "CONTROL_FORMING_POSITION": _MOVES,
    },
    "Abaqus": {
        "NMAP": _MOVES,
        "NCOPY": _MAKES,
        "ADJUST": _MOVES,
        "SYMMETRIC MODEL GENERATION": _MAKES,
    },
    "Radioss": {
        "TRANSFORM": _MOVES,
        "CNODE": "places nodes that are merged with others",
        "MERGE": _MERGES,
    },
    "Nastran": {"SELOC": _MOVES, "MDMOVE": _MOVES, "SEMPLN": _MOVES},
}  # fmt: skip
NASTRAN = frozenset(_REASONS["Nastran"])
_MARKS = {"LS-DYNA": "*", "Abaqus": "*", "Radioss": "/", "Nastran": ""}


def note_placing(raw: Raw, name: str, place: tuple[int, int]) -> bool:
    """Remember a card at (file, line) that changes where nodes are; whether it is one."""
    for begin, reason in _REASONS[raw.form].items():
        if name == begin or name.startswith((f"{begin}_", f"{begin}/")):
            remember_placing(raw, name, place, reason)
            return True
    return False


def remember_placing(raw: Raw, name: str, place: tuple[int, int], reason: str = _ANEW) -> None:
    """The deck has a card by which its nodes are elsewhere, or called otherwise, than written."""
    raw.placing.append(Place(f"{_MARKS[raw.form]}{name}", 0, *place, reason))
    # Numbers that are shifted later may well be there twice.
    raw.wins = "last"


def require_places(deck: Deck) -> None:
    """Nothing if the nodes of a deck are where it writes them. Raises FileError otherwise."""
    if not deck.raw.placing:
        return
    card = deck.raw.placing[0]
    count = len(deck.raw.placing) - 1
    more = f" ({count} more such card{'s' if count > 1 else ''} in the deck)" if count else ""
    what = f"{card.card} {card.what}{more}: the deck can be copied, its shapes cannot be changed"
    todo = "let the solver or its pre-processor write the nodes where they end up, without the card"
    raise deck.texts[card.file].error(card.line, what, todo)
