# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat strip that the tests of steel roll up."""

from __future__ import annotations

import numpy as np

LENGTH, WIDTH = 100.0, 25.0  # mm


def flat_strip(along: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """A grid of so many cells of two triangles: (n, 3) mm, (m, 3)."""
    x, y = np.meshgrid(np.linspace(0, LENGTH, along + 1), np.linspace(0, WIDTH, across + 1))
    points = np.column_stack([x.T.ravel(), y.T.ravel(), np.zeros(x.size)])
    a = (np.arange(along)[:, None] * (across + 1) + np.arange(across)).ravel()
    b, c, d = a + across + 1, a + across + 2, a + 1
    return points, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
