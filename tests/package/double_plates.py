# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two plates above each other as cards of Nastran."""

from __future__ import annotations

ACROSS, ALONG = 5, 13
STEP = 10.0


def node(i: int, j: int, layer: int = 0) -> int:
    """The id of a node of the plate, i along and j across."""
    return 1 + layer * 1000 + i * ACROSS + j


def grid(number: int, x: float, y: float, z: float) -> str:
    return f"GRID,{number},,{x!r},{y!r},{z!r}"


def two_plates() -> list[str]:
    """Two plates of 120 x 40 mm, 2 mm apart, as cards."""
    cards = ["PSHELL,1,1,1.0", "PSHELL,2,1,1.0"]
    element = 0
    for layer in (0, 1):
        for i in range(ALONG):
            for j in range(ACROSS):
                cards.append(grid(node(i, j, layer), i * STEP, j * STEP, 2.0 * layer))
        for i in range(ALONG - 1):
            for j in range(ACROSS - 1):
                element += 1
                corners = [node(i, j, layer), node(i + 1, j, layer)]
                corners += [node(i + 1, j + 1, layer), node(i, j + 1, layer)]
                cards.append(f"CQUAD4,{element},{layer + 1}," + ",".join(map(str, corners)))
    return cards
