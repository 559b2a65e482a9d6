# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran's elements as nodes: shells, solids, lines, rigid elements, masses, welds."""

from __future__ import annotations

import zlib
from collections.abc import Iterator

import numpy as np

from .model import Elements, Raw
from .nastran_cards import Card
from .nastran_points import Points
from .numbers import parse_integer

# What an element is, and in which of its fields (0: behind the name) nodes stand.
ELEMENTS: dict[str, tuple[str, tuple[int, ...]]] = {
    **{name: ("shell", (2, 3, 4)) for name in ("CTRIA3", "CTRIAR", "CPLSTN3", "CPLSTS3")},
    **{name: ("shell", (2, 3, 4, 5)) for name in ("CQUAD4", "CQUADR", "CPLSTN4", "CPLSTS4")},
    "CSHEAR": ("shell", (2, 3, 4, 5)),
    **{name: ("shell", tuple(range(2, 8))) for name in ("CTRIA6", "CPLSTN6", "CPLSTS6")},
    **{name: ("shell", tuple(range(2, 10))) for name in ("CQUAD8", "CPLSTN8", "CPLSTS8")},
    "CQUAD": ("shell", tuple(range(2, 11))),
    "CHEXA": ("solid", tuple(range(2, 22))),
    "CPENTA": ("solid", tuple(range(2, 17))),
    "CPYRAM": ("solid", tuple(range(2, 15))),
    "CTETRA": ("solid", tuple(range(2, 12))),
    **{name: ("line", (2, 3)) for name in ("CBAR", "CBEAM", "CBEND", "CROD", "CTUBE", "CVISC")},
    **{name: ("line", (2, 3)) for name in ("CBUSH", "CBUSH1D", "CGAP", "CELAS3", "CDAMP3")},
    **{name: ("line", (2, 3)) for name in ("CDAMP4", "CELAS4", "CMASS3")},
    **{name: ("line", (2, 4)) for name in ("CELAS1", "CELAS2", "CDAMP1", "CDAMP2")},
    "CBEAM3": ("line", (2, 3, 4)),
    "CONROD": ("line", (1, 2)),
    "PLOTEL": ("line", (1, 2)),
    "CMASS1": ("mass", (2, 4)),
    "CMASS2": ("mass", (2, 4)),
    "CONM1": ("mass", (1,)),
    "CONM2": ("mass", (1,)),
    "RBAR": ("rigid", (1, 2)),
    "RROD": ("rigid", (1, 2)),
    "RTRPLT": ("rigid", (1, 2, 3)),
    **{name: ("rigid", ()) for name in ("RBE1", "RBE2", "RBE3", "MPC")},
    **{name: ("weld", ()) for name in ("CWELD", "CFAST", "CSEAM")},
    **{f"CORD1{kind}": ("frame", (1, 2, 3)) for kind in "RCS"},
}
_ENDS = ("ALPHA", "UM")


def elements_of(raw: Raw, file: int, name: str, cards: list[Card]) -> list[Elements]:
    """The elements that cards of one name make. Raises FileError."""
    if name not in ELEMENTS:
        return []
    kind, places = ELEMENTS[name]
    rows = [
        (card.number(at), card.line, nodes)
        for card in cards
        for at, nodes in _nodes(raw, file, card, places)
    ]
    width = max((len(nodes) for _, _, nodes in rows), default=0)
    if not width:
        return []
    nodes = np.zeros((len(rows), width), dtype=np.int64)
    for k, (_, _, some) in enumerate(rows):
        nodes[k, : len(some)] = some
    ids = np.array([number for number, _, _ in rows], dtype=np.int64)
    has_property = kind in ("shell", "solid") or name in ("CBAR", "CBEAM", "CROD", "CBUSH")
    given = np.array([card.number(1) if has_property else 0 for card in cards], dtype=np.int64)
    properties = np.where(given, given, ids) if len(given) == len(ids) else np.zeros_like(ids)
    lines = np.array([line for _, line, _ in rows], dtype=np.int32)
    return [Elements(name, kind, ids, properties, nodes, file, lines)]


def _nodes(
    raw: Raw, file: int, card: Card, places: tuple[int, ...]
) -> Iterator[tuple[int, list[int]]]:
    """Where the id of each element of a card stands, and its nodes."""
    if card.name.startswith("CORD1"):
        for at in (0, 4):
            if card.text(at):
                yield at, [_node(raw, file, card, at + k) for k in places]
        return
    at = 1 if card.name == "MPC" else 0
    find = _VARIED.get(card.name)
    found = list(find(card)) if find else list(places)
    own = _own_points(card) if card.name in _POINTS else []
    yield at, [_node(raw, file, card, k) for k in found] + own


def _node(raw: Raw, file: int, card: Card, position: int) -> int:
    text = card.text(position)
    number = parse_integer(text) if text else 0
    if number is None:
        what = f'{card.name}: "{text}" in field {position + 2} is not a whole number'
        raise raw.error((file, card.line), what)
    return max(number, 0)


def _rbe2(card: Card) -> Iterator[int]:
    yield 1
    last = len(card.fields)
    for k in range(3, last):
        # The thermal expansion, a real number, may end the list.
        if card.text(k) and "." not in card.text(k) and card.text(k).upper() != "THRU":
            yield k


def _rbe3(card: Card) -> Iterator[int]:
    """The reference node, then weights (real), components and nodes (whole numbers)."""
    yield 2
    is_component, in_list = False, True
    for k in range(4, len(card.fields)):
        text = card.text(k)
        if text.upper() == "UM":
            return
        if text.upper() == "ALPHA":
            in_list = False
        if not in_list or not text:
            continue
        is_weight = parse_integer(text) is None
        if not is_weight and not is_component:
            yield k
        is_component = is_weight


def _rbe1(card: Card) -> Iterator[int]:
    k = 1
    while k < len(card.fields):
        text = card.text(k).upper()
        if text in _ENDS or "." in text:
            if text == "ALPHA":
                return
            k += 1
            continue
        if text:
            yield k
            k += 2
        else:
            k += 1


def _mpc(card: Card) -> Iterator[int]:
    # SID G1 C1 A1 G2 C2 A2 (blank), then (blank) G3 C3 A3 G4 C4 A4 (blank) on every further line.
    for start in range(0, len(card.fields), 8):
        for k in (start + 1, start + 4):
            if card.text(k):
                yield k


def _own_points(card: Card) -> list[int]:
    """The ids of the points that a weld's card has for itself."""
    return [weld_point(card.name, card.number(0), end) for end, _ in _written_points(card)]


def _written_points(card: Card) -> list[tuple[int, tuple[int, ...]]]:
    """Which ends of a weld stand as coordinates in its card, and in which fields."""
    if card.name == "CWELD" and card.text(3).upper() not in ("ELEMID", "ELPAT", "PARTPAT"):
        return []
    if card.text({"CWELD": 2, "CFAST": 5, "CSEAM": 8}[card.name]):
        return []
    return [
        (end, places)
        for end, places in enumerate(_POINTS[card.name])
        if len(card.fields) > places[-1] and any(card.text(place) for place in places)
    ]


def _cweld(card: Card) -> Iterator[int]:
    if card.text(2):
        yield 2
    kind = card.text(3).upper()
    if kind == "ALIGN":
        yield from (4, 5)
    elif kind == "GRIDID":
        yield from (k for k in range(16, len(card.fields)) if card.text(k))


def _cfast(card: Card) -> Iterator[int]:
    yield from (k for k in (5, 6, 7) if card.text(k))


def _cseam(card: Card) -> Iterator[int]:
    yield from (k for k in (8, 9) if card.text(k))


_VARIED = {
    "RBE1": _rbe1,
    "RBE2": _rbe2,
    "RBE3": _rbe3,
    "MPC": _mpc,
    "CWELD": _cweld,
    "CFAST": _cfast,
    "CSEAM": _cseam,
}
# Where coordinates of points without a node stand.
_POINTS = {"CWELD": ((16, 17, 18),), "CFAST": ((8, 9, 10),), "CSEAM": ((16, 17, 18), (19, 20, 21))}


def add_weld_points(points: Points, card: Card) -> None:
    """The points of a weld that stand as coordinates in its card, each as a node of its own.

    Such a node has an id below zero, made from the card, the element and the point.
    """
    for end, places in _written_points(card):
        fields = [card.fields[place] for place in places]
        points.add(card, weld_point(card.name, card.number(0), end), 0, fields)


def weld_point(name: str, element: int, end: int) -> int:
    """The id, below zero, of a weld's point that has no node."""
    return -((zlib.crc32(name.encode()) % 97 + 1) * 10**10 + 2 * element + end)
