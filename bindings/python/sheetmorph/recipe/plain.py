# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes and poses made in Python: arrays, tuples and masks become what JSON has."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..base.arrays import Bools
from ..base.errors import Fault, RecipeError
from ..base.part_mesh import PartMesh
from .places import place_of
from .pose import is_plainly_sound
from .values import are_ids


def plain(node: Any, meshes: Mapping[str, PartMesh] | None = None) -> Any:
    """Return data with lists and numbers of Python in place of those of numpy.

    A mask is an array of bool with an entry for each vertex of its part; meshes turn it into the
    ids of these vertices. Raises RecipeError if a mask does not fit its part.
    """
    return _Plain(node, meshes or {}).of(node, ())


def plain_pose(pose: Any) -> Any:
    """Return the same for a pose; the usual form stays the same object."""
    return pose if is_plainly_sound(pose) else plain(pose)


class _Plain:
    """The conversion of one recipe."""

    def __init__(self, recipe: Any, meshes: Mapping[str, PartMesh]):
        self._recipe, self._meshes = recipe, meshes
        self._part: Any = None  # name of the part that the present entry is on

    def of(self, node: Any, place: tuple[str | int, ...], is_prepared: bool = False) -> Any:
        """Return the data at a place; is_prepared states what ids beside it count."""
        if isinstance(node, dict):
            return self._object(node, place)
        if isinstance(node, np.ndarray):
            is_mask = node.dtype == np.bool_ and node.ndim == 1
            return self._ids(node, place, is_prepared) if is_mask else node.tolist()
        if isinstance(node, np.generic):
            return node.item()
        if isinstance(node, (list, tuple, range)) and not are_ids(node):
            return [self.of(child, (*place, k)) for k, child in enumerate(node)]
        return node

    def _object(self, node: dict[str, Any], place: tuple[str | int, ...]) -> dict[str, Any]:
        outer = self._part
        self._part = node.get("name" if place[:-1] == ("parts",) else "part", outer)
        is_prepared = node.get("ids") == "prepared"
        found = {key: self.of(child, (*place, key), is_prepared) for key, child in node.items()}
        self._part = outer
        return found

    def _ids(self, mask: Bools, place: tuple[str | int, ...], is_prepared: bool) -> list[int]:
        mesh = self._meshes.get(str(self._part))
        where = place_of(self._recipe, place)
        if mesh is None:
            what = "a mask belongs to no part with a mesh"
            raise RecipeError([Fault(where, what, "give vertex ids")])
        if len(mask) != len(mesh.points):
            what = f"the mask has {len(mask)} entries, but the part has {len(mesh.points)} vertices"
            raise RecipeError([Fault(where, what, "give an entry for each vertex")])
        rows: list[int] = np.flatnonzero(mask).tolist()
        return rows if is_prepared else mesh.file_ids(rows)
