# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigidity of form features, from positions alone."""

from __future__ import annotations

from collections.abc import Iterable
import numpy as np

from ..base.arrays import Floats, Ints
from ..base.motion import rigid_motion
from ..base.part_mesh import PartMesh


def tolerance(size: float, arrays: Iterable[Floats]) -> float:
    """Return 1e-12 size + 8 eps max|coordinate|, mm, over arrays (n, 3) of all positions."""
    largest = max((float(np.abs(array).max(initial=0.0)) for array in arrays), default=0.0)
    return 1e-12 * size + 8.0 * float(np.finfo(np.float64).eps) * largest


def feature_edges(mesh: PartMesh, vertices: Ints) -> Ints:
    """Return the edges (e, 2) of a form feature with the vertex indices (k,).

    These are the mesh edges inside the feature, and one edge from its first vertex to every other.
    The latter also cover vertices that no mesh edge connects.
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
    """Return the rotation (3, 3) of vertices (k,) that fits best, None if they are collinear.

    It needs positions only, so that a written file can be certified.
    """
    found = rigid_motion(rest[vertices], positions[vertices])
    return None if found is None else found[0]


def edge_error(rest: Floats, positions: Floats, edges: Ints, rotation: Floats | None) -> float:
    """Return the worst |p_i - p_j - R (p_hat_i - p_hat_j)| over edges (e, 2), mm (2.4).

    The rest positions (n, 3) include the prescribed feature sizes. If the rotation (3, 3) is None,
    only edge lengths are compared.
    """
    before = rest[edges[:, 0]] - rest[edges[:, 1]]
    after = positions[edges[:, 0]] - positions[edges[:, 1]]
    if rotation is None:
        lengths = np.linalg.norm(after, axis=1) - np.linalg.norm(before, axis=1)
        return float(np.abs(lengths).max(initial=0.0))
    return float(np.linalg.norm(after - before @ rotation.T, axis=1).max(initial=0.0))
