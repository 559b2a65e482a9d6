# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangulates flat blanks: an outline, round holes with washer rings, lines that must be edges.

Free vertices start on a jittered hexagonal lattice and are spread by repelling springs
(Persson and Strang, "A simple mesh generator in Matlab", 2004); the rest is given and stays.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import Delaunay, cKDTree

SPREADING, SMOOTHING = 80, 12


@dataclass(frozen=True)
class Hole:
    """A round hole: `count` vertices on the rim, as many on a washer ring `washer` mm outside."""

    name: str
    centre: tuple[float, float]
    radius: float
    count: int = 16
    washer: float = 3.0

    def ring(self, radius: float, turn: float) -> np.ndarray:
        """(count, 2) points of a concentric circle, started `turn` steps after the u axis."""
        angles = 2 * np.pi * (np.arange(self.count) + turn) / self.count
        circle = np.column_stack([np.cos(angles), np.sin(angles)])
        return np.asarray(self.centre) + radius * circle

    def outer_radius(self) -> float:
        return self.radius + self.washer


@dataclass(frozen=True)
class Blank:
    """A flat blank in mm: closed outline, holes, polylines that become edges, largest edge length.

    `total` is the exact number of vertices wanted, `grading` how fast edges grow away from details.
    """

    outline: np.ndarray
    holes: tuple[Hole, ...] = ()
    lines: tuple[np.ndarray, ...] = ()
    spacing: float = 8.0
    total: int = 0
    grading: float = 0.35
    seed: int = 1


class Given:
    """The vertices that stay: (k, 2) points, edges (e, 2) between them, and the size around them.

    Rounded to 1e-9 mm: the last bits of a cosine differ between processors, the mesh must not.
    """

    def __init__(self, points: np.ndarray, edges: np.ndarray, grading: float) -> None:
        self.points, self._grading = np.round(points, 9), grading
        ends = self.points[edges]
        length = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        self._half, self._middles = 0.55 * length, cKDTree(ends.mean(axis=1))
        spacing = np.full(len(points), np.inf)
        np.minimum.at(spacing, edges, length[:, None])
        away = np.linalg.norm(self.points[:, None] - self.points[None], axis=2)
        self.spacing = (spacing + grading * away).min(axis=1)
        self._tree = cKDTree(self.points)

    def distance(self, points: np.ndarray) -> np.ndarray:
        """(n,) distances from the nearest given vertex."""
        return self._tree.query(points)[0]

    def size(self, points: np.ndarray) -> np.ndarray:
        """(n,) edge lengths that fit to the nearest given vertex."""
        away, nearest = self._tree.query(points)
        return self.spacing[nearest] + self._grading * away

    def leaves_edges(self, points: np.ndarray) -> np.ndarray:
        """(n,) bool: so far from every given edge that a Delaunay triangulation keeps it."""
        away, edges = self._middles.query(points, k=min(8, len(self._half)))
        return np.all(away > self._half[edges], axis=1)


@dataclass
class FlatMesh:
    """(n, 2) points, (m, 3) triangles counter-clockwise, and which vertices came from where."""

    points: np.ndarray
    triangles: np.ndarray
    outline: np.ndarray
    rims: dict[str, np.ndarray] = field(default_factory=dict)
    washers: dict[str, np.ndarray] = field(default_factory=dict)
    edges: np.ndarray = field(default_factory=lambda: np.empty((0, 2), int))


def triangulate(blank: Blank) -> FlatMesh:
    """Meshes a blank with exactly `blank.total` vertices; ValueError if a given edge got lost."""
    mesh, given = _given_vertices(blank)
    free = _seed(blank, given)
    for _ in range(SPREADING):
        free = _spread(blank, given, free)
    for _ in range(SMOOTHING):
        free = _smooth(blank, given, free)
    mesh.triangles = _triangles_inside(blank, np.vstack([given.points, free]))
    mesh.points = np.vstack([mesh.points, free])
    _require_edges(mesh)
    return mesh


def inside(outline: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(n,) bool: which of the (n, 2) points lie inside the closed (k, 2) polygon."""
    start, end = outline, np.roll(outline, -1, axis=0)
    x, y = points[:, :1], points[:, 1:]
    spans = (start[:, 1] > y) != (end[:, 1] > y)
    rise = np.where(end[:, 1] == start[:, 1], 1.0, end[:, 1] - start[:, 1])
    crossing = start[:, 0] + (y - start[:, 1]) / rise * (end[:, 0] - start[:, 0])
    return np.count_nonzero(spans & (x < crossing), axis=1) % 2 == 1


def mesh_edges(triangles: np.ndarray) -> np.ndarray:
    """(e, 2) sorted unique edges of (m, 3) triangles."""
    pairs = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    return np.unique(np.sort(pairs, axis=1), axis=0)


def _given_vertices(blank: Blank) -> tuple[FlatMesh, Given]:
    """A mesh of the outline, rings and lines alone."""
    chains = [(blank.outline, True, None)]
    for hole in blank.holes:
        chains.append((hole.ring(hole.radius, 0.0), True, hole.name))
        chains.append((hole.ring(hole.outer_radius(), 0.5), True, hole.name))
    chains += [_open_chain(line) for line in blank.lines]
    mesh = FlatMesh(np.empty((0, 2)), np.empty((0, 3), int), np.arange(len(blank.outline)))
    edges = []
    for points, closed, name in chains:
        ids = _join(mesh, points)
        links = np.column_stack([ids, np.roll(ids, -1)])[: len(ids) if closed else -1]
        edges.append(links)
        if name is not None:
            (mesh.washers if name in mesh.rims else mesh.rims)[name] = ids
    mesh.edges = np.vstack(edges)
    return mesh, Given(mesh.points, mesh.edges, blank.grading)


def _open_chain(line: np.ndarray) -> tuple[np.ndarray, bool, None]:
    closed = bool(np.allclose(line[0], line[-1]))
    return (line[:-1] if closed else line), closed, None


def _join(mesh: FlatMesh, points: np.ndarray) -> np.ndarray:
    """Ids of the points in the mesh; a point that is there already is shared."""
    ids = []
    for point in points:
        away = np.linalg.norm(mesh.points - point, axis=1)
        if len(away) and away.min() < 1e-6:
            ids.append(int(away.argmin()))
            continue
        ids.append(len(mesh.points))
        mesh.points = np.vstack([mesh.points, point])
    return np.array(ids)


def _size(blank: Blank, given: Given, points: np.ndarray) -> np.ndarray:
    """(n,) wanted edge length at (n, 2) points."""
    return np.minimum(blank.spacing, given.size(points))


def _allowed(blank: Blank, given: Given, points: np.ndarray) -> np.ndarray:
    """(n,) bool: on the sheet, and so far from every given edge that Delaunay keeps the edge."""
    keep = inside(blank.outline, points) & given.leaves_edges(points)
    for hole in blank.holes:
        away = np.linalg.norm(points - np.asarray(hole.centre), axis=1)
        keep &= away > hole.outer_radius()
    return keep


def _seed(blank: Blank, given: Given) -> np.ndarray:
    """Start positions of the free vertices, exactly as many as the wanted total asks for."""
    wanted = blank.total - len(given.points)
    if wanted < 0:
        raise ValueError(
            f"{len(given.points)} given vertices exceed the wanted total {blank.total}"
        )
    for shrink in 0.97 ** np.arange(120):
        points = _lattice(blank, given, shrink)
        if len(points) >= wanted:
            rng = np.random.default_rng(blank.seed)
            return points[np.sort(rng.permutation(len(points))[:wanted])]
    raise ValueError("no lattice is fine enough for the wanted total")


def _lattice(blank: Blank, given: Given, shrink: float) -> np.ndarray:
    """A jittered hexagonal lattice thinned to the wanted density."""
    rng = np.random.default_rng(blank.seed)
    low, high = blank.outline.min(axis=0), blank.outline.max(axis=0)
    finest = shrink * max(min(given.spacing.min(), blank.spacing), blank.spacing / 4)
    columns = np.arange(low[0], high[0], finest)
    rows = np.arange(low[1], high[1], finest * np.sqrt(0.75))
    u, v = np.meshgrid(columns, rows)
    u[1::2] += finest / 2
    points = np.column_stack([u.ravel(), v.ravel()])
    points += rng.uniform(-0.1, 0.1, points.shape) * finest
    points = points[_allowed(blank, given, points)]
    size = shrink * _size(blank, given, points)
    points = points[rng.uniform(size=len(points)) < (finest / size) ** 2]
    size = shrink * _size(blank, given, points)
    return points[given.distance(points) > 0.6 * size]


def _spread(blank: Blank, given: Given, free: np.ndarray) -> np.ndarray:
    """One step of the repelling springs for the free vertices."""
    points = np.vstack([given.points, free])
    edges = mesh_edges(_triangles_inside(blank, points))
    span = points[edges[:, 0]] - points[edges[:, 1]]
    length = np.linalg.norm(span, axis=1)
    size = _size(blank, given, points[edges].mean(axis=1))
    wanted = 1.15 * size * np.sqrt(np.sum(length**2) / np.sum(size**2))
    push = (np.maximum(wanted - length, 0.0) / length)[:, None] * span
    force = np.zeros_like(points)
    np.add.at(force, edges[:, 0], push)
    np.add.at(force, edges[:, 1], -push)
    moved = np.round(free + 0.2 * force[len(given.points) :], 9)
    return np.where(_allowed(blank, given, moved)[:, None], moved, free)


def _smooth(blank: Blank, given: Given, free: np.ndarray) -> np.ndarray:
    """Moves every free vertex towards the area-weighted centres of its triangles' circumcircles.

    The fixed point is the optimal Delaunay triangulation (Chen and Holst 2011, "ODT").
    """
    points = np.vstack([given.points, free])
    triangles = _triangles_inside(blank, points)
    centres, areas = _circumcircles(points[triangles])
    total, weight = np.zeros_like(points), np.zeros(len(points))
    size = _size(blank, given, points[triangles].mean(axis=1))
    share = areas / size**4
    for k in range(3):
        np.add.at(total, triangles[:, k], share[:, None] * centres)
        np.add.at(weight, triangles[:, k], share)
    kept = len(given.points)
    aim = total[kept:] / weight[kept:, None]
    moved = np.round(free + 0.5 * (aim - free), 9)
    return np.where(_allowed(blank, given, moved)[:, None], moved, free)


def _circumcircles(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(m, 2) circumcentres, pulled inside for flat triangles, and (m,) areas."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    double = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    one, two = np.sum(first**2, axis=1), np.sum(second**2, axis=1)
    offset = np.column_stack(
        [second[:, 1] * one - first[:, 1] * two, first[:, 0] * two - second[:, 0] * one]
    ) / (2 * double[:, None])
    middle = corners.mean(axis=1)
    reach = np.linalg.norm(corners[:, 0] + offset - middle, axis=1)
    limit = np.sqrt(np.abs(double))
    pull = np.minimum(1.0, limit / np.maximum(reach, 1e-12))[:, None]
    return middle + pull * (corners[:, 0] + offset - middle), np.abs(double) / 2


def _triangles_inside(blank: Blank, points: np.ndarray) -> np.ndarray:
    """Delaunay triangles of the blank, counter-clockwise, without the holes."""
    triangles = Delaunay(points).simplices
    corners = points[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    triangles[area < 0] = triangles[area < 0][:, [0, 2, 1]]
    centres = corners.mean(axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    keep = inside(blank.outline, centres) & (np.abs(area) > 1e-3 * longest**2)
    for hole in blank.holes:
        keep &= np.linalg.norm(centres - np.asarray(hole.centre), axis=1) > hole.radius
    return triangles[keep]


def _require_edges(mesh: FlatMesh) -> None:
    have = {tuple(edge) for edge in mesh_edges(mesh.triangles)}
    lost = [tuple(edge) for edge in np.sort(mesh.edges, axis=1) if tuple(edge) not in have]
    if lost:
        where = [mesh.points[list(edge)].mean(axis=0).round(1).tolist() for edge in lost[:5]]
        raise ValueError(f"{len(lost)} given edges are not in the mesh, first near {where}")
