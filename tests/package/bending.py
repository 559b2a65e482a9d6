# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet bent along an arc and twisted about its length: the motion of its far end."""

from __future__ import annotations

from typing import Any

import numpy as np


def turned(axis: int, degrees: float) -> np.ndarray:
    """The rotation (3, 3) about a coordinate axis."""
    one, other = (axis + 1) % 3, (axis + 2) % 3
    angle = np.radians(degrees)
    matrix = np.eye(3)
    matrix[[one, other], [one, other]] = np.cos(angle)
    matrix[other, one], matrix[one, other] = np.sin(angle), -np.sin(angle)
    return matrix


def bent_and_twisted(length: float, bend: float, twist: float) -> dict[str, Any]:
    """The pose of the far end of a sheet in the xy plane, `length` mm away in y; degrees.

    The end goes where an arc of the same length ends, and turns about the sheet's own length.
    """
    matrix = turned(0, bend) @ turned(1, twist)
    angle = np.arccos(np.clip(0.5 * (np.trace(matrix) - 1.0), -1.0, 1.0))
    skew = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], 0.0])
    skew[2] = matrix[1, 0] - matrix[0, 1]
    shift = np.zeros(3)
    if bend:
        radius = length / np.radians(bend)
        shift = radius * np.array([0.0, np.sin(np.radians(bend)), 1.0 - np.cos(np.radians(bend))])
        shift[1] -= length
    rotation = {"axis": skew.tolist(), "degrees": float(np.degrees(angle))}
    return {"translation": shift.tolist(), "rotation": rotation}
