# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies of thin solids from STEP files: prepared, found and deformed as a whole."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "real"))

import laser_cut_box  # noqa: E402
import recipes  # noqa: E402
import selection  # noqa: E402
from sheetmorph import Session  # noqa: E402

pytestmark = pytest.mark.skipif(recipes.data_folder() is None, reason=recipes.ABSENT)


def test_a_finger_jointed_box_turns_as_a_whole_and_its_plates_stay_plates():
    recipe = recipes.make("box")
    meshes = selection.read_meshes(recipe["parts"], recipes.data_folder())
    result = Session(recipe, meshes).deform()
    report = result.report()
    assert report["certificate"]["passed"] and report["unreached"] == []
    assert len(report["parts"]) == 10 and len(report["features"]) == 21
    for part in report["parts"]:
        thin = part["thin"]
        assert part["quality"]["flipped"] == 0, part["name"]
        assert thin["thickness"] == pytest.approx(2.9972, rel=1e-6)
        assert thin["largest_change"] < 0.008
        assert thin["largest_change_at_walls"] < 0.02
        assert thin["self_intersections"] == {"rest": 0, "deformed": 0}
    # The plates at both ends turn as bodies, those between them twist; joints stay shut.
    moved = result.positions[laser_cut_box.FRONT] - meshes[laser_cut_box.FRONT].points
    assert np.linalg.norm(moved, axis=1).max() > 14.0
    assert len(report["contacts"]) >= 20
    for contact in report["contacts"]:
        assert contact["gap_change"] < 0.5, contact["name"]
