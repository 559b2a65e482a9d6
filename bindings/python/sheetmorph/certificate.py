# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of positions alone: whether form features kept their form, what crosses."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from .arrays import Floats, Ints
from .decks.following import rigid_motion
from .part_mesh import PartMesh


def tolerance(size: float, arrays: Iterable[Floats]) -> float:
    """1e-12 size + 8 eps max|coordinate|, mm.

    arrays: (n, 3) each, all positions at rest and deformed.
    """
    largest = max((float(np.abs(array).max(initial=0.0)) for array in arrays), default=0.0)
    return 1e-12 * size + 8.0 * float(np.finfo(np.float64).eps) * largest


def feature_edges(mesh: PartMesh, vertices: Ints) -> Ints:
    """Edges (e, 2) of a form feature: the mesh's inside it, and each vertex with the first one.

    vertices (k,): indices. The latter so that loose vertices are looked at, too.
    """
    inside = np.zeros(len(mesh.points), dtype=bool)
    inside[vertices] = True
    triangles = mesh.triangles
    pairs = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    pairs = np.unique(np.sort(pairs[inside[pairs].all(axis=1)], axis=1), axis=0)
    spokes = np.stack([np.full(len(vertices) - 1, vertices[0]), vertices[1:]], axis=1)
    found: Ints = np.concatenate([pairs, spokes]).astype(np.int64)
    return found


def best_turn(rest: Floats, positions: Floats, vertices: Ints) -> Floats | None:
    """The rotation (3, 3) that carries vertices (k,) best, which a file alone tells; None if they
    lie on a line."""
    found = rigid_motion(rest[vertices], positions[vertices])
    return None if found is None else found[0]


def edge_error(rest: Floats, positions: Floats, edges: Ints, rotation: Floats | None) -> float:
    """Worst |p_i - p_j - R (p_hat_i - p_hat_j)| over edges (e, 2), mm (2.4).

    rest, positions: (n, 3), at rest with the sizes that form features have; rotation: (3, 3), None
    to compare lengths alone.
    """
    before = rest[edges[:, 0]] - rest[edges[:, 1]]
    after = positions[edges[:, 0]] - positions[edges[:, 1]]
    if rotation is None:
        lengths = np.linalg.norm(after, axis=1) - np.linalg.norm(before, axis=1)
        return float(np.abs(lengths).max(initial=0.0))
    return float(np.linalg.norm(after - before @ rotation.T, axis=1).max(initial=0.0))


def crossings(core: Any, points: Floats, triangles: Ints) -> Ints:
    """Pairs (k, 2) of triangles (m, 3) on points (n, 3) that meet though no corner joins them, each
    in order, ascending (CGAL).

    core: the kernel module.
    """
    pairs = core.self_intersections(core.TriangleMesh(np.array(points), triangles))
    found: Ints = np.asarray(pairs, dtype=np.int64).reshape(-1, 2)
    return found
