# SPDX-License-Identifier: LGPL-2.1-or-later
"""Weighted sums of the poses of a recipe."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import Fault, RecipeError

_BLENDED = {"translation", "rotation", "pivot"}


def with_pose(
    pose: dict[str, Any], other: dict[str, Any], share: float, where: str
) -> dict[str, Any]:
    """Add a share of another pose to a pose; both have a checked form.

    Translations are scaled. The product of rotation axis and angle is added, so that whole turns
    count. Raises RecipeError.
    """
    added = dict(pose)
    for name, motion in other.items():
        odd = sorted(set(motion) - _BLENDED)
        if odd:
            what = f'{" and ".join(odd)} of "{name}" cannot be blended'
            raise _error(where, what, "give them separate parameters")
        added[name] = _with_motion(added.get(name, {}), motion, share, f"{where} ({name})")
    return added


def _with_motion(
    motion: dict[str, Any], other: dict[str, Any], share: float, where: str
) -> dict[str, Any]:
    found = dict(motion)
    if "translation" in other:
        begun = np.asarray(motion.get("translation", (0.0, 0.0, 0.0)), float)
        found["translation"] = (begun + share * np.asarray(other["translation"], float)).tolist()
    if "rotation" in other:
        found["rotation"] = _with_turn(motion.get("rotation"), other["rotation"], share)
    if "pivot" in other:
        if "pivot" in motion and motion["pivot"] != other["pivot"]:
            raise _error(where, "the poses turn about different pivots", "give them one pivot")
        found["pivot"] = other["pivot"]
    return found


def _with_turn(turn: dict[str, Any] | None, other: dict[str, Any], share: float) -> dict[str, Any]:
    if turn is None:
        return {"axis": other["axis"], "degrees": share * other["degrees"]}
    total = _log(turn) + share * _log(other)
    length = float(np.linalg.norm(total))
    if length == 0.0:
        return {"axis": turn["axis"], "degrees": 0.0}
    return {"axis": (total / length).tolist(), "degrees": length}


def _log(turn: dict[str, Any]) -> Floats:
    """Return the unit axis times the angle, degrees."""
    axis = np.asarray(turn["axis"], float)
    length = math.sqrt(float(axis @ axis))
    found: Floats = axis / length * turn["degrees"] if length else axis
    return found


def _error(where: str, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(where, what, todo)])
