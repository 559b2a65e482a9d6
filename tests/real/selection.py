# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person would pick by eye on a real assembly: ends, round holes, places that touch."""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from sheetmorph import PartMesh, _core
from sheetmorph.recipe.model import model_of
from sheetmorph.recipe.parts import read_parts

Meshes = dict[str, PartMesh]


def read_meshes(entries: list[dict], base: str | Path) -> Meshes:
    """The meshes of the entries of `parts` of a recipe, by part name; they are read once."""
    return dict(read_once(json.dumps(entries), base))


@lru_cache(maxsize=4)
def read_once(entries: str, base: str | Path) -> Meshes:
    """The same for entries as JSON."""
    return read_parts(model_of({"parts": json.loads(entries)}).parts, base).meshes


def region(meshes: Meshes, part: str, chosen: np.ndarray, **more: object) -> dict:
    """An entry of a recipe: a part and those of its vertices that a mask (n,) chooses."""
    used = np.zeros(len(meshes[part].points), dtype=bool)
    used[meshes[part].triangles] = True
    vertices = np.flatnonzero(np.asarray(chosen) & used)
    return {"part": part, "vertices": meshes[part].file_ids(vertices), **more}


def round_holes(meshes: Meshes, rings: int = 1, tolerance: float = 0.02) -> list[dict]:
    """A form feature for every round hole: its rim and some rings of triangles around it."""
    found = []
    for part, mesh in meshes.items():
        rest = _core.TriangleMesh(mesh.points, mesh.triangles)
        for number, hole in enumerate(_core.round_holes(rest, tolerance), start=1):
            wide = _core.grow_rings(rest, hole.rim, rings)
            found.append(
                {"name": f"{part} hole {number}", "part": part, "vertices": mesh.file_ids(wide)}
            )
    return found


@dataclass(frozen=True)
class Touching:
    """How contacts are found.

    reach: largest distance, mm, of a vertex from the other part's surface; kind: type of the
    contacts; smallest: vertices that a side has at least.
    """

    reach: float
    kind: str = "control mesh"
    smallest: int = 3


def contacts(meshes: Meshes, how: Touching) -> list[dict]:
    """A contact for every place where two parts touch; a pair may touch in several places."""
    trees = {name: _core.PickingTree(m.points, m.triangles) for name, m in meshes.items()}
    found = []
    for pair in itertools.combinations(meshes, 2):
        sides = [
            near(meshes[one].points, meshes[other], (trees[other], how.reach))
            for one, other in (pair, pair[::-1])
        ]
        places = [
            place
            for place in split_places([meshes[name] for name in pair], sides, how.reach)
            if min(len(side) for side in place) >= how.smallest
        ]
        for number, place in enumerate(places, start=1):
            entry: dict = {"name": f"{pair[0]} - {pair[1]} {number}", "type": how.kind}
            for key, name, vertices in zip("ab", pair, place):
                entry[key] = {"part": name, "vertices": meshes[name].file_ids(vertices)}
            found.append(entry)
    return found


def near(points: np.ndarray, mesh: PartMesh, where: tuple) -> np.ndarray:
    """Indices (k,) of points (n, 3) within reach of a mesh; where: its picking tree and reach."""
    tree, reach = where
    used = mesh.points[np.unique(mesh.triangles)]
    low, high = used.min(axis=0) - reach, used.max(axis=0) + reach
    candidates = np.flatnonzero(np.all((points >= low) & (points <= high), axis=1))
    close = [tree.nearest_point(points[v]).distance <= reach for v in candidates]
    return candidates[np.array(close, dtype=bool)]


def split_places(
    pair: list[PartMesh], sides: list[np.ndarray], reach: float
) -> list[tuple[np.ndarray, np.ndarray]]:
    """The touching vertices of two parts, place by place.

    Vertices belong together along edges of their own part, and across both parts where they are
    no farther apart than one edge and the reach.
    """
    offset = len(pair[0].points)
    points = np.concatenate([mesh.points for mesh in pair])
    chosen = np.zeros(len(points), dtype=bool)
    chosen[sides[0]] = chosen[sides[1] + offset] = True
    triangles = np.concatenate([pair[0].triangles, pair[1].triangles + offset])
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    limit = reach + np.median(lengths)
    edges = edges[chosen[edges].all(axis=1)]
    if len(sides[0]) and len(sides[1]):
        edges = np.concatenate([edges, across(points, (sides[0], sides[1] + offset), limit)])
    graph = coo_matrix((np.ones(len(edges)), edges.T), shape=(len(points), len(points)))
    _, labels = connected_components(graph, directed=False)
    places = {label: ([], []) for label in labels[np.flatnonzero(chosen)].tolist()}
    for vertex in np.flatnonzero(chosen):
        side = int(vertex >= offset)
        places[labels[vertex]][side].append(vertex - side * offset)
    return [tuple(np.array(side, dtype=int) for side in place) for place in places.values()]


def across(points: np.ndarray, sides: tuple, limit: float) -> np.ndarray:
    """Pairs (k, 2): every touching vertex and the nearest one of the other part, if it is near."""
    pairs = []
    for one, other in (sides, sides[::-1]):
        away, nearest = cKDTree(points[other]).query(points[one])
        pairs.append(np.column_stack([one, other[nearest]])[away <= limit])
    return np.concatenate(pairs)
