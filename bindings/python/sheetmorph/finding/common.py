# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes that parts of one deck share; parts of a deck split by property stay joined there."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np

from ..base.part_mesh import PartMesh

Pair = tuple[str, str]


def common_nodes(meshes: Mapping[str, PartMesh]) -> dict[Pair, list[int]]:
    """Return the ids of coincident shared nodes for each pair of parts of one file.

    A node of several parts joins each of them to the first one.
    """
    found: dict[Pair, list[int]] = {}
    files: dict[str, list[str]] = defaultdict(list)
    for name, mesh in meshes.items():
        if "/" in name and mesh.ids is not None and mesh.preparation is None:
            files[name.split("/", 1)[0]].append(name)
    for names in files.values():
        found |= _of_file(names, meshes) if len(names) > 1 else {}
    return found


def _of_file(names: Sequence[str], meshes: Mapping[str, PartMesh]) -> dict[Pair, list[int]]:
    parts = [meshes[name] for name in names]
    ids = np.concatenate([np.asarray(mesh.ids, dtype=np.int64) for mesh in parts])
    owner = np.repeat(np.arange(len(parts)), [len(mesh.points) for mesh in parts])
    points = np.concatenate([mesh.points for mesh in parts])
    order = np.lexsort((owner, ids))
    ids, owner, points = ids[order], owner[order], points[order]
    starts = np.flatnonzero(np.diff(ids, prepend=ids[0] - 1) != 0)
    first = np.repeat(starts, np.diff(np.append(starts, len(ids))))
    shared = (first != np.arange(len(ids))) & (points == points[first]).all(axis=1)
    found: dict[Pair, list[int]] = defaultdict(list)
    for row in np.flatnonzero(shared).tolist():
        found[names[owner[first[row]]], names[owner[row]]].append(int(ids[row]))
    return dict(found)


def common_entry(pair: Pair, ids: Sequence[int], meshes: Mapping[str, PartMesh]) -> dict[str, Any]:
    """Return the tied contact of common nodes, in the form of a search result."""
    rows, _ = meshes[pair[0]].find(ids)
    points = meshes[pair[0]].points[rows]
    low, high = points.min(axis=0), points.max(axis=0)
    return {
        "name": f"{pair[0]} - {pair[1]}: common nodes",
        "type": "tied",
        "kind": "edge",
        "a": {"part": pair[0], "vertices": list(ids)},
        "b": {"part": pair[1], "vertices": list(ids)},
        "distance": 0.0,
        "center": (0.5 * (low + high)).tolist(),
        "size": float(np.linalg.norm(high - low)),
    }


def missing_entries(
    meshes: Mapping[str, PartMesh], contacts: Collection[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Return contacts for the common nodes that the given contacts do not join."""
    held: dict[Pair, set[int]] = defaultdict(set)
    for entry in contacts:
        sides = [entry["a"], entry["b"]]
        if all("vertices" in side and side.get("ids") != "prepared" for side in sides):
            both = set(sides[0]["vertices"]) & set(sides[1]["vertices"])
            for a, b in ((0, 1), (1, 0)):
                held[sides[a]["part"], sides[b]["part"]] |= both
    left = {
        pair: [node for node in ids if node not in held[pair]]
        for pair, ids in common_nodes(meshes).items()
    }
    return [common_entry(pair, ids, meshes) for pair, ids in left.items() if ids]
