# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet of 1,000,000 nodes in every format of decks: generated, copied, morphed, certified.

    python3 tests/decks/million.py FORMAT FOLDER [SIDE]

prints a line of JSON: MB of the file, and by step wall seconds, seconds of the processor, and the
peak memory of its process in MB. SIDE: nodes along an edge, 1000.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

PITCH, HEIGHT = 2.0, 60.0
STEPS = ("copy", "morph", "certify")


def nodes(side: int) -> Iterator[tuple[int, float, float]]:
    """(id, x, y) in rows."""
    for k in range(side * side):
        yield k + 1, PITCH * (k % side), PITCH * (k // side)


def quads(side: int) -> Iterator[tuple[int, int, int, int, int]]:
    """(id, four nodes)."""
    for row in range(side - 1):
        for column in range(side - 1):
            a = row * side + column + 1
            yield row * (side - 1) + column + 1, a, a + 1, a + side + 1, a + side


def nastran(side: int) -> Iterator[str]:
    yield "BEGIN BULK\nPSHELL  7       1       1.2\n"
    yield "MAT1    1       210000.         .3      7.85-9\n"
    for k, x, y in nodes(side):
        yield f"GRID    {k:8d}        {x:8.2f}{y:8.2f}{0.0:8.2f}\n"
    for k, *ring in quads(side):
        yield f"CQUAD4  {k:8d}{7:8d}{''.join(f'{n:8d}' for n in ring)}\n"
    yield "ENDDATA\n"


def dyna(side: int) -> Iterator[str]:
    yield "*KEYWORD\n*PART\nsheet\n         7         1         1\n*SECTION_SHELL\n"
    yield "         1         2\n       1.2       1.2       1.2       1.2\n*NODE\n"
    for k, x, y in nodes(side):
        yield f"{k:8d}{x:16.4f}{y:16.4f}{0.0:16.4f}\n"
    yield "*ELEMENT_SHELL\n"
    for k, *ring in quads(side):
        yield f"{k:8d}{7:8d}{''.join(f'{n:8d}' for n in ring)}\n"
    yield "*END\n"


def abaqus(side: int) -> Iterator[str]:
    yield "*NODE, NSET=ALL\n"
    for k, x, y in nodes(side):
        yield f"{k:8d}, {x:12.4f}, {y:12.4f}, {0.0:8.4f}\n"
    yield "*ELEMENT, TYPE=S4, ELSET=SKIN\n"
    for k, *ring in quads(side):
        yield f"{k}, {', '.join(map(str, ring))}\n"
    yield "*SHELL SECTION, ELSET=SKIN, MATERIAL=STEEL\n1.2\n"


def radioss(side: int) -> Iterator[str]:
    yield "#RADIOSS STARTER\n/BEGIN\nsheet\n      2022         0\n/NODE\n"
    for k, x, y in nodes(side):
        yield f"{k:10d}{x:20.6f}{y:20.6f}{0.0:20.6f}\n"
    yield "/SHELL/7\n"
    for k, *ring in quads(side):
        yield f"{k:10d}{''.join(f'{n:10d}' for n in ring)}\n"
    yield "/PART/7\nsheet\n         1         1\n/END\n"


def gmsh(side: int) -> Iterator[str]:
    yield f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{side * side}\n"
    for k, x, y in nodes(side):
        yield f"{k} {x:.8f} {y:.8f} {0.0:.8f}\n"
    yield f"$EndNodes\n$Elements\n{(side - 1) ** 2}\n"
    for k, *ring in quads(side):
        yield f"{k} 3 2 7 7 {' '.join(map(str, ring))}\n"
    yield "$EndElements\n"


FORMATS: dict[str, tuple[str, Callable[[int], Iterator[str]]]] = {
    "nastran": ("sheet.bdf", nastran),
    "ls-dyna": ("sheet.k", dyna),
    "abaqus": ("sheet.inp", abaqus),
    "radioss": ("sheet_0000.rad", radioss),
    "gmsh": ("sheet.msh", gmsh),
}


def generate(form: str, folder: Path, side: int) -> tuple[Path, Path]:
    """The deck, and a recipe that holds its one edge and lifts the other."""
    name, text = FORMATS[form]
    with (folder / name).open("w", encoding="ascii") as out:
        out.writelines(text(side))
    ends = ([1 + k * side for k in range(side)], [side + k * side for k in range(side)])
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "sheet", "file": name}],
        "fixed": [{"part": "sheet", "vertices": ends[0]}],
        "handles": [{"name": "end", "part": "sheet", "vertices": ends[1]}],
        "pose": {"end": {"translation": [0, 0, HEIGHT]}},
    }
    (folder / "recipe.json").write_text(json.dumps(recipe))
    return folder / name, folder / "recipe.json"


def measured(arguments: list[str]) -> dict[str, float]:
    """What a command of the package takes in a process of its own, and its exit status."""
    begin = time.monotonic()
    child = os.spawnv(os.P_NOWAIT, sys.executable, [sys.executable, "-m", "sheetmorph", *arguments])
    _, status, used = os.wait4(child, 0)
    return {
        "status": os.waitstatus_to_exitcode(status),
        "wall": round(time.monotonic() - begin, 1),
        "processor": round(used.ru_utime + used.ru_stime, 1),
        "peak": round(used.ru_maxrss * 1.024e-3),
    }


def measure(form: str, folder: Path, side: int, steps: tuple[str, ...] = STEPS) -> dict:
    """Generate a deck and take the steps."""
    deck, recipe = generate(form, folder, side)
    out = str(folder / "out")
    commands = {
        "copy": ["copy", str(deck), "-o", str(folder / "same")],
        "morph": ["run", str(recipe), "-o", out, "--quiet"],
        "certify": ["certify", str(recipe), out, "--page", str(folder / "page.html")],
    }
    found = {"format": form, "nodes": side * side, "file": round(deck.stat().st_size / 1e6, 1)}
    for step in steps:
        found[step] = measured(commands[step])
    same = (folder / "same" / deck.name).read_bytes() == deck.read_bytes()
    return {**found, "same": same}


if __name__ == "__main__":
    _side = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    _steps = tuple(sys.argv[4].split(",")) if len(sys.argv) > 4 else STEPS
    print(json.dumps(measure(sys.argv[1], Path(sys.argv[2]), _side, _steps)), flush=True)
