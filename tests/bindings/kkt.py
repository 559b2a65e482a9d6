# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's equations solved a second time, independently: numpy, scipy and a KKT system.

Nothing here shares code or method with the kernel: operators are assembled edge by edge, every
constraint is an equation with a multiplier, and the system is solved by a sparse LU with iterative
refinement.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla


def cotangent_edges(points, triangles):
    """Yields (i, j, half the cotangent opposite to edge ij) for every corner of every triangle."""
    for a, b, c in triangles:
        for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
            u, v = points[i] - points[k], points[j] - points[k]
            yield i, j, 0.5 * (u @ v) / np.linalg.norm(np.cross(u, v))


def stiffness(points, triangles):
    """K (n, n): (K p)_i = 1/2 sum_j (cot a + cot b)(p_i - p_j)."""
    n = len(points)
    matrix = sp.lil_matrix((n, n))
    for i, j, weight in cotangent_edges(points, triangles):
        matrix[i, i] += weight
        matrix[j, j] += weight
        matrix[i, j] -= weight
        matrix[j, i] -= weight
    return matrix.tocsr()


def mixed_areas(points, triangles):
    """Mixed Voronoi areas (Meyer et al. 2003), (n,) mm^2."""
    areas = np.zeros(len(points))
    for triangle in triangles:
        corners = points[triangle]
        edges = [corners[(k + 2) % 3] - corners[(k + 1) % 3] for k in range(3)]
        area = 0.5 * np.linalg.norm(np.cross(edges[0], edges[1]))
        dots = [-edges[(k + 1) % 3] @ edges[(k + 2) % 3] for k in range(3)]
        for k in range(3):
            if min(dots) <= 0:
                areas[triangle[k]] += area * (0.5 if dots[k] <= 0 else 0.25)
            else:
                b, c = (k + 1) % 3, (k + 2) % 3
                cot_b, cot_c = dots[b] / (2 * area), dots[c] / (2 * area)
                areas[triangle[k]] += (
                    cot_b * edges[b] @ edges[b] + cot_c * edges[c] @ edges[c]
                ) / 8
    return areas


def solve_kkt(hessian, right_side, constraints, targets):
    """Minimises x^T H x / 2 - b^T x subject to C x = c, (n, k); LU with three refinements."""
    count = constraints.shape[0]
    system = sp.bmat([[hessian, constraints.T], [constraints, None]]).tocsc()
    side = np.vstack([right_side, targets])
    factor = spla.splu(system)
    x = factor.solve(side)
    for _ in range(3):
        x += factor.solve(side - system @ x)
    return x[: len(x) - count]


def rows_of(n, entries):
    """Constraint matrix from a list of rows {column: value}."""
    matrix = sp.lil_matrix((len(entries), n))
    for row, values in enumerate(entries):
        for column, value in values.items():
            matrix[row, column] = value
    return matrix.tocsr()


def harmonic_weights(points, triangles, sources, features):
    """Weights (n, k) of k sets of vertices: harmonic with edge weights >= 1e-3, one value
    a feature, then 3 w^2 - 2 w^3 and renormalised."""
    n = len(points)
    edges = {}
    for i, j, weight in cotangent_edges(points, triangles):
        key = (min(i, j), max(i, j))
        edges[key] = edges.get(key, 0.0) + weight
    matrix = sp.lil_matrix((n, n))
    for (i, j), weight in edges.items():
        weight = max(weight, 1e-3)
        matrix[i, i] += weight
        matrix[j, j] += weight
        matrix[i, j] -= weight
        matrix[j, i] -= weight
    entries, targets = [], []
    for k, vertices in enumerate(sources):
        for vertex in vertices:
            entries.append({vertex: 1.0})
            targets.append(np.eye(len(sources))[k])
    for vertices in features:
        for vertex in vertices[1:]:
            entries.append({vertices[0]: 1.0, vertex: -1.0})
            targets.append(np.zeros(len(sources)))
    weights = solve_kkt(
        matrix.tocsr(), np.zeros((n, len(sources))), rows_of(n, entries), np.array(targets)
    )
    weights = np.clip(weights, 0.0, 1.0)
    weights = weights**2 * (3 - 2 * weights)
    return weights / weights.sum(axis=1, keepdims=True)


def rotation(log):
    """Rodrigues: (3, 3) about log by the angle 2 |log| (2.6)."""
    angle = 2 * np.linalg.norm(log)
    if angle == 0:
        return np.eye(3)
    x, y, z = 2 * log / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


@dataclass
class Problem:
    """One part with a fixed set, a handle and features, as lists of vertex indices."""

    points: np.ndarray
    triangles: np.ndarray
    fixed: list
    handle: list
    features: list

    def __post_init__(self):
        self.areas = mixed_areas(self.points, self.triangles)
        self.laplacian = sp.diags(1 / (2 * self.areas)) @ stiffness(self.points, self.triangles)

    def rotation_logs(self, energy, handle_log):
        """(n, 3) logarithms: (2.9) for `paper`, smoothed harmonic weights for `neumann`."""
        if energy == "neumann":
            weights = harmonic_weights(
                self.points, self.triangles, [self.fixed, self.handle], self.features
            )
            return np.outer(weights[:, 1], handle_log)
        entries = [{vertex: 1.0} for vertex in self.fixed + self.handle]
        targets = [np.zeros(3)] * len(self.fixed) + [handle_log] * len(self.handle)
        for vertices in self.features:
            for vertex in vertices[1:]:
                entries.append({vertices[0]: 1.0, vertex: -1.0})
                targets.append(np.zeros(3))
        n = len(self.points)
        hessian = self.laplacian.T @ self.laplacian
        return solve_kkt(hessian, np.zeros((n, 3)), rows_of(n, entries), np.array(targets))

    def positions(self, energy, motion):
        """(n, 3) mm: (2.10) with the constraints (2.3) and (2.4)."""
        logs = self.rotation_logs(energy, motion.rotation_log)
        rotations = np.array([rotation(log) for log in logs])
        n = len(self.points)
        weights = sp.diags(self.areas if energy == "neumann" else np.ones(n))
        delta = self.laplacian @ self.points
        turned = np.einsum("nij,nj->ni", rotations, delta)
        entries = [{vertex: 1.0} for vertex in self.fixed + self.handle]
        targets = [self.points[vertex] for vertex in self.fixed]
        targets += list(motion.apply(np.ascontiguousarray(self.points[self.handle])))
        for vertices in self.features:
            for vertex in vertices[1:]:
                entries.append({vertex: 1.0, vertices[0]: -1.0})
                arm = self.points[vertex] - self.points[vertices[0]]
                targets.append(rotations[vertices[0]] @ arm)
        gradient = self.laplacian.T @ weights @ turned
        hessian = self.laplacian.T @ weights @ self.laplacian
        return solve_kkt(hessian, gradient, rows_of(n, entries), np.array(targets))
