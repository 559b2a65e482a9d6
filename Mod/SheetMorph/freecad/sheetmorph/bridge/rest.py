# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of an assembly at rest, in double precision and global coordinates."""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad.sheetmorph.bridge import conversion, kernel, stored_arrays
from freecad.sheetmorph.bridge.snapshots import Snapshot, snapshot_of
from freecad.sheetmorph.bridge.conversion import Frame
from freecad.sheetmorph.objects.errors import MorphError


_KNOWN = ("labels", "rows", "faces")
"""Data that an edited mesh loses."""


@dataclass(frozen=True, eq=False)
class RestPart:
    """One part at rest."""

    label: str
    points: np.ndarray  # (n, 3) float64, global, mm
    triangles: np.ndarray  # (m, 3) int32
    ids: np.ndarray | None  # (n,) vertex ids of the file; None for the indices
    frame: Frame
    is_from_file: bool = False  # in double precision, with the vertices of its file
    rows: np.ndarray | None = None  # (n,) vertex indices in the mesh of a deck
    faces: np.ndarray | None = None  # (e, 4) corners of elements, -1 last for triangles

    def file_ids(self) -> np.ndarray:
        """Return the file ids (n,) of the vertices."""
        return np.arange(len(self.points)) if self.ids is None else self.ids

    @cached_property
    def digest(self) -> str:
        """A fingerprint of points, triangles and ids."""
        state = hashlib.blake2b(self.points.tobytes(), digest_size=16)
        state.update(self.triangles.tobytes())
        state.update(b"" if self.ids is None else self.ids.tobytes())
        return state.hexdigest()


def read_rest(part) -> RestPart:
    """Return `part` at rest.

    An imported part has the double precision positions of its file until somebody edits its source
    mesh. Any other part has the single precision positions of its source mesh. Raises MorphError if
    the source is missing or empty.
    """
    source = part.Source
    if source is None:
        raise MorphError(
            f"Part '{part.Label}' has lost its source mesh: undo its deletion or delete the part.",
            part,
        )
    if source.Mesh.CountFacets == 0:
        raise MorphError(
            f"The mesh '{source.Label}' of part '{part.Label}' has no triangles.", part
        )
    kept, is_original = read_kept(part), part.Original is None

    def rest() -> RestPart:
        is_unmoved = kept.frame.is_unmoved()
        points = kept.points if is_unmoved else kept.frame.to_global(kept.points)
        points.setflags(write=False)
        is_from_file = kept.is_exact and is_original
        known = (kept.triangles, kept.ids, kept.frame, is_from_file, kept.rows, kept.faces)
        return RestPart(part.Label, points, *known)

    key = (part.Label, version_of(part.RestData), kept.frame.key, is_original)
    return snapshot_of(source).derived(f"rest of {part.Name}", key, rest)


@dataclass(frozen=True, eq=False)
class Kept:
    """A mesh in the form stored by a document, in file coordinates."""

    points: np.ndarray  # (n, 3) float64
    triangles: np.ndarray  # (m, 3) int32
    ids: np.ndarray | None  # (n,) vertex ids of the file; None for the indices
    frame: Frame
    features: list[dict]  # exact features; empty for most parts
    is_exact: bool  # in double precision; else that of the mesh object, in single precision
    labels: object = None  # a sheetmorph.base.labels.Labels with the names in the file
    rows: np.ndarray | None = None  # as in RestPart
    faces: np.ndarray | None = None


def read_kept(part) -> Kept:
    """Return the rest mesh of `part`."""
    return read_mesh_of(part.Source, part.RestData)


def read_original(part) -> Kept:
    """Return the mesh that was added or imported, before any preparation."""
    if part.Original is None:
        return read_kept(part)
    return read_mesh_of(part.Original, part.OriginalData)


def read_mesh_of(source, path: str) -> Kept:
    """Return the mesh of `source`, in double precision if the data at `path` is still valid."""
    snapshot = snapshot_of(source)
    key = version_of(path)
    stored = snapshot.derived("rest data", key, lambda: rest_data_of(snapshot, path))
    frame = conversion.frame_of(source, stored["origin"])
    known = (stored["ids"], frame, *(stored[key] for key in ("features", "is_exact", *_KNOWN)))
    return Kept(stored["points"], snapshot.triangles, *known)


def version_of(path: str) -> tuple | None:
    """Return a key that changes with the file at `path`."""
    if not path:
        return None
    state = os.stat(path)
    return path, state.st_ino, state.st_mtime_ns, state.st_size


def rest_data_of(snapshot: Snapshot, path: str) -> dict:
    """Return points in double, ids, origin and features, from the file if it matches the mesh."""
    stored = read_rest_data(path)
    is_exact = stored is not None and is_same_mesh(stored, snapshot.points, snapshot.triangles)
    if not is_exact:
        stored = {"points": snapshot.points.astype(float), "ids": None, "features": []}
        stored |= dict.fromkeys(_KNOWN)
        stored["origin"] = np.zeros(3)
    stored["points"].setflags(write=False)
    return {**stored, "is_exact": is_exact}


def read_rest_data(path: str) -> dict | None:
    """Return the data of `write_rest_data`, or None without a path."""
    if not path:
        return None
    with stored_arrays.opened(path) as data:
        stored = {name: data[name] for name in ("points", "ids", "origin")}
        # Older documents have the triangles themselves.
        is_early = "triangles" in data
        stored["topology"] = topology_of(data["triangles"]) if is_early else data["topology"]
        told = stored_arrays.text_in(data["features"]) if "features" in data else "[]"
        labels = kernel.labels_module().Labels.of_arrays(data) if kernel.is_available() else None
        of_deck = {name: data[name] if name in data else None for name in ("rows", "faces")}
    if len(stored["ids"]) == 0:
        stored["ids"] = None
    return {**stored, "features": json.loads(told), "labels": labels, **of_deck}


def write_rest_data(
    path: str, mesh, origin: np.ndarray, features: list[dict] = (), **of_deck: np.ndarray
) -> None:
    """Write the double precision data of a sheetmorph.PartMesh with its `origin` (3,).

    `features` are those of a CAD part, with vertex indices. `of_deck` has rows and faces.
    """
    ids = np.zeros(0, np.int64) if mesh.ids is None else mesh.ids
    known = stored_arrays.of_text(json.dumps(list(features)))
    arrays = {"points": mesh.points, "ids": ids, "origin": origin, "features": known}
    labels = {} if mesh.labels is None else mesh.with_indices().labels.arrays()
    topology = topology_of(mesh.triangles)
    stored_arrays.write(path, topology=topology, **arrays, **labels, **of_deck)


def topology_of(triangles: np.ndarray) -> np.ndarray:
    """Return a fingerprint of triangles (m, 3); the mesh object has the triangles themselves."""
    numbers = np.ascontiguousarray(triangles, np.int32).tobytes()
    return np.frombuffer(hashlib.blake2b(numbers, digest_size=16).digest(), np.uint8)


def is_same_mesh(stored: dict, local: np.ndarray, triangles: np.ndarray) -> bool:
    """Return whether the source mesh is bitwise the imported one in single precision."""
    if stored["points"].shape != local.shape:
        return False
    imported = (stored["points"] - stored["origin"]).astype(np.float32)
    is_same = np.array_equal(stored["topology"], topology_of(triangles))
    return bool(is_same and np.array_equal(imported, local))
