# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cards that move, create or renumber nodes after reading; such decks can only be copied."""

from __future__ import annotations

from .deck import Deck
from .model import Place, Raw

_MOVES = "moves nodes after they are read"
_MERGES = "merges nodes after they are read"
_MAKES = "generates nodes from others at other places"
_ANEW = "moves or renumbers what it includes"
# For each format the start of a card name, and the action of the solver.
_REASONS = {
    "LS-DYNA": {
        "NODE_TRANSFORM": _MOVES,
        "NODE_MERGE": _MERGES,
        "NODE_RIGID_SURFACE": "takes nodes from another file",
        "NODE_SCALAR": "generates nodes without positions",
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
    """Record a card at (file, line) that changes node positions; return whether it does."""
    for begin, reason in _REASONS[raw.form].items():
        if name == begin or name.startswith((f"{begin}_", f"{begin}/")):
            remember_placing(raw, name, place, reason)
            return True
    return False


def remember_placing(raw: Raw, name: str, place: tuple[int, int], reason: str = _ANEW) -> None:
    """Record that a card changes positions or numbers of nodes."""
    raw.placing.append(Place(f"{_MARKS[raw.form]}{name}", 0, *place, reason))
    # Ids that are shifted later may appear twice.
    raw.wins = "last"


def require_places(deck: Deck) -> None:
    """Check that the nodes of a deck stay at their written positions. Raises FileError."""
    if not deck.raw.placing:
        return
    card = deck.raw.placing[0]
    count = len(deck.raw.placing) - 1
    more = f" ({count} more such card{'s' if count > 1 else ''} in the deck)" if count else ""
    what = f"{card.card} {card.what}{more}: the deck can be copied, its shapes cannot be changed"
    todo = (
        "write the nodes at their final positions with the solver or its "
        "pre-processor, without the card"
    )
    raise deck.texts[card.file].error(card.line, what, todo)
