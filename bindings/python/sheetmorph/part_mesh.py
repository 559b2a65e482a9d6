# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles of one part, in double, with the vertex ids its file uses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np

from .arrays import Array, Floats, Ids, Ints
from .labels import Labels


def _of_kind(values: object, kinds: str, name: str) -> Array:
    """The values as an array of numbers of some numpy kinds. Raises ValueError."""
    array = np.asarray(values)
    if array.size and array.dtype.kind not in kinds:
        wanted = "numbers" if "f" in kinds else "whole numbers"
        raise ValueError(f"{name} of a part must be {wanted}, not {array.dtype}")
    return array if array.size else array.astype(np.int64)


def _as_int64(ids: Ids) -> Ints:
    """The ids (k,); those that no file can have become the largest int64, which none has either."""
    try:
        return np.asarray(ids, dtype=np.int64)
    except OverflowError:
        limits = np.iinfo(np.int64)
        return np.array([min(max(int(i), limits.min), limits.max) for i in ids], dtype=np.int64)


@dataclass(frozen=True, eq=False, repr=False)
class PartMesh:
    """One part at rest.

    points: (n, 3) float64, mm; triangles: (m, 3) int32, indices from 0; ids: (n,) int64 vertex ids
    of the file (node ids of a deck), None for 0 .. n-1; name: for messages; labels: what the file
    calls parts of it; thickness: mm, of the shells of a deck, 0 where the file does not tell.
    Raises ValueError for other shapes, numbers that are not finite, indices out of range, equal
    ids.
    """

    points: Floats
    triangles: Ints
    ids: Ints | None = None
    name: str = ""
    labels: Labels | None = None
    thickness: float = 0.0

    def __post_init__(self) -> None:
        points = np.ascontiguousarray(_of_kind(self.points, "fiu", "points"), dtype=np.float64)
        whole = _of_kind(self.triangles, "iu", "triangles")
        # Indices beyond int32 must fail the range check, not wrap around.
        triangles = np.ascontiguousarray(np.clip(whole, -1, np.iinfo(np.int32).max), np.int32)
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "triangles", triangles)
        self._check_shapes()
        if self.ids is not None:
            ids = np.ascontiguousarray(_of_kind(self.ids, "iu", "ids"), dtype=np.int64)
            object.__setattr__(self, "ids", ids)
            self._check_ids(ids)

    def __repr__(self) -> str:
        kind, name = type(self).__name__, f' "{self.name}"' if self.name else ""
        return f"<{kind}{name}: {len(self.points)} vertices, {len(self.triangles)} triangles>"

    def _check_shapes(self) -> None:
        points, triangles = self.points, self.triangles
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"points of a part must be (n, 3), not {points.shape}")
        if triangles.ndim != 2 or triangles.shape[1] != 3:
            raise ValueError(f"triangles of a part must be (m, 3), not {triangles.shape}")
        if not np.isfinite(points).all():
            bad = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
            raise ValueError(f"vertex {bad} has a coordinate that is not a finite number")
        if triangles.size and (triangles.min() < 0 or triangles.max() >= len(points)):
            raise ValueError(f"a triangle names a vertex outside 0 .. {len(points) - 1}")

    def _check_ids(self, ids: Ints) -> None:
        if ids.shape != (len(self.points),):
            raise ValueError(f"ids must be one per vertex ({len(self.points)}), not {ids.shape}")
        if len(np.unique(ids)) != len(ids):
            raise ValueError("two vertices have the same id")

    def find(self, ids: Ids, prepared: bool = False) -> tuple[Ints, list[int]]:
        """Indices (k,) int32 of the vertices with these file ids, and the ids that do not exist.

        prepared: they are those of the mesh that is deformed, which count from 0.
        """
        wanted = _as_int64(ids)
        if self.ids is None or prepared:
            indices = wanted
            found = (wanted >= 0) & (wanted < len(self.points))
        else:
            order, ordered = self._ordered_ids(self.ids)
            places = np.searchsorted(ordered, wanted)
            found = places < len(ordered)
            found[found] = ordered[places[found]] == wanted[found]
            indices = order[np.where(found, places, 0)] if len(order) else places
        missing = [int(ids[k]) for k in np.flatnonzero(~found)]
        return indices[found].astype(np.int32), missing

    def _ordered_ids(self, ids: Ints) -> tuple[Ints, Ints]:
        """Indices (n,) in the order of the ids, and the ids in that order."""
        cached = self.__dict__.get("_order")
        if cached is None:
            order = np.argsort(ids, kind="stable")
            cached = order, ids[order]
            object.__setattr__(self, "_order", cached)
        return cached

    def file_ids(self, indices: Ids) -> list[int]:
        """File ids of the vertices with these indices."""
        rows = np.asarray(indices, dtype=np.int64)
        found: list[int] = (rows if self.ids is None else self.ids[rows]).tolist()
        return found

    @property
    def preparation(self) -> dict[str, Any] | None:
        """What weld and remesh did to the mesh of the file; None if they did nothing."""
        return None

    @property
    def file_triangle_count(self) -> int:
        """How many triangles a recipe may name."""
        return len(self.triangles)

    def place_on(
        self, _core: ModuleType, triangle: int, barycentric: Sequence[float]
    ) -> tuple[int, Sequence[float]]:
        """Triangle and barycentric coordinates here of a point on a triangle of the file."""
        return triangle, barycentric

    def restricted(self, vertices: Ints, corners: Ints, name: str) -> PartMesh:
        """Some of its vertices (k,), and triangles (m, 3) over them; the ids stay."""
        ids = np.array(self.file_ids(vertices), dtype=np.int64)
        return PartMesh(self.points[vertices], corners, ids, name)

    def with_indices(self) -> PartMesh:
        """The same mesh alone, its vertices called by their indices, in its labels too."""
        labels = self.labels
        if labels is not None:
            named = {name: self.find(ids)[0].tolist() for name, ids in labels.nodes.items()}
            labels = replace(labels, nodes={name: ids for name, ids in named.items() if ids})
        return PartMesh(self.points, self.triangles, name=self.name, labels=labels)

    def describe_ids(self, prepared: bool = False) -> str:
        """The ids a recipe may use, for messages: "0 .. 41" or "node ids 1 .. 9999 of the deck"."""
        if not len(self.points):
            return "it has none"
        if self.ids is None or prepared:
            return f"0 .. {len(self.points) - 1}"
        return f"node ids of its deck, {self.ids.min()} .. {self.ids.max()}"
