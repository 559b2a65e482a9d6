# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of feature motions, groups, pairs and the symmetry plane."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set

import numpy as np

from ..base.errors import Fault
from ..recipe.feature_entries import RelationEntry, Vector
from ..recipe.model import Model, RegionEntry

_SHORTEST = 1e-100
_KEYS = {"plane": ("normal",), "line": ("direction",), "axis": ("point", "direction")}


def relation_faults(model: Model, declared: Set[str]) -> list[Fault]:
    """Return the faults of motions, groups, pairs and symmetry.

    declared has names that exist, even if their entries are faulty.
    """
    features = {region.name: region for region in model.of_kind("feature")}
    faults = [
        fault.about(feature.subject) for feature in features.values() for fault in _motion(feature)
    ]
    for relation in model.relations:
        found = _members(relation, features, declared)
        faults += [fault.about(relation.subject) for fault in found]
    if model.symmetry is not None:
        faults += _direction("symmetry.normal", "normal", model.symmetry.normal)
    return faults


def _motion(feature: RegionEntry) -> Iterator[Fault]:
    motion, where = feature.motion, f"{feature.where}.motion"
    for key in _KEYS.get(motion.type, ()):
        if key not in motion.keys:
            what = f'the motion "{motion.type}" needs the key "{key}"'
            yield Fault(where, what, f'add "{key}": [x, y, z]')
    if motion.direction is not None:
        key = "direction" if "direction" in motion.keys else "normal"
        yield from _direction(f"{where}.{key}", key, motion.direction)


def _direction(where: str, key: str, direction: Vector) -> Iterator[Fault]:
    if np.linalg.norm(direction) < _SHORTEST:
        yield Fault(where, f"the {key} has no length", "give it a direction, for example [0, 0, 1]")


def _members(
    relation: RelationEntry, features: Mapping[str, RegionEntry], declared: Set[str]
) -> Iterator[Fault]:
    where = f"{relation.where}.features"
    for name in relation.features:
        if name not in features and name not in declared:
            known = ", ".join(f'"{feature}"' for feature in sorted(features))
            todo = f"names are {known}" if known else "add one"
            yield Fault(where, f'there is no feature "{name}"', todo)
    if len(set(relation.features)) < len(relation.features):
        yield Fault(where, "a feature is named twice", "name each once")
    parts = {features[name].part for name in relation.features if name in features}
    if relation.type == "group" and len(parts) > 1:
        named = " and ".join(f'"{part}"' for part in sorted(parts))
        what = f"a group needs features of one part, and these are on the parts {named}"
        yield Fault(where, what, 'join the parts with a contact of type "rigid"')
