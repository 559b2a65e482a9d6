# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round holes with a ring of washer, and a size: the rim gets the size, the washer follows."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest

from conftest import sheetmorph


HOLES = {"h1": ([30, 40, 0], 13.0), "h2": ([95, 45, 0], 9.0), "h3": ([60, 35, 0], 17.5)}


@pytest.mark.parametrize("rings", [0, 1, 2])
def test_holes_with_rings_of_washer_get_their_size(case: Callable[[str], Path], rings: int) -> None:
    folder = case("22")
    recipe = json.loads((folder / "size_with_washer.json").read_text())
    recipe["features"] = [
        {"name": name, "part": "bracket", "where": {"rim_at": place, "rings": rings}, "size": size}
        for name, (place, size) in HOLES.items()
    ]
    (folder / "all.json").write_text(json.dumps(recipe))
    for name in ("size_with_washer.json", "all.json"):
        checked = sheetmorph("check", name, folder=folder)
        assert checked.status == 0, checked.said
    ran = sheetmorph("run", "all.json", "-o", "out", "--report", "r.json", folder=folder)
    assert ran.status == 0, ran.said
    for one in json.loads((folder / "r.json").read_text())["features"]:
        assert (one["kind"], one["size"]) == ("hole", HOLES[one["name"]][1])
        assert one["measured_size"] == pytest.approx(one["size"], abs=1e-4)
