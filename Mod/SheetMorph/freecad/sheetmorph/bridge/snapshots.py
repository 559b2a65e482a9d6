# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the document as arrays, each read once until it changes.

FreeCAD provides a mesh only through a file, which takes longer than most uses of it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, lru_cache
from typing import Any

import FreeCAD
import numpy as np

from freecad.sheetmorph.bridge import conversion


class Snapshot:
    """The current state of a mesh; its arrays are read-only."""

    def __init__(self, mesh):
        """Read a FreeCAD mesh."""
        self.points, self.triangles = conversion.read_mesh(mesh)  # (n, 3) float32 local, (m, 3)
        self.points.setflags(write=False)
        self.triangles.setflags(write=False)
        self._derived: dict[str, tuple[Any, Any]] = {}

    def touching(self, vertices: np.ndarray) -> np.ndarray:
        """Return the triangles (k, 3) with a corner among `vertices`, in their order."""
        starts, triangles = self._around
        inside = vertices[(vertices >= 0) & (vertices < len(starts) - 1)]
        counts = starts[inside + 1] - starts[inside]
        ends = np.cumsum(counts)
        places = np.arange(counts.sum()) + np.repeat(starts[inside] - (ends - counts), counts)
        return self.triangles[np.unique(triangles[places])]

    def derived(self, name: str, key: Any, make: Callable[[], Any]) -> Any:
        """Return a value computed from the mesh and `key`; it is cached while both stay."""
        kept = self._derived.get(name)
        if kept is None or kept[0] != key:
            kept = self._derived[name] = (key, make())
        return kept[1]

    @cached_property
    def _around(self) -> tuple[np.ndarray, np.ndarray]:
        """Start index of each vertex in a list of triangles, and that list."""
        corners = self.triangles.ravel()
        counts = np.bincount(corners, minlength=len(self.points))
        return (np.concatenate([[0], np.cumsum(counts)]), np.argsort(corners, kind="stable") // 3)


class Snapshots:
    """The snapshots of all documents; an observer that discards outdated ones."""

    def __init__(self) -> None:
        self._kept: dict[str, dict[str, Snapshot]] = {}

    def of(self, feature) -> Snapshot:
        """Return the mesh of a `Mesh::Feature`."""
        mine = self._kept.setdefault(feature.Document.Name, {})
        mesh = feature.Mesh
        kept = mine.get(feature.Name)
        if kept is None or not is_as_large(kept, mesh):
            kept = mine[feature.Name] = Snapshot(mesh)
        return kept

    def slotChangedObject(self, obj, name: str) -> None:
        """Handle the change of a property, also by undo."""
        if name == "Mesh" and obj.Document.Name in self._kept:
            self._kept[obj.Document.Name].pop(obj.Name, None)

    def slotDeletedObject(self, obj) -> None:
        """Discard a snapshot, because another object may get its name."""
        self._kept.get(obj.Document.Name, {}).pop(obj.Name, None)

    def slotDeletedDocument(self, document) -> None:
        """Discard the snapshots, because another document may get its name."""
        self._kept.pop(document.Name, None)


def is_as_large(snapshot: Snapshot, mesh) -> bool:
    """Return whether the counts of a snapshot and a mesh agree.

    When a document opens, its meshes arrive late.
    """
    counts = (len(snapshot.points), len(snapshot.triangles))
    return counts == (mesh.CountPoints, mesh.CountFacets)


@lru_cache(maxsize=1)
def _all() -> Snapshots:
    found = Snapshots()
    FreeCAD.addDocumentObserver(found)
    return found


def snapshot_of(feature) -> Snapshot:
    """Return the current mesh of a `Mesh::Feature` in local coordinates."""
    return _all().of(feature)
