# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thin solids made in code: a plate with round holes, two skins and the walls between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from plates import plate


@dataclass
class ThinPlate:
    """points (n, 3) mm, triangles (m, 3); ids of its ends and of the upper rims of its holes.

    Vertex i < count lies on the upper skin, count + i under it on the lower one.
    """

    points: np.ndarray
    triangles: np.ndarray
    left: list[int]
    right: list[int]
    rims: list[list[int]]
    count: int


def thin_plate(holes: int = 3, cells: int = 6, thickness: float = 1.0) -> ThinPlate:
    """plate() as a closed solid of some thickness, mm."""
    sheet = plate(holes, cells)
    count = len(sheet.points)
    points = np.concatenate([sheet.points, sheet.points - [0.0, 0.0, thickness]])
    # An edge that one triangle alone uses is on the border; the wall below turns it round.
    edges = np.concatenate([sheet.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    used = {tuple(edge) for edge in edges.tolist()}
    border = np.array([edge for edge in edges.tolist() if (edge[1], edge[0]) not in used])
    a, b = border[:, 0], border[:, 1]
    walls = [np.stack([b, a, a + count], axis=1), np.stack([b, a + count, b + count], axis=1)]
    triangles = np.concatenate([sheet.triangles, sheet.triangles[:, ::-1] + count, *walls])
    ends = [[*side, *(np.array(side) + count).tolist()] for side in (sheet.left, sheet.right)]
    return ThinPlate(points, triangles.astype(np.int32), *ends, sheet.rims, count)
