# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bent plate with holes and a thickness converges, to what its open mid-surface converges to."""

from __future__ import annotations

import pytest

from bending import Bend, halving_changes
from sheetmorph import PartMesh, _core
from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh
from thin_plates import thin_plate


def plate_along_y(edge: float) -> PartMesh:
    """A plate of 60 by 20 by 1 mm with three holes, meshed anew."""
    plate = thin_plate(holes=3, cells=6)
    points = plate.points[:, [1, 0, 2]] * [-1.0, 1.0, 1.0]
    return prepared_mesh(_core, PartMesh(points, plate.triangles), Wanted(0.0, edge))[0]


@pytest.mark.parametrize(
    "bend",
    [Bend(30.0), Bend(30.0, 20.0), Bend(30.0, energy="natural"), Bend(30.0, 20.0, "natural")],
    ids=["bent", "twisted too", "bent, natural", "twisted too, natural"],
)
def test_halving_the_edges_hardly_changes_a_bent_plate(bend: Bend):
    changes = halving_changes(plate_along_y(2.0), plate_along_y(1.0), bend)
    assert 0.0 < changes["halved"] < 0.01
    assert 0.0 < changes["open"] < 0.01
