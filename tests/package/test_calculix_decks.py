# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX takes a morphed deck, and finds in it what it finds in the same shape made directly."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import run
from sheetmorph.decks import read_deck

ALONG, ACROSS = 13, 5
MODEL = """*MATERIAL,NAME=STEEL
*ELASTIC
210000.,0.3
*DENSITY
7.85E-9
*SHELL SECTION,ELSET=SKIN,MATERIAL=STEEL
1.5
*BOUNDARY
ENDS,1,6
*STEP
*FREQUENCY
5
*END STEP
"""


def deck(points: np.ndarray) -> str:
    """A strip of quads, its nodes anywhere, clamped at the one end."""
    lines = ["** a strip", "*NODE,NSET=ALL"]
    lines += [f"{k + 1},{x!r},{y!r},{z!r}" for k, (x, y, z) in enumerate(points.tolist())]
    lines.append("*ELEMENT,TYPE=S4,ELSET=SKIN")
    corner = [i * ACROSS + j for i in range(ALONG - 1) for j in range(ACROSS - 1)]
    lines += [
        f"{k + 1},{c + 1},{c + ACROSS + 1},{c + ACROSS + 2},{c + 2}" for k, c in enumerate(corner)
    ]
    lines += ["*NSET,NSET=ENDS,GENERATE", f"1,{2 * ACROSS},1", MODEL]
    return "\n".join(lines)


def flat() -> np.ndarray:
    i, j = np.meshgrid(np.arange(ALONG), np.arange(ACROSS), indexing="ij")
    return np.stack([10.0 * i.ravel(), 10.0 * j.ravel(), np.zeros(i.size)], axis=1)


def frequencies(path: Path) -> list[float]:
    """What CalculiX finds, Hz."""
    command = ["ccx", path.stem]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "*ERROR" not in done.stdout, done.stdout[-2000:]
    text = path.with_suffix(".dat").read_text()
    rows = re.findall(r"^\s+\d+\s+\S+\s+\S+\s+(\S+)\s+\S+\s*$", text, re.MULTILINE)
    return [float(value) for value in rows[:5]]


@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_a_morphed_deck_has_the_frequencies_of_its_shape(tmp_path: Path):
    (tmp_path / "strip.inp").write_text(deck(flat()))
    tip = [k + 1 for k in range((ALONG - 2) * ACROSS, ALONG * ACROSS)]
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "strip", "file": "strip.inp"}],
        "fixed": [{"part": "strip", "vertices": list(range(1, 2 * ACROSS + 1))}],
        "handles": [{"name": "tip", "part": "strip", "vertices": tip}],
        "pose": {"tip": {"translation": [0, 0, 25.0]}},
    }
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    run(tmp_path / "recipe.json", tmp_path / "out")
    moved = read_deck(tmp_path / "out" / "strip.inp").points
    assert moved[-1].tolist() == [120.0, 40.0, 25.0]
    (tmp_path / "direct").mkdir()
    (tmp_path / "direct" / "direct.inp").write_text(deck(moved))
    found = frequencies(tmp_path / "out" / "strip.inp")
    assert len(found) == 5
    assert found == pytest.approx(frequencies(tmp_path / "direct" / "direct.inp"), rel=1e-6)
    rest = frequencies(tmp_path / "strip.inp")
    assert abs(found[0] - rest[0]) > 1e-3 * rest[0]
