# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every answer follows rigid motion, scale, mirror, numbering and winding of its sheet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import sheetmorph

ALLOWED = 1e-10
"""Of the size: how far two answers to the same question may differ."""


@dataclass
class Sheets:
    """Two curved sheets above each other, how the lower one is held and moved, and their scale."""

    points: list[np.ndarray]
    triangles: list[np.ndarray]
    numbers: list[np.ndarray]  # now, by number at first
    motion: np.ndarray  # (4, 4) of the handle
    scale: float = 1.0


def _sheets() -> Sheets:
    random = np.random.default_rng(29)
    along, across = 9, 6
    x, y = np.meshgrid(np.linspace(0, 100, along), np.linspace(0, 40, across), indexing="ij")
    inner = (x > 0) & (x < 100) & (y > 0) & (y < 40)
    x = x + inner * random.uniform(-3, 3, x.shape)
    y = y + inner * random.uniform(-2, 2, y.shape)
    z = 0.004 * (x - 30) ** 2 + 0.02 * (y - 10) ** 2
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    corner = (np.arange(along - 1)[:, None] * across + np.arange(across - 1)).ravel()
    first = np.column_stack([corner, corner + across, corner + across + 1])
    other = np.column_stack([corner, corner + across + 1, corner + 1])
    motion = np.eye(4)
    motion[:3, :3] = _rotation([0.2, 1.0, 0.3], 0.4)
    pivot = points[-across:].mean(axis=0)
    motion[:3, 3] = pivot + [-6.0, 3.0, 14.0] - motion[:3, :3] @ pivot
    triangles = np.vstack([first, other])
    count = np.arange(len(points))
    above = points + [3.0, 2.0, 4.0]
    return Sheets([points, above], [triangles, triangles], [count, count], motion)


def _rotation(axis: Any, angle: float) -> np.ndarray:
    u = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def _mapped(sheets: Sheets, matrix: np.ndarray, shift: Any = 0.0) -> Sheets:
    """Under x -> matrix x + shift, a similarity; a mirror turns the triangles too."""
    scale = np.cbrt(abs(np.linalg.det(matrix)))
    whole = np.eye(4)
    whole[:3, :3], whole[:3, 3] = matrix, shift
    order = [0, 1, 2] if np.linalg.det(matrix) > 0 else [0, 2, 1]
    return Sheets(
        [points @ matrix.T + shift for points in sheets.points],
        [triangles[:, order] for triangles in sheets.triangles],
        sheets.numbers,
        whole @ sheets.motion @ np.linalg.inv(whole),
        scale,
    )


def _renumbered(sheets: Sheets) -> Sheets:
    random = np.random.default_rng(30)
    points, triangles, numbers = [], [], []
    for own, corners in zip(sheets.points, sheets.triangles):
        order = random.permutation(len(own))
        now = np.argsort(order)
        points.append(own[order])
        turned = np.array([np.roll(row, random.integers(3)) for row in now[corners]])
        triangles.append(turned[random.permutation(len(turned))])
        numbers.append(now)
    return Sheets(points, triangles, numbers, sheets.motion)


def _turned_over(sheets: Sheets) -> Sheets:
    backwards = [triangles[:, ::-1] for triangles in sheets.triangles]
    return Sheets(sheets.points, backwards, sheets.numbers, sheets.motion)


SAME: dict[str, Callable[[Sheets], Sheets]] = {
    "turned about z": lambda sheets: _mapped(sheets, _rotation([0, 0, 1], 0.6)),
    "moved": lambda sheets: _mapped(sheets, _rotation([1, 2, 3], 1.0), [500.0, 200.0, -300.0]),
    "larger": lambda sheets: _mapped(sheets, 1e3 * np.eye(3)),
    "smaller": lambda sheets: _mapped(sheets, 1e-3 * np.eye(3)),
    "mirrored": lambda sheets: _mapped(sheets, np.diag([1.0, -1.0, 1.0])),
    "renumbered": _renumbered,
    "turned over": _turned_over,
}


def _pose(motion: np.ndarray) -> dict[str, Any]:
    """A motion by a rotation about the origin and a translation."""
    turn = motion[:3, :3]
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    degrees = np.degrees(np.arctan2(np.linalg.norm(axis), np.trace(turn) - 1.0))
    return {
        "pivot": [0.0, 0.0, 0.0],
        "translation": motion[:3, 3].tolist(),
        "rotation": {"axis": axis.tolist(), "degrees": float(degrees)},
    }


def _answer(sheets: Sheets, kind: dict[str, Any], parts: int) -> tuple[list[np.ndarray], Any]:
    """Positions as numbered at first, and the energy to spring back over the cube of the scale."""
    names = ["lower", "upper"][:parts]
    numbers = sheets.numbers[0]
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": name} for name in names],
        "fixed": [{"part": "lower", "vertices": numbers[:6].tolist()}],
        "handles": [{"name": "tip", "part": "lower", "vertices": numbers[-6:].tolist()}],
        "primary": "lower",
        "pose": {"tip": _pose(sheets.motion)},
        **kind,
    }
    if parts == 2:
        places = np.arange(18, 24)
        recipe["contacts"] = [
            {
                "name": "joint",
                "type": "tied",
                "a": {"part": "lower", "vertices": sheets.numbers[0][places].tolist()},
                "b": {"part": "upper", "vertices": sheets.numbers[1][places].tolist()},
            }
        ]
    meshes = {
        name: sheetmorph.PartMesh(points, triangles.astype(np.int32))
        for name, points, triangles in zip(names, sheets.points, sheets.triangles)
    }
    result = sheetmorph.Session(recipe, meshes).deform()
    assert not result.unsettled
    stretch = result.report()["parts"][0].get("stretch") or {}
    positions = [np.asarray(result.positions[name]) for name in names]
    energy = stretch.get("springs_back")
    return (
        [own[now] for own, now in zip(positions, sheets.numbers)],
        None if energy is None else energy / sheets.scale**3,
    )


KINDS: list[tuple[dict[str, Any], int]] = [
    *[({"energy": energy}, 1) for energy in ("neumann", "natural", "paper", "steel")],
    *[({"energy": energy, "refine": True}, 1) for energy in ("neumann", "natural", "paper")],
    *[
        ({"energy": "neumann", "propagation": {"type": extent}}, 2)
        for extent in ("single", "local", "whole")
    ],
]


@pytest.mark.parametrize(
    "kind, parts", KINDS, ids=[" ".join(map(str, kind.values())) for kind, _ in KINDS]
)
def test_an_answer_does_not_depend_on_axes_units_numbers_or_sides(
    kind: dict[str, Any], parts: int
) -> None:
    first = _sheets()
    wanted, energy = _answer(first, kind, parts)
    size = float(np.linalg.norm(np.ptp(first.points[0], axis=0)))
    moved = max(np.abs(now - rest).max() for now, rest in zip(wanted, first.points))
    assert moved > 0.05 * size
    for name, same in SAME.items():
        sheets = same(first)
        found, measured = _answer(sheets, kind, parts)
        # The similarity that takes the rest to the rest takes the answer to the answer.
        for k, shape in enumerate(found):
            rest, now = first.points[k], sheets.points[k][sheets.numbers[k]]
            centre, target = rest.mean(axis=0), now.mean(axis=0)
            matrix = np.linalg.lstsq(rest - centre, now - target, rcond=None)[0]
            off = np.abs((wanted[k] - centre) @ matrix + target - shape).max()
            assert off <= ALLOWED * size * sheets.scale, f"{name}: {off / size / sheets.scale:.1e}"
        if energy is not None:
            assert measured == pytest.approx(energy, rel=1e-7), name
