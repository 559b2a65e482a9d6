# SPDX-License-Identifier: LGPL-2.1-or-later
"""Position-dependent data of a Nastran deck that stay unchanged when nodes move."""

from __future__ import annotations

from ..model import Place
from .cards import Card

_SYSTEM = "a coordinate system by coordinates stays where it is"
STALE = {
    **{f"CORD2{kind}": _SYSTEM for kind in "RCS"},
    "CTRIA3": "its material angle or offset stays unchanged",
    "CQUAD4": "its material angle or offset stays unchanged",
    "CONM1": "its mass matrix stays unchanged",
    "CONM2": "its inertia and offset stay unchanged",
    "CBEAM": "its offsets and orientation stay unchanged",
    "CBAR": "its offsets and orientation stay unchanged",
    "ACCEL": "its places stay unchanged",
    "TEMPN1": "a mapped field",
    "CAERO1": "its corners are coordinates",
    "DMIG": "a matrix of the undeformed shape",
    "DMI": "a matrix of the undeformed shape",
    "DMIGROT": "a matrix of the undeformed shape",
    "INITS": "an initial stress of the undeformed shape",
}
# First field with data that a moved node makes stale.
_FROM = {"CTRIA3": 5, "CQUAD4": 6, "CONM2": 4, "CBEAM": 10, "CBAR": 10}
# Bars: the orientation is a vector in three fields, or a node number, which stays valid.
_ORIENTED = {"CBEAM": 4, "CBAR": 4}


def stale_of(file: int, name: str, cards: list[Card]) -> list[Place]:
    """Return the cards with one name that moved nodes make stale."""
    if name not in STALE:
        return []
    first = _FROM.get(name, 0)
    return [
        Place(name, card.number(0), file, card.line, STALE[name])
        for card in cards
        if any(_says_something(card, k) for k in range(first, len(card.fields)))
        or (card.name in _ORIENTED and _has_vector(card, _ORIENTED[card.name]))
    ]


def _says_something(card: Card, position: int) -> bool:
    text = card.text(position)
    if card.name in ("CTRIA3", "CQUAD4"):
        return bool(text.strip("0.+- ")) and position < 8
    return bool(text.strip("0.+- "))


def _has_vector(card: Card, at: int) -> bool:
    return "." in card.text(at) or any(card.text(at + k) for k in (1, 2))
