# SPDX-License-Identifier: LGPL-2.1-or-later
"""Set 05: plates, covers and tubes as CAD exports them, cured and bent, or refused with reasons."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from bending import Ends, bent, bent_and_twisted, thin_holes
from sheetmorph import PartMesh, _core, diagnose, read_part
from sheetmorph.files.prepared_mesh import Wanted, prepared_mesh
from test_real_files import real_file

SUMMIT = "05-robotnik-summit-stl"


def cured(name: str, edge: float) -> PartMesh:
    """A file after the cures that the doctor offers for it, with an edge length of our own, mm."""
    mesh = read_part(real_file(f"{SUMMIT}/{name}.stl")).mesh
    part = diagnose(mesh, unit="m")["part"]
    made, _ = prepared_mesh(_core, mesh, Wanted(part.get("weld", 0.0), edge, scale=part["scale"]))
    return made


def largest_fold(points: np.ndarray, triangles: np.ndarray) -> float:
    """Degrees by which neighbours in a mesh that was flat are bent out of one plane, at most."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = np.sort(np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    order = np.lexsort(edges.T)
    owner = np.tile(np.arange(len(triangles)), 3)[order]
    edges = edges[order]
    pairs = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    cosines = np.einsum("ij,ij->i", normals[owner[pairs]], normals[owner[pairs + 1]])
    return float(np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))).max())


def round_holes(points: np.ndarray, triangles: np.ndarray) -> list[Any]:
    """The round holes that are found, those through both skins with both rims."""
    found = _core.find_features(_core.TriangleMesh(points, triangles))
    return [hole for hole in found if hole.kind == "round hole"]


def clearance(hole: Any, points: np.ndarray, tree: Any) -> float:
    """The distance from the axis of a hole, all through the sheet, to the nearest facet, mm."""
    rims = [points[rim].mean(axis=0) for rim in hole.rims]
    way = [rims[0] + share * (rims[-1] - rims[0]) for share in (-0.5, 0.0, 0.5, 1.0, 1.5)]
    return min(tree.nearest_point(place).distance for place in way)


def test_the_stainless_plate_bends_and_twists_and_stays_a_sheet():
    mesh = cured("summit_xls_chapas_inox_tapas", 8.0)
    solid, holes = thin_holes(mesh)
    assert len(holes) == 71  # the file has two plates side by side, four holes between them
    ends = Ends()
    session = bent(mesh, holes, ends, part={"thin": "auto"})
    length = (1.0 - 2.0 * ends.share) * np.ptp(mesh.points[:, 1])
    result = session.deform({"end": bent_and_twisted(length, 30.0, 20.0)})
    report = result.report()
    assert report["certificate"]["passed"] and len(report["features"]) > 50
    thin = report["parts"][0]["thin"]
    assert thin["thickness"] == pytest.approx(1.5, rel=1e-6)
    assert thin["largest_change"] < 0.005
    assert thin["largest_change_at_walls"] < 0.02
    assert thin["self_intersections"] == {"rest": 0, "deformed": 0}
    assert report["parts"][0]["quality"]["flipped"] == 0
    points = result.positions["part"]
    for side in (0, 1):  # the main skin and the other
        assert largest_fold(points, mesh.triangles[np.asarray(solid.facets) == side]) < 6.0
    same_holes(mesh, points)


def same_holes(mesh: PartMesh, points: np.ndarray) -> None:
    """Round holes are as round as they were, on both skins and between, and nothing covers them."""
    before = round_holes(mesh.points, mesh.triangles)
    after = round_holes(points, mesh.triangles)
    assert len(before) == len(after) == 58
    rest, moved = (_core.PickingTree(at, mesh.triangles) for at in (mesh.points, points))
    for one, other in zip(before, after):
        assert len(other.rims) == 2 and np.array_equal(one.vertices, other.vertices)
        assert other.radius == pytest.approx(one.radius, rel=1e-9)
        assert other.residual < one.residual + 1e-9
        assert clearance(other, points, moved) > 0.999 * clearance(one, mesh.points, rest)


def component(mesh: PartMesh, labels: np.ndarray, number: int) -> PartMesh:
    """One connected piece of a mesh; triangles without area join nothing, and belong to none."""
    own = np.flatnonzero(labels == number)
    place = np.full(len(mesh.points), -1)
    place[own] = np.arange(len(own))
    whole = (labels[mesh.triangles] == number).all(axis=1)
    return PartMesh(mesh.points[own], place[mesh.triangles[whole]])


# Thicknesses, mm, of what is a sheet and does not cross itself: two clips, two straps, the back,
# the armrests' pads, two bars of 346 x 52 x 30 mm, a pan of 430 x 431 x 51 mm. The seat (32 mm) is
# at the limit of what counts as a sheet: which side it is on depends on the mesh.
CHAIR = [1.0, 1.0, 3.0, 3.0, 7.0, 16.5, 16.5, 23.967, 23.968, 30.0]


@pytest.mark.parametrize(
    ("name", "components", "sheets"),
    [
        ("summit_xl_covers", 10, [1.5, 1.5, 1.5, 4.0]),
        ("summit_xl_chassis", 1, []),
        ("structure_chair", 28, CHAIR),
    ],
)
def test_what_else_comes_from_cad_bends_once_cured(name: str, components: int, sheets: list):
    mesh = cured(name, 20.0)
    labels = np.asarray(_core.components(_core.TriangleMesh(mesh.points, mesh.triangles)))
    assert labels.max() + 1 == components
    thin = []
    for number in range(components):
        piece = component(mesh, labels, number)
        axis = int(np.ptp(piece.points, axis=0).argmax())
        session = bent(piece, [], Ends(axis), part={"thin": "auto"})
        turn = {"axis": np.eye(3)[(axis + 1) % 3].tolist(), "degrees": 5}
        report = session.deform({"end": {"rotation": turn}}).report()
        (part,) = report["parts"]
        rest = _core.TriangleMesh(piece.points, piece.triangles)
        if len(_core.self_intersections(rest)) > 0:
            assert any("at rest" in note for note in report["notes"])
            continue
        assert part["quality"]["flipped"] == 0
        if part["thin"] is None:
            assert any("not recognised as a thin solid" in note for note in report["notes"])
        else:
            thin.append(part["thin"]["thickness"])
            assert part["thin"]["self_intersections"]["deformed"] == 0
    assert sorted(np.round(thin, 3)) == sheets
