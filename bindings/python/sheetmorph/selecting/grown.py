# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions grown or shrunk, by rings of triangles or by a length along the sheet."""

from __future__ import annotations

import heapq
from typing import Any

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from .chosen import Chosen
from .part_shape import PartShape


def grown(shape: PartShape, inner: Chosen, amount: Any) -> Chosen:
    """Return a region with its surroundings: a number of rings, or {"length": mm}."""
    if isinstance(amount, dict):
        length = float(amount["length"])
        inside = _distances(shape, inner.inside, length) <= length + shape.slack
        share = np.maximum(inner.share, inside[shape.triangles].mean(axis=1))
    else:
        found = np.asarray(shape.near.grown(inner.vertices.astype(np.int32), int(amount)))
        inside = inner.inside.copy()
        inside[found] = True
        share = np.maximum(inner.share, inside[shape.triangles].all(axis=1))
    return Chosen(inside, share, inner.matches, inner.remarks)


def shrunk(shape: PartShape, inner: Chosen, amount: Any) -> Chosen:
    """Return a region without its outer zone; it does not shrink at borders of the sheet."""
    if isinstance(amount, dict):
        length = float(amount["length"])
        inside = inner.inside & (_distances(shape, _rim(shape, inner), length) >= length)
        share = np.minimum(inner.share, inside[shape.triangles].mean(axis=1))
    else:
        found = np.asarray(shape.near.shrunk(inner.vertices.astype(np.int32), int(amount)))
        inside = np.zeros_like(inner.inside)
        inside[found] = True
        share = np.minimum(inner.share, inside[shape.triangles].all(axis=1))
    return Chosen(inside, share, inner.matches, inner.remarks)


def _rim(shape: PartShape, inner: Chosen) -> Bools:
    """Return the vertices (n,) of a region that border on its outside."""
    is_mixed = inner.inside[shape.triangles].any(axis=1) & ~inner.inside[shape.triangles].all(
        axis=1
    )
    beside = np.zeros_like(inner.inside)
    beside[shape.triangles[is_mixed]] = True
    return beside & inner.inside


def _distances(shape: PartShape, start: Bools, length: float) -> Floats:
    """Return distances (n,) of the vertices from a start region, infinite beyond a length.

    The search follows edges. Each vertex takes the straight distance to the start vertex of its
    predecessor.
    """
    around = _neighbours(shape)
    limit = length + shape.slack
    points = shape.points
    best = np.where(start, 0.0, np.inf)
    queue = [(0.0, v, v) for v in np.flatnonzero(start).tolist()]
    while queue:
        distance, vertex, source = heapq.heappop(queue)
        if distance > best[vertex]:
            continue
        for other in around[vertex]:
            away = float(np.linalg.norm(points[other] - points[source]))
            if away <= limit and away < best[other]:
                best[other] = away
                heapq.heappush(queue, (away, int(other), source))
    return best


def _neighbours(shape: PartShape) -> list[Ints]:
    """Return for every vertex its neighbours along edges."""
    pairs = shape.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    both = np.unique(np.concatenate([pairs, pairs[:, ::-1]]), axis=0)
    ends = np.searchsorted(both[:, 0], np.arange(len(shape.points) + 1))
    return [both[ends[v] : ends[v + 1], 1] for v in range(len(shape.points))]
