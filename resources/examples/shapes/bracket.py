# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bracket with a bolt's hole in its foot and a larger one high in its back, as a deck of
CalculiX that asks for frequencies.

Its sheet is made of quads with eight nodes, at rest or at once with the hole where a morph is to
bring it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

WIDTH, WEB, BOLT, HOLE, THICKNESS = 40.0, 30.0, 5.0, 9.0, 2.0  # mm
SHIFT = (3.6, 2.4)  # mm, up and to the side
CARDS = f"""*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*DENSITY
7.85E-9
*SHELL SECTION, ELSET=SHEET, MATERIAL=STEEL
{THICKNESS}
*BOUNDARY
BOLTED, 1, 6
*STEP
*FREQUENCY
6
*END STEP
"""


def folded(points: np.ndarray) -> np.ndarray:
    """(n, 3) places of the blank's points (n, 2), x along it: the foot lies, the rest stands."""
    x, y = points.T
    return np.column_stack([np.minimum(x, WIDTH), y, np.maximum(x - WIDTH, 0.0)])


def deck(across: int, along: int, shift: Sequence[float] = (0.0, 0.0)) -> str:
    """The bracket with so many quads across and along its web, its hole out of the middle."""
    foot = _holed(across, 0.0, BOLT, (0.0, 0.0))
    blocks = [foot, _web(across, along), _holed(across, WIDTH + WEB, HOLE, shift)]
    number: dict[tuple[float, float], int] = {}
    rows = [[_node(number, place) for place in block.reshape(-1, 2)] for block in blocks]
    grids = [np.reshape(row, block.shape[:2]) for row, block in zip(rows, blocks)]
    nodes = folded(np.array(list(number)))
    lines = ["** A bracket, mm, t, s", "*NODE, NSET=ALL"]
    lines += [f"{k + 1}, {x:.9f}, {y:.9f}, {z:.9f}" for k, (x, y, z) in enumerate(nodes.tolist())]
    lines.append("*ELEMENT, TYPE=S8R, ELSET=SHEET")
    quads = [quad for grid in grids for quad in _quads(grid)]
    lines += [f"{k + 1}, {', '.join(map(str, quad))}" for k, quad in enumerate(quads)]
    lines.append("*NSET, NSET=BOLTED")
    lines += [f"{node}," for node in grids[0][0, :-1].tolist()]
    return "\n".join([*lines, CARDS])


def recipe() -> dict:
    """The hole is moved in its plane; foot, web and outline are held."""
    half, top, off = 0.5 * WIDTH, WEB + WIDTH, 1e-3
    held = [
        [[-1.0, -half - 1.0, -1.0], [WIDTH + 1.0, half + 1.0, WEB + off]],
        [[WIDTH - 1.0, -half - 1.0, top - off], [WIDTH + 1.0, half + 1.0, top + 1.0]],
        [[WIDTH - 1.0, -half - 1.0, WEB], [WIDTH + 1.0, -half + off, top]],
        [[WIDTH - 1.0, half - off, WEB], [WIDTH + 1.0, half + 1.0, top]],
    ]
    middle = [WIDTH, 0.0, WEB + half]
    return {
        "sheetmorph": 1,
        "parts": [{"name": "bracket", "file": "bracket.inp"}],
        "fixed": [{"name": "rest", "part": "bracket", "where": [{"box": box} for box in held]}],
        "handles": [{"name": "hole", "part": "bracket", "where": {"rim_at": middle}}],
        "pose": {"hole": {"translation": [0.0, SHIFT[1], SHIFT[0]]}},
    }


def _node(number: dict[tuple[float, float], int], place: np.ndarray) -> int:
    x, y = (round(float(one), 9) + 0.0 for one in place)
    return number.setdefault((x, y), len(number) + 1)


def _quads(grid: np.ndarray) -> list[list[int]]:
    """The nodes of quads on a grid of corners and, between them, nodes at the middles of sides."""
    steps = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    return [
        [int(grid[i + a, j + b]) for a, b in steps]
        for i in range(0, grid.shape[0] - 1, 2)
        for j in range(0, grid.shape[1] - 1, 2)
    ]


def _web(across: int, along: int) -> np.ndarray:
    x = WIDTH + WEB * np.linspace(0.0, 1.0, 2 * along + 1)
    y = WIDTH * np.linspace(-0.5, 0.5, 2 * across + 1)
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)


def _holed(across: int, start: float, radius: float, shift: Sequence[float]) -> np.ndarray:
    """A square with a hole, from the rim to the outline, all around."""
    side = np.linspace(-0.5, 0.5, 2 * across + 1)[:-1]
    half = np.full_like(side, 0.5)
    border = [(side, -half), (half, side), (-side, half), (-half, -side)]
    outer = WIDTH * np.concatenate([np.column_stack(one) for one in border])
    outer = np.concatenate([outer, outer[:1]])
    spokes = outer - shift
    inner = shift + radius * spokes / np.linalg.norm(spokes, axis=1)[:, None]
    share = np.linspace(0.0, 1.0, across + across % 2 + 1)[:, None, None]
    return (1.0 - share) * inner + share * outer + [start + 0.5 * WIDTH, 0.0]
