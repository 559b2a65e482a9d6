# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drags that snap to points and steps."""

from __future__ import annotations

import numpy as np

ACROSS = 0.02  # of a shift: a smaller component is rounding, not a direction of the drag


def along_drag(shift, wanted, axes: np.ndarray) -> np.ndarray:
    """Return the components of `wanted` (3,) along those axes on which a drag has moved.

    The columns of `axes` (3, 3) are the directions of the arrows, and `shift` (3,) is the drag.
    """
    local = np.abs(axes.T @ np.asarray(shift, float))
    is_free = local > ACROSS * np.linalg.norm(local)
    return axes @ np.where(is_free, axes.T @ np.asarray(wanted, float), 0.0)


def stepped(shift, step: float, axes: np.ndarray) -> np.ndarray:
    """Return a shift (3,) rounded to multiples of a step, mm, along the axes (3, 3)."""
    return axes @ (step * np.round(axes.T @ np.asarray(shift, float) / step))
