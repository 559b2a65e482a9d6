# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is found does not depend on how fine the mesh of a shape is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from labelled_contacts import pairs
from labelled_shapes import catalogue
from sheetmorph import PartMesh
from sheetmorph.finding import find
from sheetmorph.finding.findings import FindPart, Findings
from sheetmorph.finding.options import HOLES, FindOptions

Mesh = tuple[np.ndarray, np.ndarray]


def halved(mesh: Mesh, times: int = 1) -> Mesh:
    """The same surface, every triangle cut into four, so many times."""
    points, triangles = mesh
    for _ in range(times):
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, number = np.unique(sides, axis=0, return_inverse=True)
        ab, bc, ca = (number.reshape(-1, 3) + len(points)).T
        a, b, c = triangles.T
        points = np.concatenate([points, points[edges].mean(axis=1)])
        quarters = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
        triangles = np.concatenate([np.column_stack(corners) for corners in quarters])
    return points, triangles


def found_in(parts: Mapping[str, Mesh], gap: float | None = None) -> Findings:
    """What is found in parts that stand as they are."""
    meshes = [FindPart(name, PartMesh(*mesh)) for name, mesh in parts.items()]
    return find(meshes, FindOptions(gap=gap))


def proposals(found: Findings) -> tuple[Counter, Counter]:
    """How many features of each kind on each part, contacts of each kind and type on each pair."""
    features = Counter((entry["part"], entry["kind"]) for entry in found.features)
    contacts = Counter(
        (entry["a"]["part"], entry["b"]["part"], entry["kind"], entry["type"])
        for entry in found.contacts
    )
    return features, contacts


FLANGED = {name: mesh for name, mesh in pairs().parts.items() if name.startswith("flange 2")}


@pytest.mark.parametrize("times", [1, 3])
def test_flanges_at_any_fineness_are_tied(times: int):
    coarse = proposals(found_in(FLANGED))
    assert sum(number for (*_, kind), number in coarse[1].items() if kind == "tied") == 2
    fine = found_in({name: halved(mesh, times) for name, mesh in FLANGED.items()})
    assert proposals(fine) == coarse


@settings(max_examples=4)
@given(st.sets(st.sampled_from(sorted(pairs().parts)), min_size=3))
def test_pairs_of_which_some_parts_are_finer_touch_in_the_same_places(finer: set[str]):
    parts = pairs().parts
    coarse = proposals(found_in(parts, gap=1.5))
    mixed = {name: halved(mesh) if name in finer else mesh for name, mesh in parts.items()}
    assert proposals(found_in(mixed, gap=1.5)) == coarse


@pytest.mark.parametrize("shape", catalogue(), ids=lambda shape: shape.name)
def test_holes_keep_kind_place_and_size(shape):
    mesh = (shape.points, shape.triangles)

    def holes(times: int) -> list[tuple]:
        return sorted(
            (entry["kind"], *np.round(entry["center"], 6), round(entry.get("radius", 0.0), 6))
            for entry in found_in({shape.name: halved(mesh, times)}).features
            if entry["kind"] in HOLES
        )

    for coarse, fine in zip(holes(0), holes(2), strict=True):
        assert coarse[0] == fine[0]
        assert np.asarray(fine[1:]) == pytest.approx(np.asarray(coarse[1:]), rel=0.05, abs=0.05)


# What *Find Features* offers unless surfaces are asked for, and the edges of tubes.
OFFERED = (*HOLES, "bend", "round edge")


@pytest.mark.parametrize("times", [1, 3])
@pytest.mark.parametrize("coarse", [1.0, 2.0])
@pytest.mark.parametrize("name", ["angle", "hat", "pressed", "cone", "dome", "tube"])
def test_faceted_bends_cones_and_domes_offer_the_same_at_any_fineness(
    name: str, coarse: float, times: int
):
    (shape,) = (shape for shape in catalogue(coarse) if shape.name == name)

    def offered(times: int) -> Counter:
        found = found_in({name: halved((shape.points, shape.triangles), times)})
        return Counter(e["kind"] for e in found.features if e["kind"] in OFFERED)

    assert offered(0).total() > 0
    assert offered(times) == offered(0)
