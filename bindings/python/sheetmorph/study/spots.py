# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that a study names: a region, a vertex, the vertex nearest to a point, or a point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Fault, RecipeError
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..recipe.model import Model, RegionEntry


@dataclass(frozen=True, eq=False)
class Spot:
    """The weighted mean, weights (k,), of vertices (k,) of a part; or a fixed point."""

    part: str = ""
    vertices: Ints = field(default_factory=lambda: np.zeros(0, np.int64))
    weights: Floats = field(default_factory=lambda: np.zeros(0))
    point: Floats | None = None

    def at(self, positions: Mapping[str, Floats]) -> Floats:
        """Return the position (3,) for positions (n, 3) by part, mm."""
        if self.point is not None:
            return self.point
        return self.weights @ positions[self.part][self.vertices]


def spot_of(told: Any, model: Model, meshes: Mapping[str, PartMesh], where: str) -> Spot:
    """Return the point that an entry of a study names. Raises RecipeError."""
    if isinstance(told, str):
        return _of_region(told, model, meshes, where)
    if isinstance(told, list):
        return Spot(point=np.asarray(told, float))
    part = told["part"]
    if part not in meshes:
        raise _error(where, f'there is no part "{part}"', f"parts are {', '.join(meshes)}")
    if ("vertex" in told) == ("near" in told):
        raise _error(
            where, "it is not clear which vertex is meant", 'give either "vertex" or "near"'
        )
    mesh = meshes[part]
    if "near" in told:
        off = np.linalg.norm(mesh.points - np.asarray(told["near"], float), axis=1)
        return _mean(part, np.array([off.argmin()]))
    vertices, missing = mesh.find([int(told["vertex"])])
    if missing:
        raise _error(where, f'"{part}" has no vertex {missing[0]}', f"it has {mesh.describe_ids()}")
    return _mean(part, vertices[:1])


def _of_region(name: str, model: Model, meshes: Mapping[str, PartMesh], where: str) -> Spot:
    regions = {region.name: region for region in model.regions}
    if name not in regions:
        known = ", ".join(regions) or "none"
        raise _error(where, f'there is no region "{name}"', f"regions are {known}")
    return _spot_of_region(regions[name], meshes)


def _spot_of_region(region: RegionEntry, meshes: Mapping[str, PartMesh]) -> Spot:
    mesh = meshes[region.part]
    if region.is_point:
        triangle, weights = mesh.place_on(load_kernel(), *region.on_triangle)
        return Spot(region.part, mesh.triangles[triangle].astype(np.int64), np.asarray(weights))
    vertices, _ = mesh.find(region.vertices or [])
    return _mean(region.part, vertices)


def _mean(part: str, vertices: Ints) -> Spot:
    count = len(vertices)
    return Spot(part, np.asarray(vertices, np.int64), np.full(count, 1.0 / count))


def _error(where: str, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(where, what, todo)])
