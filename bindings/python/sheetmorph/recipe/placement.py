# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placement of a part in the assembly, for files with local coordinates."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.part_mesh import PartMesh
from ..files.prepared_mesh import PreparedMesh

_IDENTITY = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True)
class Placement:
    """The mapping x -> rotation x + translation, mm; rotation has its rows."""

    rotation: tuple[tuple[float, ...], ...] = _IDENTITY
    translation: tuple[float, ...] = (0.0, 0.0, 0.0)

    @classmethod
    def of(cls, translation: Sequence[float], axis: Sequence[float], degrees: float) -> Placement:
        """Return a rotation about the file origin followed by a translation.

        An axis of zero length gives no rotation. Quarter turns about a coordinate axis are exact.
        """
        direction = np.asarray(axis, dtype=float)
        length = float(np.linalg.norm(direction))
        unit = direction / length if length > 1e-100 else np.zeros(3)
        x, y, z = unit.tolist()
        quarter, rest = divmod(degrees % 360.0, 90.0)
        if rest == 0.0:
            sine, cosine = ((0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0))[int(quarter) % 4]
        else:
            sine, cosine = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        rotation = np.eye(3) + sine * cross + (1.0 - cosine) * (cross @ cross)
        return cls(tuple(map(tuple, rotation.tolist())), tuple(map(float, translation)))

    @classmethod
    def of_entry(cls, entry: dict[str, Any]) -> Placement:
        """Return the placement of the recipe key `placement`."""
        turn = entry.get("rotation")
        axis, degrees = ((0.0, 0.0, 1.0), 0.0) if turn is None else (turn["axis"], turn["degrees"])
        return cls.of(entry.get("translation", (0.0, 0.0, 0.0)), axis, degrees)

    def __bool__(self) -> bool:
        return self != Placement()

    def placed(self, points: Floats) -> Floats:
        """Map points (n, 3) from file to assembly coordinates."""
        found: Floats = points @ np.array(self.rotation).T + self.translation if self else points
        return found

    def taken_back(self, points: Floats) -> Floats:
        """Map points (n, 3) from assembly to file coordinates."""
        found: Floats = (points - self.translation) @ np.array(self.rotation) if self else points
        return found

    def placed_mesh(self, mesh: PartMesh) -> PartMesh:
        """Map a mesh to assembly coordinates, with the source of a prepared mesh."""
        if not self:
            return mesh
        placed = replace(mesh, points=self.placed(mesh.points))
        if isinstance(placed, PreparedMesh):
            placed = replace(placed, source=self.placed_mesh(placed.source))
        return placed

    def placed_entry(self, entry: dict[str, Any]) -> dict[str, Any]:
        """Map the centre and axis of a found feature to assembly coordinates."""
        turn = np.array(self.rotation)
        found = dict(entry)
        if "center" in entry:
            found["center"] = (turn @ np.array(entry["center"]) + self.translation).tolist()
        if "axis" in entry:
            found["axis"] = (turn @ np.array(entry["axis"])).tolist()
        return found
