# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of an assembly at rest, read from the document in double and in global coordinates."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad.sheetmorph import conversion
from freecad.sheetmorph.conversion import Frame


class MorphError(ValueError):
    """A morph that cannot be computed; one sentence: where, what, what to do."""


@dataclass(frozen=True, eq=False)
class RestPart:
    """One part at rest."""

    label: str
    points: np.ndarray  # (n, 3) float64, global, mm
    triangles: np.ndarray  # (m, 3) int32
    ids: np.ndarray | None  # (n,) vertex ids of the file; None: the indices
    frame: Frame
    is_from_file: bool = False  # in double and, vertex by vertex, as in the file it came from

    def file_ids(self) -> np.ndarray:
        """Return the ids (n,) of the vertices in the part's file."""
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

    An imported part has its positions from the file, in double, as long as nobody edited its
    source mesh; any other has the single precision positions of its source mesh.
    Raises MorphError if the source is missing or empty.
    """
    source = part.Source
    if source is None:
        raise MorphError(
            f"Part '{part.Label}' has lost its source mesh: undo its deletion or delete the part."
        )
    local, triangles = conversion.read_mesh(source.Mesh)
    if len(triangles) == 0:
        raise MorphError(f"The mesh '{source.Label}' of part '{part.Label}' has no triangles.")
    stored = read_rest_data(part)
    is_from_file = stored is not None and is_same_mesh(stored, local, triangles)
    if is_from_file:
        points, ids, origin = stored["points"], stored["ids"], stored["origin"]
    else:
        points, ids, origin = local.astype(float), None, np.zeros(3)
    frame = conversion.frame_of(source, origin)
    return RestPart(part.Label, frame.to_global(points), triangles, ids, frame, is_from_file)


def read_rest_data(part) -> dict | None:
    """Return what `write_rest_data` stored with an imported part; None for any other part."""
    if not part.RestData:
        return None
    with np.load(part.RestData, allow_pickle=False) as data:
        stored = {name: data[name] for name in ("points", "triangles", "ids", "origin")}
    if len(stored["ids"]) == 0:
        stored["ids"] = None
    return stored


def write_rest_data(path: str, mesh, origin: np.ndarray, features: list[dict] = ()) -> None:
    """Write the doubles of an imported part: `mesh` is a sheetmorph.PartMesh, `origin` (3,).

    `features`: those of a CAD part, whose vertices are indices.
    """
    ids = np.zeros(0, np.int64) if mesh.ids is None else mesh.ids
    known = json.dumps(list(features))
    arrays = {"points": mesh.points, "triangles": mesh.triangles, "ids": ids, "origin": origin}
    np.savez(path, features=np.array(known), **arrays)


def read_features(part) -> list[dict]:
    """Return what `write_rest_data` kept as features, in file coordinates; none for most parts."""
    if not part.RestData:
        return []
    with np.load(part.RestData, allow_pickle=False) as data:
        return json.loads(str(data["features"])) if "features" in data else []


def is_same_mesh(stored: dict, local: np.ndarray, triangles: np.ndarray) -> bool:
    """Whether the source mesh still is what was imported, bit for bit in single precision."""
    if stored["points"].shape != local.shape or stored["triangles"].shape != triangles.shape:
        return False
    imported = (stored["points"] - stored["origin"]).astype(np.float32)
    return bool(np.array_equal(imported, local) and np.array_equal(stored["triangles"], triangles))
