# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses: motions by region name, stored as text and interpolated number by number."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace

import numpy as np

from freecad.sheetmorph.tools.motion import CENTROID, Motion

Pose = dict[str, Motion]


@dataclass(frozen=True)
class Snapshot:
    """The motions and sizes (mm) of a pose by region name."""

    motions: Pose
    sizes: dict[str, float]


def to_text(pose: Pose) -> str:
    """Return the pose as JSON, from which every number is read back exactly."""
    return json.dumps({name: motion.arguments() for name, motion in sorted(pose.items())})


def from_text(text: str) -> Pose:
    """Return the pose from the text of `to_text`."""
    entries = json.loads(text or "{}")
    return {name: _motion(entry) for name, entry in entries.items()}


def blended(first: Pose, second: Pose, weight: float) -> Pose:
    """Return the pose between two that name the same regions: the first at weight 0.

    Translations and pivots are interpolated linearly. Rotations are interpolated as axis times
    angle, so that whole turns count.
    """
    return {name: between(first[name], second[name], weight) for name in first}


def between(first: Motion, second: Motion, weight: float) -> Motion:
    """Return the motion between two; the pivot is the centroid if it is that of either motion."""
    if weight in (0.0, 1.0):
        return second if weight else first
    ends = [np.asarray(m.axis, float) / np.linalg.norm(m.axis) * m.angle for m in (first, second)]
    turn = _mixed(*ends, weight)
    angle = float(np.linalg.norm(turn))
    axis = tuple((turn / angle).tolist()) if angle else first.axis
    along = np.dot(axis, first.axis if first.angle else second.axis)
    if angle and along < 0.0:  # the same rotation about the axis that the user gave
        axis, angle = tuple(-c for c in axis), -angle
    is_free = None in (first.pivot, second.pivot)
    return replace(
        first,
        translation=tuple(_mixed(first.translation, second.translation, weight).tolist()),
        axis=axis,
        angle=angle,
        pivot=None if is_free else tuple(_mixed(first.pivot, second.pivot, weight).tolist()),
    )


def share_of(pose: Pose, share: float) -> Pose:
    """Return the pose on the way from rest (0) to a pose (1); axes, pivots and sizes stay.

    Entries of imported recipes without an object stay too.
    """
    return {name: _share(motion, share) for name, motion in pose.items()}


def _share(motion: Motion, share: float) -> Motion:
    if not isinstance(motion, Motion):
        return motion
    shift = motion.translation
    part = None if shift is None else tuple((share * np.asarray(shift, float)).tolist())
    return replace(motion, translation=part, angle=share * motion.angle)


def _mixed(a, b, weight: float) -> np.ndarray:
    return (1.0 - weight) * np.asarray(a, float) + weight * np.asarray(b, float)


def _motion(entry: dict) -> Motion:
    pivot = entry["pivot"]
    return Motion(
        tuple(entry["translation"]),
        tuple(entry["axis"]),
        entry["angle"],
        None if pivot == CENTROID else tuple(pivot),
    )
