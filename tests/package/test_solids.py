# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that are not thin everywhere, and solids at large with something inside."""

from __future__ import annotations

import numpy as np
import pytest

from bending import Ends, bent, bent_and_twisted, thin_holes
from lumpy_plates import LUMPS, THICKNESS, lumpy_plate
from sheet_meshes import flat, inside, polygon, thickened
from sheetmorph import PartMesh, Session, _core
from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh


def test_bosses_ribs_and_welded_nuts_are_rigid_though_nobody_marked_them():
    mesh = PartMesh(*lumpy_plate())
    assert _core.diagnose(_core.TriangleMesh(mesh.points, mesh.triangles), 1e-6).open_edges == 0
    solid, _ = thin_holes(mesh)
    session = bent(mesh, [], Ends(1, 0.05), part={"thin": "auto"})
    result = session.deform({"end": bent_and_twisted(0.9 * 160.0, 40.0, 20.0)})
    points = result.positions["part"]
    (part,) = result.report()["parts"]
    assert len(part["thin"]["lumps"]) == len(LUMPS)
    assert part["thin"]["largest_change"] < 0.01 and part["quality"]["flipped"] == 0
    assert part["thin"]["self_intersections"] == {"rest": 0, "deformed": 0}
    for name, (loop, height) in LUMPS.items():
        own = inside(1.0001 * (loop - loop.mean(axis=0)) + loop.mean(axis=0), mesh.points[:, :2])
        own &= mesh.points[:, 2] > THICKNESS - 1e-6
        assert any(set(np.flatnonzero(own)) <= set(lump) for lump in solid.lumps), name
        rest, moved = mesh.points[own], points[own]
        assert np.ptp(mesh.points[own, 2]) == pytest.approx(height)
        distances = [np.linalg.norm(p - p[0], axis=1) for p in (rest, moved)]
        assert np.abs(distances[0] - distances[1]).max() < 1e-9, name
    away = mesh.points[:, 2] < 1e-6
    assert np.linalg.norm(points[away] - mesh.points[away], axis=1).max() > 20.0  # the sheet bends


def block(low: tuple, high: tuple, edge: float) -> PartMesh:
    """A solid block, meshed."""
    (a, b, c), (d, e, f) = low, high
    points, triangles = flat(polygon([(a, b), (d, b), (d, e), (a, e)], 10.0), [], 10.0)
    count = len(polygon([(a, b), (d, b), (d, e), (a, e)], 10.0))
    points, triangles = thickened(points, triangles, [count], f - c)
    solid = PartMesh(points + [0.0, 0.0, c], triangles.astype(np.int32))
    return prepared_mesh(_core, solid, Wanted(0.0, edge))[0]


def test_what_is_inside_a_block_goes_along_with_its_control_mesh():
    outer, inner = block((0, 0, 0), (40, 120, 30), 6.0), block((12, 45, 9), (28, 75, 21), 4.0)
    along = outer.points[:, 1]
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "block", "thin": "auto"}, {"name": "core"}],
        "primary": "block",
        "propagation": {"type": "single"},
        "fixed": [{"part": "block", "vertices": np.flatnonzero(along < 6.0).tolist()}],
        "handles": [
            {"name": "end", "part": "block", "vertices": np.flatnonzero(along > 114.0).tolist()}
        ],
    }
    meshes = {
        name: PartMesh(mesh.points, mesh.triangles)
        for name, mesh in (("block", outer), ("core", inner))
    }
    result = Session(recipe, meshes).deform({"end": bent_and_twisted(108.0, 30.0, 0.0)})
    moved = result.positions
    (whole, _) = result.report()["parts"]
    assert whole["thin"] is None and whole["quality"]["flipped"] == 0
    # The block is bent along an arc; so is what lies in its middle, and it stays inside.
    lift = moved["core"].mean(axis=0) - inner.points.mean(axis=0)
    ring = np.abs(along - 60.0) < 15.0
    around = (moved["block"] - outer.points)[ring].mean(axis=0)
    assert np.linalg.norm(lift) > 5.0
    assert np.linalg.norm(lift - around) < 0.15 * np.linalg.norm(around)
    tree = _core.PickingTree(moved["block"], outer.triangles)
    gaps = [tree.nearest_point(place).distance for place in moved["core"]]
    assert 6.0 < min(gaps) and max(gaps) < 18.0
    both = np.vstack([outer.triangles, inner.triangles + len(outer.points)])
    mesh = _core.TriangleMesh(np.vstack([moved["block"], moved["core"]]), both)
    assert len(_core.self_intersections(mesh)) == 0
