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
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

PITCH, HEIGHT = 2.0, 60.0
STEPS = ("copy", "morph", "certify")


@dataclass(frozen=True)
class Form:
    """How a format writes the sheet: its file; what stands before the nodes, between nodes and
    quads, and behind them; a node (k, x, y), and a quad (k, and its nodes a, b, c, d)."""

    file: str
    head: str
    node: str
    middle: str
    quad: str
    tail: str

    def lines(self, side: int) -> Iterator[str]:
        """The deck of side * side nodes, in rows."""
        counts = {"nodes": side * side, "quads": (side - 1) ** 2}
        node, quad = self.node.format, self.quad.format
        yield self.head.format(**counts)
        for k in range(side * side):
            yield node(k=k + 1, x=PITCH * (k % side), y=PITCH * (k // side))
        yield self.middle.format(**counts)
        for k in range((side - 1) ** 2):
            a = k // (side - 1) * side + k % (side - 1) + 1
            yield quad(k=k + 1, a=a, b=a + 1, c=a + side + 1, d=a + side)
        yield self.tail


FORMATS = {
    "nastran": Form(
        "sheet.bdf",
        "BEGIN BULK\nPSHELL  7       1       1.2\nMAT1    1       210000.         .3      7.85-9\n",
        "GRID    {k:8d}        {x:8.2f}{y:8.2f}    0.00\n",
        "",
        "CQUAD4  {k:8d}       7{a:8d}{b:8d}{c:8d}{d:8d}\n",
        "ENDDATA\n",
    ),
    "ls-dyna": Form(
        "sheet.k",
        "*KEYWORD\n*PART\nsheet\n         7         1         1\n*SECTION_SHELL\n"
        "         1         2\n       1.2       1.2       1.2       1.2\n*NODE\n",
        "{k:8d}{x:16.4f}{y:16.4f}          0.0000\n",
        "*ELEMENT_SHELL\n",
        "{k:8d}       7{a:8d}{b:8d}{c:8d}{d:8d}\n",
        "*END\n",
    ),
    "abaqus": Form(
        "sheet.inp",
        "*NODE, NSET=ALL\n",
        "{k:8d}, {x:12.4f}, {y:12.4f},   0.0000\n",
        "*ELEMENT, TYPE=S4, ELSET=SKIN\n",
        "{k}, {a}, {b}, {c}, {d}\n",
        "*SHELL SECTION, ELSET=SKIN, MATERIAL=STEEL\n1.2\n",
    ),
    "radioss": Form(
        "sheet_0000.rad",
        "#RADIOSS STARTER\n/BEGIN\nsheet\n      2022         0\n/NODE\n",
        "{k:10d}{x:20.6f}{y:20.6f}            0.000000\n",
        "/SHELL/7\n",
        "{k:10d}{a:10d}{b:10d}{c:10d}{d:10d}\n",
        "/PART/7\nsheet\n         1         1\n/END\n",
    ),
    "gmsh": Form(
        "sheet.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{nodes}\n",
        "{k} {x:.8f} {y:.8f} 0.00000000\n",
        "$EndNodes\n$Elements\n{quads}\n",
        "{k} 3 2 7 7 {a} {b} {c} {d}\n",
        "$EndElements\n",
    ),
}


def generate(form: str, folder: Path, side: int) -> tuple[Path, Path]:
    """The deck, and a recipe that holds its one edge and lifts the other."""
    name = FORMATS[form].file
    with (folder / name).open("w", encoding="ascii") as out:
        out.writelines(FORMATS[form].lines(side))
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
