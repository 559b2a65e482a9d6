# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the energy `natural` once more, in numpy: one matrix entry after the other.

Only for meshes that are manifold but for their border and have no slivers.
"""

from collections import defaultdict

import numpy as np
import scipy.sparse as sp
from kkt import Problem, harmonic_weights, mixed_areas, rotation, rows_of, solve_kkt


def hat_gradients(corners):
    """Gradients (3, 3) of a triangle's hat functions, one a row, and its area."""
    a, b, c = corners
    normal = np.cross(b - a, c - a)
    twice = np.linalg.norm(normal)
    edges = np.array([c - b, a - c, b - a])
    return np.cross(normal / twice, edges) / twice, twice / 2


def edges_of(triangles):
    """{(i, j), i < j: [(triangle, opposite vertex), ...]}."""
    edges = defaultdict(list)
    for t, corners in enumerate(triangles):
        for k in range(3):
            i, j, opposite = (int(corners[(k + s) % 3]) for s in range(3))
            edges[min(i, j), max(i, j)].append((t, opposite))
    return edges


def neighbours_of(vertices, triangles):
    """The vertices that share an edge with one of `vertices` and are none of them."""
    near = set()
    for i, j in edges_of(triangles):
        if (i in vertices) != (j in vertices):
            near.add(j if i in vertices else i)
    return sorted(near)


def cotangent(points, at, one, other):
    """Cotangent of the angle at a vertex."""
    u, v = points[one] - points[at], points[other] - points[at]
    return u @ v / np.linalg.norm(np.cross(u, v))


def hessian_rows(points, triangles, interior):
    """Nine rows {column: value} a vertex: 1/M sum A (grad u)_a (grad phi)_b; weights; vertices."""
    masses = mixed_areas(points, triangles)
    rows = {i: [defaultdict(float) for _ in range(9)] for i in interior}
    for corners in triangles:
        gradients, area = hat_gradients(points[corners])
        for k, i in enumerate(corners):
            for j, of_hat in zip(corners, gradients):
                outer = area / masses[i] * np.outer(of_hat, gradients[k])
                for entry, value in enumerate(outer.ravel() if i in rows else ()):
                    rows[i][entry][int(j)] += value
    return [(row, masses[i], i) for i, of_vertex in rows.items() for row in of_vertex]


def hinge_rows(points, triangles, free):
    """Two rows an edge of a triangle with a vertex in `free`, one for either end."""
    rows = []
    for (i, j), uses in edges_of(triangles).items():
        if len(uses) != 2 or free.isdisjoint({int(v) for t, _ in uses for v in triangles[t]}):
            continue
        (one, k), (two, other) = uses
        at_i = [cotangent(points, i, j, apex) for apex in (k, other)]
        at_j = [cotangent(points, j, i, apex) for apex in (k, other)]
        row = {i: sum(at_j), j: sum(at_i), k: -at_i[0] - at_j[0], other: -at_i[1] - at_j[1]}
        area = sum(hat_gradients(points[triangles[t]])[1] for t in (one, two))
        rows += [(row, 0.5 * 0.25 * 3 / area, end) for end in (i, j)]
    return rows


def natural_rows(points, triangles, held):
    """D (r, n), weights (r,) and the vertex that turns each row; `held`: known vertices."""
    border = {v for edge, uses in edges_of(triangles).items() if len(uses) != 2 for v in edge}
    interior = sorted(set(map(int, triangles.ravel())) - border)
    found = hessian_rows(points, triangles, interior)
    found += hinge_rows(points, triangles, border - set(held))
    rows, weights, vertices = zip(*found)
    return sp.csr_matrix(rows_of(len(points), rows)), np.array(weights), np.array(vertices)


class NaturalProblem(Problem):
    """One part under `natural`: free neighbours of known vertices move rigidly with them."""

    def positions(self, motion):
        """(n, 3) mm."""
        rigid = {v for vertices in self.features for v in vertices}
        beside = [
            [v for v in neighbours_of(set(known), self.triangles) if v not in rigid]
            for known in (self.fixed, self.handle)
        ]
        fixed, handle = (known + ring for known, ring in zip((self.fixed, self.handle), beside))
        weights = harmonic_weights(self.points, self.triangles, [fixed, handle], self.features)
        turns = np.array([rotation(log) for log in np.outer(weights[:, 1], motion.rotation_log)])
        rows, areas, at = natural_rows(self.points, self.triangles, self.fixed + self.handle)
        wanted = np.einsum("rij,rj->ri", turns[at], rows @ self.points)
        entries = [{vertex: 1.0} for vertex in fixed + handle]
        targets = list(self.points[fixed])
        targets += list(motion.apply(np.ascontiguousarray(self.points[handle])))
        for vertices in self.features:
            for vertex in vertices[1:]:
                entries.append({vertex: 1.0, vertices[0]: -1.0})
                arm = self.points[vertex] - self.points[vertices[0]]
                targets.append(turns[vertices[0]] @ arm)
        hessian = rows.T @ sp.diags(areas) @ rows
        gradient = rows.T @ (areas[:, None] * wanted)
        constraints = rows_of(len(self.points), entries)
        return solve_kkt(hessian, gradient, constraints, np.array(targets))
