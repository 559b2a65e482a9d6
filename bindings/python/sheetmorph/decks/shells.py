# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet of a deck: its shell elements as triangles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import FileError
from .deck import Deck, missing_nodes
from .model import Elements

_SIX = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
_EIGHT = ((0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7))
_NINE = ((0, 4, 8), (4, 1, 8), (1, 5, 8), (5, 2, 8), (2, 6, 8), (6, 3, 8), (3, 7, 8), (7, 0, 8))


@dataclass(frozen=True)
class Sheet:
    """The shells of a deck as triangles.

    Attributes
    ----------
    nodes : array (n,)
        Ascending indices of the deck's nodes in shells.
    triangles : array (m, 3), int32
        Rows of nodes, in the order of the cards.
    properties, elements, blocks : array (m,)
        Property id, element id, and index of the element block of each triangle.
    faces : array (e, 4)
        Rows of nodes at the corners of every shell, -1 in the last one of a triangle.
    """

    nodes: Ints
    triangles: Ints
    properties: Ints
    elements: Ints
    blocks: Ints
    faces: Ints


def sheet_of(deck: Deck) -> Sheet:
    """Return the shells of a deck. Raises FileError if one refers to a missing node."""
    numbers = [k for k, b in enumerate(deck.elements) if b.kind == "shell" and len(b.ids)]
    found = [deck.elements[k] for k in numbers]
    pieces = [(*_triangles(deck, block), k) for k, block in zip(numbers, found)]
    pieces = [piece for piece in pieces if len(piece[0])]
    if not pieces:
        none = np.zeros(0, dtype=np.int64)
        faces = np.zeros((0, 4), np.int32)
        return Sheet(none, np.zeros((0, 3), np.int32), none, none, none, faces)
    triangles = np.concatenate([piece[0] for piece in pieces])
    places = np.concatenate([piece[1] for piece in pieces])
    properties = np.concatenate([piece[2] for piece in pieces])
    elements = np.concatenate([piece[3] for piece in pieces])
    blocks = np.repeat([piece[4] for piece in pieces], [len(piece[0]) for piece in pieces])
    blocks = blocks.astype(np.int32)
    if len(pieces) > 1:
        order = np.argsort(places, kind="stable")
        triangles, properties = triangles[order], properties[order]
        elements, blocks = elements[order], blocks[order]
    used = np.zeros(len(deck.ids), dtype=bool)
    used[triangles] = True
    rows = (np.cumsum(used) - 1).astype(np.int32)
    faces = np.concatenate([_corners(deck, block) for block in found])
    faces = np.where(faces >= 0, rows[np.maximum(faces, 0)], np.int32(-1))
    return Sheet(np.flatnonzero(used), rows[triangles], properties, elements, blocks, faces)


def _corners(deck: Deck, block: Elements) -> Ints:
    """Return node indices (e, 4) at the corners of elements, -1 last for triangles."""
    count = 4 if block.nodes.shape[1] >= 4 and block.nodes.shape[1] != 6 else 3
    corners = np.full((len(block.ids), 4), -1, dtype=np.int32)
    corners[:, :count] = deck.find(block.nodes[:, :count])
    if count == 4:
        is_quad = (block.nodes[:, 3] != 0) & (corners[:, 3] != corners[:, 2])
        corners[~is_quad, 3] = -1
    first = corners[:, :3]
    sound = (first[:, 0] != first[:, 1]) & (first[:, 1] != first[:, 2])
    found: Ints = corners[sound & (first[:, 2] != first[:, 0])]
    return found


def _triangles(deck: Deck, block: Elements) -> tuple[Ints, Ints, Ints, Ints]:
    """Return node indices (m, 3), and places in the deck, properties and ids (m,)."""
    count = max(3, 1 + int(np.flatnonzero((block.nodes != 0).any(axis=0)).max(initial=0)))
    nodes = block.nodes[:, :count]
    if nodes.shape[1] < 3 or (nodes[:, :3] == 0).any():
        row = int(np.flatnonzero((nodes[:, :3] == 0).any(axis=1) | (nodes.shape[1] < 3))[0])
        what = f"{block.name} {block.ids[row]} has fewer than three nodes"
        raise deck.texts[block.file].error(int(block.lines[row]), what)
    whole = block.nodes.shape[1]
    if whole == 6 or 4 < count < 8:
        full = 6 if whole == 6 else 8
        nodes = np.pad(nodes, ((0, 0), (0, max(0, full - count))))
    index = deck.find(nodes)
    if (index[nodes != 0] < 0).any():
        raise _told(deck, block)
    index = np.where(nodes == 0, -1, index).astype(np.int32)
    kind = _kinds(index)
    triangles, owners = [], []
    for number in np.unique(kind).tolist():
        rows = np.flatnonzero(kind == number)
        cut = _cut(deck.points, index[rows], number)
        triangles.append(cut.reshape(-1, 3))
        owners.append(np.repeat(rows, cut.shape[1]))
    owner = np.concatenate(owners)
    corners = np.concatenate(triangles)
    if len(owners) > 1:
        order = np.argsort(owner, kind="stable")
        owner, corners = owner[order], corners[order]
    # Triangles of a degenerate element have no area and do not belong to the sheet.
    sound = (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2])
    sound &= corners[:, 2] != corners[:, 0]
    owner, corners = owner[sound], corners[sound]
    place = block.file * 2**40 + block.lines[owner].astype(np.int64)
    return corners, place, block.properties[owner], block.ids[owner]


def _told(deck: Deck, block: Elements) -> FileError:
    error = missing_nodes(deck, block)
    assert error is not None
    return error


def _kinds(index: Ints) -> Ints:
    """Return the way to cut each element: 3 or 4 corners, or 6, 8, 9 with all mid-side nodes."""
    count = index.shape[1]
    there = index >= 0
    if count <= 4:
        quad = there.sum(axis=1) == 4
        if count == 4:
            quad &= (index[:, 3] != index[:, 2]) & (index[:, 3] != index[:, 0])
        return np.where(quad, 4, 3)
    corners = 3 if count == 6 else 4
    full = there.all(axis=1)
    if corners == 3:
        return np.where(full, 6, 3)
    eight = there[:, :8].all(axis=1)
    kind = np.where(eight, 8, np.where(there[:, 3], 4, 3))
    kind = np.where((kind == 4) & (index[:, 3] == index[:, 2]), 3, kind)
    return np.where(full & (count == 9), 9, kind)


def _cut(points: Floats, index: Ints, kind: int) -> Ints:
    """Return triangles (m, k, 3) of elements of one kind."""
    if kind == 3:
        return index[:, None, :3]
    if kind == 4:
        return _quads(points, index[:, :4])
    if kind == 6:
        return index[:, np.array(_SIX)]
    if kind == 9:
        return index[:, np.array(_NINE)]
    return np.concatenate([index[:, np.array(_EIGHT)], _quads(points, index[:, 4:8])], axis=1)


def _quads(points: Floats, quads: Ints) -> Ints:
    """Cut quads along the shorter diagonal.

    If both are equal up to rounding, the one from the first node is used.
    """
    first = np.linalg.norm(points[quads[:, 0]] - points[quads[:, 2]], axis=1)
    second = np.linalg.norm(points[quads[:, 1]] - points[quads[:, 3]], axis=1)
    turned = second < first * (1.0 - 1e-6)
    one, other = quads[:, [0, 1, 3, 1, 2, 3]], quads[:, [0, 1, 2, 0, 2, 3]]
    return np.where(turned[:, None], one, other).reshape(-1, 2, 3)
