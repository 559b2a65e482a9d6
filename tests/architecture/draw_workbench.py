# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the rooms of the workbench from their imports: draw_workbench.py [PICTURE.svg]

A room stands above all that it imports; an arrow that follows from two others is left out.
"""
import sys
from pathlib import Path

from imports import Graph, folder_graph, import_graph, reached
from source_tree import ROOT, WORKBENCH

PICTURE = ROOT / "resources" / "docs" / "pictures" / "workbench.svg"
LEFT_OUT = ("tests", "init", "init_gui", "showcase_main", "paths", "kinds", "preferences")
WIDTH, HEIGHT, STEP_X, STEP_Y = 124, 30, 142, 64


def rooms() -> Graph:
    """What each room imports of the others, without what starts them and what all of them use."""
    graph = import_graph(WORKBENCH, "freecad.sheetmorph")
    graph = {name: found for name, found in graph.items() if name.split(".")[0] not in LEFT_OUT}
    return folder_graph(graph)


def level(graph: Graph, room: str) -> int:
    """How many rooms stand below a room, one on the other."""
    return max((1 + level(graph, other) for other in graph[room]), default=0)


def direct(graph: Graph, room: str) -> list[str]:
    """What a room imports that it would not reach by way of others."""
    others = graph[room]
    return sorted(o for o in others if not any(o in reached(graph, p) for p in others - {o}))


def places(graph: Graph) -> dict[str, tuple[int, int]]:
    """The middle of every room's box: the highest level at the top, in the order of the names."""
    levels: dict[int, list[str]] = {}
    for room in sorted(graph):
        levels.setdefault(level(graph, room), []).append(room)
    widest = max(map(len, levels.values()))
    return {
        room: (
            round(STEP_X * (k + 0.5 + (widest - len(row)) / 2)),
            round(STEP_Y * (max(levels) - number + 0.5)),
        )
        for number, row in levels.items()
        for k, room in enumerate(row)
    }


def svg(graph: Graph) -> str:
    """The picture."""
    at = places(graph)
    size = tuple(
        max(place[axis] for place in at.values()) + gap for axis, gap in ((0, 71), (1, 32))
    )
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]} {size[1]}">',
        "<!-- SPDX-License-Identifier: LGPL-2.1-or-later; made by draw_workbench.py -->",
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
        'markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z" fill="#5b6b7b"/></marker></defs>',
        '<rect width="100%" height="100%" fill="#ffffff"/>',
    ]
    for room in sorted(graph):
        for other in direct(graph, room):
            (x, y), (to_x, to_y) = at[room], at[other]
            lines.append(
                f'<path d="M{x} {y + HEIGHT // 2}L{to_x} {to_y - HEIGHT // 2}" stroke="#5b6b7b" '
                'fill="none" marker-end="url(#tip)"/>'
            )
    for room, (x, y) in sorted(at.items()):
        lines.append(
            f'<rect x="{x - WIDTH // 2}" y="{y - HEIGHT // 2}" width="{WIDTH}" height="{HEIGHT}" '
            'rx="5" fill="#e8eef5" stroke="#31557a"/>'
            f'<text x="{x}" y="{y + 5}" font-family="sans-serif" font-size="14" '
            f'text-anchor="middle" fill="#10222f">{room}</text>'
        )
    return "\n".join([*lines, "</svg>"]) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1] if len(sys.argv) > 1 else PICTURE).write_text(svg(rooms()), encoding="utf-8")
