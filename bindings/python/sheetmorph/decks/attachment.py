# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of nodes outside the sheet of a deck, and the sheet nodes to which they are attached."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.arrays import Bools, Ints
from .deck import Deck
from .shells import Sheet

# Points closer than this share of the largest coordinate coincide.
_SAME = 1e-7
_JOINING = ("line", "rigid", "constraint", "mass", "weld", "solid", "frame")


@dataclass(frozen=True)
class Group:
    """Nodes that elements connect.

    nodes (k,) are indices in the deck. The rows `held` (j,) are the sheet nodes to which elements
    attach them. kinds are those of the elements.
    """

    nodes: Ints
    held: Ints
    kinds: frozenset[str]


def groups_of(deck: Deck, sheet: Sheet) -> list[Group]:
    """Return the connected groups of nodes outside the sheet."""
    row = np.full(len(deck.ids), -1, dtype=np.int64)
    row[sheet.nodes] = np.arange(len(sheet.nodes))
    pinned = pinned_nodes(deck, sheet)
    row[pinned[:, 0]] = pinned[:, 1]
    free = row < 0
    links, ties, kinds = _links(deck, free)
    labels = labels_of(len(deck.ids), links)
    found = np.flatnonzero(free)
    order = found[np.argsort(labels[found], kind="stable")]
    _, first = np.unique(labels[order], return_index=True)
    held = _by_label(labels, ties, row)
    of_kind = _by_label(labels, kinds, None)
    names = dict(enumerate(_JOINING))
    alone = [Group(one[:1], one[1:], frozenset({"line"})) for one in pinned]
    return alone + [
        Group(
            nodes,
            held.get(int(labels[nodes[0]]), np.empty(0, dtype=np.int64)),
            frozenset(names[k] for k in of_kind.get(int(labels[nodes[0]]), ())),
        )
        for nodes in np.split(order, first[1:])
        if len(nodes)
    ]


def pinned_nodes(deck: Deck, sheet: Sheet) -> Ints:
    """Return (k, 2) nodes attached by a zero-length element to a sheet node, and its row.

    Such a node coincides with the sheet node, whatever else it belongs to.
    """
    row = np.full(len(deck.ids), -1, dtype=np.int64)
    row[sheet.nodes] = np.arange(len(sheet.nodes))
    found = [np.zeros((0, 2), dtype=np.int64)]
    for block in deck.elements:
        if block.kind != "line" or block.nodes.shape[1] != 2:
            continue
        index = np.where(block.nodes == 0, -1, deck.find(block.nodes))
        index = index[(index >= 0).all(axis=1)]
        for one, other in ((0, 1), (1, 0)):
            pair = index[(row[index[:, one]] < 0) & (row[index[:, other]] >= 0)]
            a, b = deck.points[pair[:, one]], deck.points[pair[:, other]]
            close = np.abs(a - b).max(axis=1, initial=0.0) <= _SAME * np.abs(b).max(initial=1.0)
            found.append(np.stack([pair[close, one], row[pair[close, other]]], axis=1))
    both = np.concatenate(found)
    _, first = np.unique(both[:, 0], return_index=True)
    return both[first]


def _links(deck: Deck, free: Bools) -> tuple[Ints, Ints, Ints]:
    """Return pairs of free nodes, of a free and a sheet node, and of a free node and a kind."""
    none = np.zeros((0, 2), dtype=np.int64)
    links, ties, kinds = [none], [none], [none]
    for block in deck.elements:
        if block.kind not in _JOINING:
            continue
        index = deck.find(block.nodes)
        index = np.where(block.nodes == 0, -1, index)
        is_free = (index >= 0) & free[np.maximum(index, 0)]
        rows = np.flatnonzero(is_free.any(axis=1))
        if not len(rows):
            continue
        index, is_free = index[rows], is_free[rows]
        lead = index[np.arange(len(rows)), is_free.argmax(axis=1)]
        for kind, there in ((links, is_free), (ties, (index >= 0) & ~is_free)):
            at, column = np.nonzero(there)
            kind.append(np.stack([lead[at], index[at, column]], axis=1))
        number = np.full(len(lead), _JOINING.index(block.kind))
        kinds.append(np.stack([lead, number], axis=1))
    return np.concatenate(links), np.concatenate(ties), np.concatenate(kinds)


def labels_of(count: int, links: Ints) -> Ints:
    """Return for each node (n,) the smallest index in its connected component."""
    labels = np.arange(count)
    while True:
        before = labels
        labels = labels.copy()
        smallest = labels[links].min(axis=1)
        np.minimum.at(labels, links[:, 0], smallest)
        np.minimum.at(labels, links[:, 1], smallest)
        labels = labels[labels]
        if np.array_equal(labels, before):
            return labels


def _by_label(labels: Ints, pairs: Ints, row: Ints | None) -> dict[int, Ints]:
    """Return the unique second items of pairs, by the label of the first."""
    if not len(pairs):
        return {}
    values = pairs[:, 1] if row is None else row[pairs[:, 1]]
    both = np.unique(np.stack([labels[pairs[:, 0]], values], axis=1), axis=0)
    keys, first = np.unique(both[:, 0], return_index=True)
    return dict(zip(keys.tolist(), np.split(both[:, 1], first[1:])))
