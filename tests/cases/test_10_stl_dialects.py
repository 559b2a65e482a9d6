# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files without their last bytes, or their last line."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize(
    ("name", "said"),
    [("binary_short_by_2.stl", "2 bytes are missing"), ("no_endsolid.stl", "endsolid is missing")],
)
def test_all_facets_are_read_with_a_word(name: str, said: str, case: Callable[[str], Path]) -> None:
    done = sheetmorph("doctor", name, folder=case("10"))
    (found,) = json.loads(done.out)["files"]
    assert found["triangles"] == 680 and abs(found["thickness"] - 2.0) < 1e-5
    assert found["findings"][0]["finding"] == "not read whole"
    assert said in found["findings"][0]["text"]
