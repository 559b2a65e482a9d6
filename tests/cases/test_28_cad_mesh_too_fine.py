# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of a small STEP file that would need too many triangles."""
import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize(
    ("sizes", "said"),
    [
        ({"edge": 1e-3}, r"edges of 0\.001 mm would need .* triangles, .* give a longer edge"),
        ({"edge": 0.05}, r"edges of 0\.05 mm would need .* triangles, .* give a longer edge"),
        ({"deflection": 1e-6}, r"a deflection of 1e-06 mm is too small .* give .* mm or more"),
    ],
)
def test_it_is_refused_with_the_figure(
    sizes: dict[str, float], said: str, case: Callable[[str], Path]
) -> None:
    folder = case("28")
    options = [f"--{key}={value}" for key, value in sizes.items()]
    done = sheetmorph("find", "plate.step", *options, folder=folder)
    assert done.status == 2 and re.search(said, done.err), done.said
    part = {"name": "plate", "file": "plate.step", "mesh": sizes}
    (folder / "recipe.json").write_text(json.dumps({"sheetmorph": 1, "parts": [part]}))
    done = sheetmorph("check", "recipe.json", folder=folder)
    assert done.status == 2 and re.search(said, done.err), done.said
