# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarser meshes of the same sheet, by collapsing edges; labelled rims keep 8 vertices each."""

from __future__ import annotations

from collections import Counter

import numpy as np

KEPT = 8  # vertices of a rim


def coarsened(
    points: np.ndarray, triangles: np.ndarray, rims: list[list[int]]
) -> tuple[np.ndarray, np.ndarray, list[list[int]]]:
    """Points, triangles and rims of the mesh without most rim vertices and half the others.

    A vertex goes into the nearest neighbour that leaves the surface unfolded; the border of the
    sheet but for the rims stays.
    """
    faces = {k: tuple(map(int, t)) for k, t in enumerate(triangles)}
    around: dict[int, set[int]] = {}
    for k, face in faces.items():
        for v in face:
            around.setdefault(v, set()).add(k)
    edges = Counter(tuple(sorted((t[k], t[k - 1]))) for t in faces.values() for k in range(3))
    border = {v for edge, count in edges.items() if count == 1 for v in edge}
    kept_rims = [[rim[round(k * len(rim) / KEPT)] for k in range(KEPT)] for rim in rims]
    on_rim = {v: number for number, rim in enumerate(rims) for v in rim}
    random = np.random.default_rng(1)
    inner = [v for v in around if v not in border]
    gone = [v for rim, kept in zip(rims, kept_rims) for v in rim if v not in kept]
    gone += random.permutation(inner)[: len(inner) // 2].tolist()
    for v in gone:
        _collapse(v, (points, faces, around), on_rim)
    return _packed(points, list(faces.values()), kept_rims)


def _collapse(v, mesh, on_rim) -> None:
    points, faces, around = mesh
    near = {u for k in around[v] for u in faces[k]} - {v}
    edge = Counter(u for k in around[v] for u in faces[k] if u != v)
    for u in sorted(near, key=lambda u: float(np.linalg.norm(points[u] - points[v]))):
        if v in on_rim and (edge[u] != 1 or on_rim.get(u) != on_rim[v]):
            continue
        shared = around[v] & around[u]
        others = {w for k in around[u] for w in faces[k]} - {u}
        if len((near - {u}) & (others - {v})) != len(shared):
            continue
        moved = {k: tuple(u if w == v else w for w in faces[k]) for k in around[v] - shared}
        if all(_keeps_side(points, faces[k], face) for k, face in moved.items()):
            for k in shared:
                for w in faces.pop(k):
                    around[w].discard(k)
            for k, face in moved.items():
                faces[k] = face
                around[u].add(k)
            around[v] = set()
            return


def _keeps_side(points, before, after) -> bool:
    one, other = (
        np.cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) for t in (before, after)
    )
    return one @ other > 0.5 * np.linalg.norm(one) * np.linalg.norm(other)


def _packed(points, faces, rims):
    used, corners = np.unique(np.array(faces), return_inverse=True)
    number = {int(v): k for k, v in enumerate(used)}
    return points[used], corners.reshape(-1, 3), [[number[v] for v in rim] for rim in rims]
