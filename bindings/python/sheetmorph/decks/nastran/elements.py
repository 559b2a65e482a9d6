# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran elements as nodes: shells, solids, lines, rigid elements, masses, welds."""

from __future__ import annotations

import zlib
from collections.abc import Iterator

import numpy as np

from ..model import Elements, Raw
from ..numbers import parse_integer
from .cards import Card
from .points import Points
from .table import CARDS, CORNERS, ELEMENTS, WELD_POINTS

_ENDS = ("ALPHA", "UM")


def elements_of(raw: Raw, file: int, name: str, cards: list[Card]) -> list[Elements]:
    """Return the elements of cards with one name. Raises FileError."""
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
    least = CORNERS.get(name, 0)
    for row in np.flatnonzero((nodes[:, :least] == 0).any(axis=1))[:1].tolist() if least else ():
        there = int((nodes[row, :least] != 0).sum())
        raw.miss(file, f"{name} {ids[row]} has {there} of its {least} corners", int(lines[row]))
    return [Elements(name, kind, ids, properties, nodes, file, lines)]


def _nodes(
    raw: Raw, file: int, card: Card, places: tuple[int, ...]
) -> Iterator[tuple[int, list[int]]]:
    """Yield the position of the id of each element in a card, and its nodes."""
    if card.name.startswith("CORD1"):
        for at in CARDS["CORD1"]["id"]:
            if card.text(at):
                yield at, [_node(raw, file, card, at + k) for k in places]
        return
    at = 1 if card.name == "MPC" else 0
    find = _VARIED.get(card.name)
    found = list(find(card)) if find else list(places)
    own = _own_points(card) if card.name in WELD_POINTS else []
    yield at, [_node(raw, file, card, k) for k in found] + own


def _node(raw: Raw, file: int, card: Card, position: int) -> int:
    text = card.text(position)
    number = parse_integer(text) if text else 0
    if number is None:
        what = f'{card.name}: "{text}" in field {position + 2} is not a whole number'
        raise raw.error((file, card.line), what)
    return max(number, 0)


def _rbe2(card: Card) -> Iterator[int]:
    layout = CARDS["RBE2"]
    yield layout["main"][0]
    for k in range(layout["nodes"][0], len(card.fields)):
        # The list can end with the thermal expansion, a real number.
        if card.text(k) and "." not in card.text(k) and card.text(k).upper() != "THRU":
            yield k


def _rbe3(card: Card) -> Iterator[int]:
    """Yield the reference node, then the nodes between weights (real) and components (integer)."""
    layout = CARDS["RBE3"]
    yield layout["main"][0]
    is_component, in_list = False, True
    for k in range(layout["nodes"][0], len(card.fields)):
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
    k = CARDS["RBE1"]["nodes"][0]
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
    # SID G1 C1 A1 G2 C2 A2 (blank), then (blank) G3 C3 A3 G4 C4 A4 (blank) in each further line.
    for start in range(0, len(card.fields), 8):
        yield from (start + k for k in CARDS["MPC"]["nodes"] if card.text(start + k))


def _own_points(card: Card) -> list[int]:
    """Return the ids of the points that are defined in a weld card."""
    return [weld_point(card.name, card.number(0), end) for end, _ in _written_points(card)]


def _written_points(card: Card) -> list[tuple[int, tuple[int, ...]]]:
    """Return the weld ends with coordinates in the card, and their fields."""
    layout = CARDS[card.name]
    words = {card.text(k).upper() for k in layout["kind"]}
    if card.name == "CWELD" and words.isdisjoint(("ELEMID", "ELPAT", "PARTPAT")):
        return []
    if card.text(layout["point"][0]):
        return []
    return [
        (end, places)
        for end, places in enumerate(WELD_POINTS[card.name])
        if len(card.fields) > places[-1] and any(card.text(place) for place in places)
    ]


def _weld(card: Card) -> Iterator[int]:
    layout = CARDS[card.name]
    words = [card.text(k).upper() for k in layout["kind"]] if card.name == "CWELD" else []
    yield from (k for k in layout["grids"] if parse_integer(card.text(k)) is not None)
    if "GRIDID" in words:
        yield from (k for k in layout["patches"] if card.text(k))


_VARIED = {
    "RBE1": _rbe1,
    "RBE2": _rbe2,
    "RBE3": _rbe3,
    "MPC": _mpc,
    "CWELD": _weld,
    "CFAST": _weld,
    "CSEAM": _weld,
}


def add_weld_points(points: Points, card: Card) -> None:
    """Add the points with coordinates in a weld card, each as a separate node.

    Such a node has a negative id from card, element and point.
    """
    for end, places in _written_points(card):
        fields = [card.fields[place] for place in places]
        points.add(card, weld_point(card.name, card.number(0), end), 0, fields)


def weld_point(name: str, element: int, end: int) -> int:
    """Return the negative id of a weld point without a node."""
    return -((zlib.crc32(name.encode()) % 97 + 1) * 10**10 + 2 * element + end)
