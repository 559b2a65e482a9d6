# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a CAD file on its mesh: where triangles of two faces meet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.arrays import Ints


@dataclass(frozen=True, eq=False)
class CadEdge:
    """A CAD edge: rows of its faces in Labels.faces, one at a border; vertex pairs (k, 2)."""

    faces: tuple[int, ...]
    segments: Ints


def cad_edges(triangles: Ints, face: Ints) -> list[CadEdge]:
    """Return the edges between faces of triangles (m, 3); face (m,) is the face of each."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    owners = np.repeat(face, 3)
    ends, number = np.unique(sides, axis=0, return_inverse=True)
    order = np.lexsort([owners, number.ravel()])
    begins = np.searchsorted(number.ravel()[order], np.arange(len(ends) + 1))
    found: dict[tuple[int, ...], list[int]] = {}
    for k in range(len(ends)):
        around = owners[order[begins[k] : begins[k + 1]]].tolist()
        if len(set(around)) > 1 or len(around) == 1:
            found.setdefault(tuple(dict.fromkeys(around)), []).append(k)
    return [
        CadEdge(faces, piece) for faces, rows in found.items() for piece in _connected(ends[rows])
    ]


def _connected(segments: Ints) -> list[Ints]:
    """Return the segments (k, 2) as connected pieces."""
    piece = {int(v): int(v) for v in np.unique(segments)}

    def root(vertex: int) -> int:
        while piece[vertex] != vertex:
            piece[vertex] = piece[piece[vertex]]
            vertex = piece[vertex]
        return vertex

    for a, b in segments.tolist():
        piece[root(a)] = root(b)
    owner = np.array([root(a) for a in segments[:, 0].tolist()])
    return [segments[owner == one] for one in np.unique(owner)]
