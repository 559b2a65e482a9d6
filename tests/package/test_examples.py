# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example assemblies are sound sheet metal, and the generator makes exactly them."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
SIZES = {
    "door_mirror": [706, 1264, 500],
    "body_panels": [820, 1757],
}
FRAME = "welded_frame"
ALL = [*SIZES, FRAME]


def read_mesh(path):
    """Points (n, 3) and triangles (m, 3) of an OBJ or ASCII PLY, read without SheetMorph."""
    lines = path.read_text(encoding="utf-8").splitlines()
    if path.suffix == ".obj":
        points = [line.split()[1:] for line in lines if line.startswith("v ")]
        faces = [line.split()[1:] for line in lines if line.startswith("f ")]
        return np.array(points, float), np.array(faces, int) - 1
    count = next(int(line.split()[-1]) for line in lines if line.startswith("element vertex"))
    body = lines[lines.index("end_header") + 1 :]
    faces = [line.split()[1:] for line in body[count:]]
    return np.array([line.split() for line in body[:count]], float), np.array(faces, int)


def read_recipe(example):
    return json.loads((EXAMPLES / example / "recipe.json").read_text(encoding="utf-8"))


def read_parts(example):
    recipe = read_recipe(example)
    return {part["name"]: read_mesh(EXAMPLES / example / part["file"]) for part in recipe["parts"]}


def directed_edges(triangles):
    return np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def boundary_loops(triangles):
    """Open edges as lists of vertices in order."""
    edges = {tuple(edge) for edge in directed_edges(triangles).tolist()}
    after = {a: b for a, b in edges if (b, a) not in edges}
    loops = []
    while after:
        start, here = after.popitem()
        loop = [start]
        while here != start:
            loop.append(here)
            here = after.pop(here)
        loops.append(loop)
    return loops


def circle_error(points):
    """How far (k, 3) points are from the circle around their centre, in mm."""
    offset = points - points.mean(axis=0)
    normal = np.linalg.svd(offset)[2][2]
    radii = np.linalg.norm(offset, axis=1)
    return max(np.abs(offset @ normal).max(), np.abs(radii - radii.mean()).max())


def smallest_angles(points, triangles):
    corners = points[triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    sides /= np.linalg.norm(sides, axis=2, keepdims=True)
    cosines = -np.sum(sides * np.roll(sides, 1, axis=1), axis=2)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1))).min(axis=1)


@pytest.fixture(scope="module")
def regenerated(tmp_path_factory):
    folder = tmp_path_factory.mktemp("examples")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import generate
    finally:
        sys.path.remove(str(EXAMPLES))
    generate.main(folder)
    return folder


@pytest.mark.parametrize("example", SIZES)
def test_parts_have_the_sizes_of_the_paper(example):
    assert [len(points) for points, _ in read_parts(example).values()] == SIZES[example]


def test_the_frame_has_14_parts_5963_vertices_and_24_contacts():
    parts = read_parts(FRAME)
    assert len(parts) == 14
    assert sum(len(points) for points, _ in parts.values()) == 5963
    assert len(read_recipe(FRAME)["contacts"]) == 24


@pytest.mark.parametrize("example", ALL)
def test_every_part_is_one_oriented_manifold_sheet_without_spare_vertices(example):
    for name, (points, triangles) in read_parts(example).items():
        edges = directed_edges(triangles)
        assert len(np.unique(edges, axis=0)) == len(edges), f"{name}: an edge is used twice"
        assert len(np.unique(triangles)) == len(points), f"{name}: unused vertices"
        assert len(np.unique(np.round(points, 5), axis=0)) == len(points), f"{name}: double vertex"
        loops = boundary_loops(triangles)
        undirected = np.unique(np.sort(edges, axis=1), axis=0)
        euler = len(points) - len(undirected) + len(triangles)
        assert euler == 2 - len(loops), f"{name}: not one disk with holes"


@pytest.mark.parametrize("example", ALL)
def test_every_hole_is_round_to_rounding_and_is_a_feature_with_its_washer(example):
    features = read_recipe(example)["features"]
    assert features
    parts = read_parts(example)
    for feature in features:
        points, triangles = parts[feature["part"]]
        chosen = set(feature["vertices"])
        rims = [loop for loop in boundary_loops(triangles) if set(loop) <= chosen]
        assert len(rims) == 1, feature["name"]
        assert len(rims[0]) >= 16
        washer = sorted(chosen - set(rims[0]))
        assert len(washer) == len(rims[0])
        for ring in (rims[0], washer):
            assert circle_error(points[ring]) < 1e-12, feature["name"]


@pytest.mark.parametrize("example", ALL)
def test_boundaries_other_than_the_outline_are_round_holes(example):
    for name, (points, triangles) in read_parts(example).items():
        loops = boundary_loops(triangles)
        lengths = [np.linalg.norm(np.ptp(points[loop], axis=0)) for loop in loops]
        holes = [loop for k, loop in enumerate(loops) if k != int(np.argmax(lengths))]
        assert holes, f"{name} has no hole"
        assert max(circle_error(points[loop]) for loop in holes) < 1e-12, name


@pytest.mark.parametrize("example", ALL)
def test_triangles_are_well_shaped(example):
    for name, (points, triangles) in read_parts(example).items():
        angles = smallest_angles(points, triangles)
        assert angles.min() > 8.0, name
        assert np.mean(angles < 20.0) < 0.03, name


@pytest.mark.parametrize("example", ALL)
def test_contact_sides_touch_and_name_both_parts(example):
    parts = read_parts(example)
    contacts = read_recipe(example)["contacts"]
    assert contacts
    for contact in contacts:
        sides = [parts[contact[s]["part"]][0][contact[s]["vertices"]] for s in "ab"]
        assert contact["a"]["part"] != contact["b"]["part"]
        assert min(len(side) for side in sides) >= 3
        gaps = np.linalg.norm(sides[0][:, None] - sides[1][None], axis=2).min(axis=1)
        size = np.linalg.norm(np.ptp(np.vstack(sides), axis=0))
        assert gaps.max() < size / 2, contact["name"]


@pytest.mark.parametrize("example", ALL)
def test_regions_of_one_part_do_not_overlap(example):
    recipe = read_recipe(example)
    taken = set()
    for region in [*recipe["fixed"], *recipe["handles"], *recipe["features"]]:
        vertices = {(region["part"], vertex) for vertex in region["vertices"]}
        assert not vertices & taken
        taken |= vertices


@pytest.mark.parametrize("example", ALL)
def test_the_generator_makes_the_files_of_the_repository(example, regenerated):
    for path in sorted((regenerated / example).iterdir()):
        kept = EXAMPLES / example / path.name
        if path.suffix == ".json":
            assert json.loads(path.read_text()) == json.loads(kept.read_text()), path.name
            continue
        points, triangles = read_mesh(path)
        kept_points, kept_triangles = read_mesh(kept)
        assert np.array_equal(triangles, kept_triangles), path.name
        # The last bits of a cosine depend on the processor; Debian 13 has a point 3e-8 mm off.
        assert np.abs(points - kept_points).max() < 1e-7, path.name


@pytest.mark.parametrize("name", ["bracket.inp", "recipe.json"])
def test_the_generator_makes_the_deck_of_the_bracket(name, regenerated):
    assert (regenerated / "bracket" / name).read_text() == (EXAMPLES / "bracket" / name).read_text()


@pytest.fixture(scope="module", params=ALL)
def morph(request, tmp_path_factory):
    """Recipe, report, and per part the points at rest, the deformed ones and the triangles."""
    sheetmorph = pytest.importorskip("sheetmorph")
    folder = tmp_path_factory.mktemp(request.param)
    report = sheetmorph.run(EXAMPLES / request.param / "recipe.json", folder)
    recipe = read_recipe(request.param)
    parts = {
        part["name"]: (
            read_mesh(EXAMPLES / request.param / part["file"])[0],
            *read_mesh(folder / part["file"]),
        )
        for part in recipe["parts"]
    }
    return recipe, report, parts


def test_the_recipe_moves_every_part_those_at_the_fixed_end_a_little(morph):
    recipe, report, parts = morph
    assert report["unreached"] == []
    for name, (rest, bent, _) in parts.items():
        least = 15.0 if name == recipe["primary"] else 0.1
        assert np.linalg.norm(bent - rest, axis=1).max() > least, name


def test_the_recipe_keeps_every_hole_and_the_shape_of_triangles(morph):
    recipe, _, parts = morph
    for feature in recipe["features"]:
        rest, bent, _ = parts[feature["part"]]
        size = np.linalg.norm(np.ptp(rest, axis=0))
        rings = [points[feature["vertices"]] for points in (rest, bent)]
        before, after = (np.linalg.norm(r - np.roll(r, 1, axis=0), axis=1) for r in rings)
        assert np.abs(after - before).max() < 1e-11 * size
    for name, (_, bent, triangles) in parts.items():
        assert smallest_angles(bent, triangles).min() > 5.0, name


def test_welds_stay_closed_to_half_a_percent_of_their_size(morph):
    recipe, report, _ = morph
    assert len(report["contacts"]) == len(recipe["contacts"])
    # A single control mesh holds no contact; there the report only tells what happens to it.
    share = 0.005 if recipe["propagation"]["type"] == "local" else 0.07
    for contact in report["contacts"]:
        assert contact["gap_change"] < share * contact["region_size"], contact["name"]
