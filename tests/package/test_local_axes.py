# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axes of a handle; needs no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools.local_axes import GLOBAL, local_axes, to_global, to_local

# a strip of 40 mm x 10 mm, whose facets face up
STRIP = np.array([[x, y, 0.0] for x in range(0, 50, 10) for y in (0, 10)], float)
FACETS = np.array(
    [f for k in range(0, 8, 2) for f in ((k, k + 2, k + 3), (k, k + 3, k + 1))], np.int32
)


def rotation(degrees: float) -> np.ndarray:
    """A rotation about (1, 2, 2) / 3."""
    x, y, z = np.array([1.0, 2.0, 2.0]) / 3.0
    cross, turn = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.radians(degrees)
    return np.eye(3) + np.sin(turn) * cross + (1 - np.cos(turn)) * (cross @ cross)


@pytest.mark.parametrize("degrees", [0.0, 35.0])
def test_z_is_the_normal_and_x_the_longest_direction(degrees):
    turn = rotation(degrees)
    axes = local_axes(STRIP @ turn.T, FACETS, np.arange(len(STRIP)))
    assert np.allclose(axes, turn, atol=1e-12)


def test_axes_of_a_single_vertex_are_a_rotation_along_the_normal():
    turn = rotation(70.0)
    axes = local_axes(STRIP @ turn.T, FACETS, np.array([4]))
    assert np.allclose(axes.T @ axes, np.eye(3)) and np.isclose(np.linalg.det(axes), 1.0)
    assert np.allclose(axes[:, 2], turn[:, 2])


def test_a_vertex_without_facets_has_global_axes():
    points = np.vstack([STRIP, [[99.0, 0.0, 0.0]]])
    assert np.array_equal(local_axes(points, FACETS, np.array([10])), np.eye(3))


def test_global_axes_change_no_bit_and_others_leave_no_noise():
    vector = (0.1, 1 / 3, -2e-17)
    assert to_global(GLOBAL, vector) == vector and to_local(GLOBAL, vector) == vector
    axes = rotation(35.0)
    there = to_global(axes, (0.0, 0.0, 5.0))
    assert np.allclose(there, 5.0 * axes[:, 2], atol=1e-11)
    assert to_local(axes, there) == (0.0, 0.0, 5.0)
