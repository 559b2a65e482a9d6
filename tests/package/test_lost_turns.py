# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole turns are followed over the triangles of any answer; those that are lost are reported."""
import numpy as np
import pytest

from sheetmorph.reporting.lost_turns import FollowedTurns, quaternions


def helicoid(turns: float, along: int, across: int = 3) -> tuple[np.ndarray, ...]:
    """Points at rest, triangles and positions of a strip of 300 x 10 twisted evenly about x."""
    x, y = np.meshgrid(np.linspace(0, 300, along), np.linspace(-5, 5, across), indexing="ij")
    cells = np.array([across * i + j for i in range(along - 1) for j in range(across - 1)])
    triangles = np.concatenate(
        [cells[:, None] + [0, across, across + 1], cells[:, None] + [0, across + 1, 1]]
    )
    angle = 2 * np.pi * turns * x.ravel() / 300
    points = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    moved = np.stack([x.ravel(), y.ravel() * np.cos(angle), y.ravel() * np.sin(angle)], axis=1)
    return points, triangles, moved


def missed(turns: float, told: float, along: int = 121) -> float:
    points, triangles, moved = helicoid(turns, along)
    # The triangles of a part may be oriented anyhow.
    triangles[::3] = triangles[::3, ::-1]
    followed = FollowedTurns(points, triangles, moved)
    ends = np.arange(len(points) - 3, len(points))
    axis = np.array([1.0, 0.0, 0.0])
    miss = followed.least_miss([(np.arange(3), 0.0)], ends, axis, 2 * np.pi * told)
    assert miss is not None
    return miss


@pytest.mark.parametrize("turns", [0.0, 0.3, -0.5, 1.0, 1.25, -2.0, 3.0])
def test_an_answer_that_turns_as_it_should_misses_nothing(turns: float) -> None:
    assert missed(turns, turns) < 0.2


@pytest.mark.parametrize("told", [1.0, -1.0, 2.0])
def test_whole_turns_that_the_answer_has_not_are_missed(told: float) -> None:
    for turns in (0.0, 0.25):
        assert missed(turns, turns + told) == pytest.approx(2 * np.pi * abs(told), abs=0.2)


def test_a_strip_of_few_triangles_cannot_tell_two_turns() -> None:
    assert missed(2.0, 2.0, along=4) > np.pi


def test_quaternions_are_those_of_their_rotations() -> None:
    generator = np.random.default_rng(7)
    for angle in (0.0, 1e-9, 0.3, 2.0, 3.1, np.pi - 1e-7, np.pi):
        axes = generator.normal(size=(40, 3))
        axes /= np.linalg.norm(axes, axis=1)[:, None]
        found = quaternions(np.array([rotation(angle * axis) for axis in axes]))
        expected = np.column_stack([np.full(40, np.cos(angle / 2)), np.sin(angle / 2) * axes])
        found *= np.sign(np.einsum("ti,ti->t", found, expected))[:, None]
        assert found == pytest.approx(expected, abs=1e-8)


def rotation(vector: np.ndarray) -> np.ndarray:
    angle = float(np.linalg.norm(vector))
    x, y, z = vector / angle if angle > 0.0 else vector
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
