# SPDX-License-Identifier: LGPL-2.1-or-later
"""A recipe with other numbers, split into the factorised part and a pose."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import Fault, RecipeError
from .blends import with_pose
from .paths import value_at, with_value
from .reading import Parameter

# Keys of region entries that a pose can override, by section.
_POSABLE = {
    "features": ("size", "rotation"),
    "points": ("target", "rotation"),
    "handles": ("pivot",),
}
Place = Callable[[Any, str], Floats]


@dataclass(frozen=True)
class Variant:
    """A variant: recipe is factorised, pose is applied to it.

    key is equal for all variants that share the pre-processing phase.
    """

    recipe: dict[str, Any]
    pose: dict[str, Any]
    key: str


class Changes:
    """Maker of variants of a recipe; place_of returns the rest position (3,) of a point, mm."""

    def __init__(self, recipe: dict[str, Any], parameters: tuple[Parameter, ...], place_of: Place):
        self._recipe = recipe
        self._parameters = [entry for entry in parameters if entry.steps or entry.blend]
        self._lines = {
            entry.name: _line(entry, place_of)
            for entry in self._parameters
            if entry.direction is not None or entry.distance_from is not None
        }
        for entry in self._parameters:
            self._check(entry)

    def variant(self, values: Mapping[str, float]) -> Variant:
        """Return the variant for parameter values. Raises RecipeError."""
        changed = self.changed(values)
        base = {key: value for key, value in changed.items() if key not in ("pose", "poses")}
        pose = dict(changed.get("pose") or {})
        touched: dict[str, Any] = {}
        for entry in self._parameters:
            if entry.steps and entry.steps[0] != "pose":
                base, pose = _as_pose(base, pose, entry, self._recipe)
                touched[json.dumps(entry.steps)] = value_at(base, entry.steps)
        return Variant(base, pose, json.dumps(touched, sort_keys=True))

    def changed(self, values: Mapping[str, float]) -> dict[str, Any]:
        """Return the whole recipe for parameter values. Raises RecipeError."""
        recipe = self._recipe
        for entry in self._parameters:
            recipe = self._with(recipe, entry, values[entry.name])
        return recipe

    def _with(self, recipe: dict[str, Any], entry: Parameter, value: float) -> dict[str, Any]:
        if entry.blend is not None:
            other = self._recipe["poses"][entry.blend]
            return {**recipe, "pose": with_pose(recipe.get("pose", {}), other, value, entry.where)}
        if entry.name not in self._lines:
            return with_value(recipe, entry.steps, value, entry.where)
        direction, start = self._lines[entry.name]
        begun = np.asarray(value_at(recipe, entry.steps) or (0.0, 0.0, 0.0), float)
        moved = (begun + (value - start) * direction).tolist()
        return with_value(recipe, entry.steps, moved, entry.where)

    def _check(self, entry: Parameter) -> None:
        """Check that the path of a parameter leads to a number. Raises RecipeError."""
        if entry.blend is not None:
            names = list(self._recipe.get("poses", {}))
            if entry.blend not in names:
                todo = f"there are {', '.join(names)}" if names else 'give the recipe "poses"'
                raise _error(entry, f'the recipe has no pose "{entry.blend}"', todo)
            return
        with_value(self._recipe, entry.steps, 0.0, entry.where)
        found = value_at(self._recipe, entry.steps)
        is_number = isinstance(found, (int, float)) and not isinstance(found, bool)
        if found is not None and not is_number and entry.name not in self._lines:
            what = f"its path leads to a {_kind(found)}, not to a number"
            raise _error(entry, what, "extend the path to one of its numbers")


def _line(entry: Parameter, place_of: Place) -> tuple[Floats, float]:
    """Return the unit direction (3,) of a handle's motion, and the value without a motion."""
    if entry.direction is not None:
        direction, start = np.asarray(entry.direction, float), 0.0
        return direction / np.linalg.norm(direction), start
    offset = place_of(str(entry.steps[1]), entry.where) - place_of(
        entry.distance_from, f"{entry.where}.distance_from"
    )
    length = float(np.linalg.norm(offset))
    if not length > 0.0:
        raise _error(
            entry,
            "the handle is already at the place from which its distance is measured",
            "choose another one",
        )
    return offset / length, length


def _as_pose(
    base: dict[str, Any], pose: dict[str, Any], entry: Parameter, recipe: dict[str, Any]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Move a changed value from the recipe to the pose, if a pose can express it."""
    steps = entry.steps
    if len(steps) < 3 or steps[2] not in _POSABLE.get(str(steps[0]), ()):
        return base, pose
    told, region = value_at(base, steps[:3]), value_at(base, steps[:2])
    before = value_at(recipe, steps[:3])
    name = region.get("name")
    if before is None or name is None or (steps[2] == "rotation" and not isinstance(told, dict)):
        return base, pose
    motion = pose.get(name, {})
    return (
        with_value(base, steps[:3], before, entry.where),
        pose if steps[2] in motion else {**pose, name: {**motion, str(steps[2]): told}},
    )


def _kind(found: Any) -> str:
    names: dict[type, str] = {dict: "JSON object", list: "list", str: "text"}
    return names.get(type(found), "truth value")


def _error(entry: Parameter, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(entry.where, what, todo)])
