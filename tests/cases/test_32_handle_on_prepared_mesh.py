# SPDX-License-Identifier: LGPL-2.1-or-later
"""A handle, or a point, on a triangle of a part with scale, weld or remesh."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize("name", ["scale", "weld", "remesh"])
def test_it_sits_on_the_nearest_place_of_the_prepared_mesh(
    name: str, case: Callable[[str], Path]
) -> None:
    folder = case("32")
    done = sheetmorph("check", f"{name}.json", folder=folder)
    assert done.status == 0, done.said
    recipe = json.loads((folder / f"{name}.json").read_text())
    handle = recipe["handles"].pop()
    recipe["points"] = [{**handle, "target": [0, 0, 0]}]
    recipe["pose"] = {}
    del recipe["points"][0]["name"]
    lines = (folder / "strip.obj").read_text().splitlines()
    scale = recipe["parts"][0].get("scale", 1)
    places = [[scale * float(x) for x in line.split()[1:]] for line in lines if line[0] == "v"]
    faces = [[int(x) - 1 for x in line.split()[1:]] for line in lines if line[0] == "f"]
    corners = [places[k] for k in faces[handle["triangle"]]]
    rest = [
        sum(w * corner[axis] for w, corner in zip(handle["barycentric"], corners))
        for axis in range(3)
    ]
    recipe["points"][0]["target"] = [rest[0], rest[1], rest[2] + 1.0]
    (folder / "point.json").write_text(json.dumps(recipe))
    done = sheetmorph("run", "point.json", "-o", "out", "--json", folder=folder)
    assert done.status == 0, done.said
    moved = json.loads(done.out)["parts"][0]["largest_displacement"]
    assert 0.9 < moved < 5.0
