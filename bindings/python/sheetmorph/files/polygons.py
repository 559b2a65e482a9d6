# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polygons of a file split into triangles: for the stiffness alone, the file keeps its polygons."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..arrays import Floats, Ints


def triangulate(points: Floats, faces: Sequence[Sequence[int]]) -> Ints:
    """Triangles (m, 3) int32 of faces (each three or more vertex indices), in the faces' order.

    points: (n, 3). A quad is cut along its shorter diagonal, the one from its first vertex if they
    are equal to rounding (so that a moved or scaled model is cut alike); other polygons fan out
    from their first vertex.
    """
    sizes = np.fromiter((len(face) for face in faces), dtype=np.int64, count=len(faces))
    owners, triangles = [], []
    for size in np.unique(sizes):
        rows = np.flatnonzero(sizes == size)
        block = np.array([faces[row] for row in rows], dtype=np.int64)
        split = _split_quads(points, block) if size == 4 else _fan(block)
        triangles.append(split.reshape(-1, 3))
        owners.append(np.repeat(rows, split.shape[1]))
    if not triangles:
        return np.empty((0, 3), dtype=np.int32)
    order = np.argsort(np.concatenate(owners), kind="stable")
    return np.ascontiguousarray(np.concatenate(triangles)[order], dtype=np.int32)


def _fan(block: Ints) -> Ints:
    count = block.shape[1] - 2
    corners = [block[:, [0, k + 1, k + 2]] for k in range(count)]
    return np.stack(corners, axis=1)


def _split_quads(points: Floats, quads: Ints) -> Ints:
    first = np.linalg.norm(points[quads[:, 0]] - points[quads[:, 2]], axis=1)
    second = np.linalg.norm(points[quads[:, 1]] - points[quads[:, 3]], axis=1)
    turned = second < first * (1.0 - 1e-6)
    split = np.where(
        turned[:, None],
        quads[:, [0, 1, 3, 1, 2, 3]],
        quads[:, [0, 1, 2, 0, 2, 3]],
    )
    return split.reshape(-1, 2, 3)
