# SPDX-License-Identifier: LGPL-2.1-or-later
"""Skins that are one polygon each: an L, and a plate whose hole a bridge connects to its rim."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


def test_an_l_has_the_area_of_its_faces(case: Callable[[str], Path]) -> None:
    done = sheetmorph("doctor", "l_plate.obj", folder=case("11"))
    (found,) = json.loads(done.out)["files"]
    assert found["kind"] == "thin solid" and found["thickness"] == pytest.approx(2.0)
    assert sum(piece["area"] for piece in found["components"]) == pytest.approx(4480.0)
    assert found["counts"]["flipped_triangles"] == 0


def test_a_hole_with_a_bridge_stays_open(case: Callable[[str], Path]) -> None:
    folder = case("11")
    done = sheetmorph("doctor", "keyhole_plate.obj", folder=folder)
    (found,) = json.loads(done.out)["files"]
    (piece,) = found["components"]
    assert piece["volume"] == pytest.approx(1.5 * 5689.42, rel=1e-5)
    found = json.loads(sheetmorph("find", "keyhole_plate.obj", folder=folder).out)
    holes = [one for one in found["features"] if one["kind"] == "round hole"]
    assert {round(one["radius"], 6) for one in holes} == {10.0}
