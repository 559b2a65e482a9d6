# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed plate most of whose triangles are turned over."""
import json
import struct
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

FILE = "plate_mostly_inside_out.stl"


def volume(path: Path) -> float:
    """What an OBJ file encloses."""
    lines = [line.split() for line in path.read_text("utf-8").splitlines()]
    points = [tuple(map(float, words[1:4])) for words in lines if words[:1] == ["v"]]
    total = 0.0
    for words in lines:
        if words[:1] == ["f"]:
            a, b, c = (points[int(word.split("/")[0]) - 1] for word in words[1:4])
            total += a[0] * (b[1] * c[2] - b[2] * c[1])
            total += a[1] * (b[2] * c[0] - b[0] * c[2])
            total += a[2] * (b[0] * c[1] - b[1] * c[0])
    return total / 6.0


def test_a_welded_closed_piece_faces_outwards(case: Callable[[str], Path]) -> None:
    folder = case("18")
    count = struct.unpack("<I", (folder / FILE).read_bytes()[80:84])[0]
    assert count > 0
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": FILE, "weld": 0.001}],
        "fixed": [
            {"part": "plate", "where": {"half_space": {"point": [1, 0, 0], "normal": [-1, 0, 0]}}}
        ],
        "handles": [
            {
                "name": "end",
                "part": "plate",
                "where": {"half_space": {"point": [119, 0, 0], "normal": [1, 0, 0]}},
            }
        ],
        "pose": {"end": {"translation": [0, 0, 0]}},
    }
    (folder / "rest.json").write_text(json.dumps(recipe), "utf-8")
    done = sheetmorph("run", "rest.json", "-o", "out", folder=folder)
    assert done.status == 0, done.said
    (written,) = (folder / "out").glob("*.obj")
    assert volume(written) == pytest.approx(21_600.0, rel=1e-6)
