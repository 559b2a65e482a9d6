# SPDX-License-Identifier: LGPL-2.1-or-later
"""One recipe with selectors means the same on coarse and fine meshes of a real STEP file."""

from __future__ import annotations

import sys
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "real"))

import recipes  # noqa: E402
from sheetmorph import PartMesh, Session, _core  # noqa: E402
from sheetmorph.files import read_part  # noqa: E402
from sheetmorph.recipe.splitting import part_of  # noqa: E402
from sheetmorph.selecting import PartShape, selected  # noqa: E402

pytestmark = pytest.mark.skipif(recipes.data_folder() is None, reason=recipes.ABSENT)
FILE = "03-laser4diy-enclosure/Enclosure_v3_v9.step"
COVER = "LaserChamberv3 v16.ChamberTop"  # bent, 1 mm thick, 277 x 337 x 88 mm
BRACKET = "LaserChamberv3 v16.ChamblerLeft"  # bent, with four round holes
EDGES = (12.0, 6.0, 3.0)
SIZES = {"deflection": 0.3, "angle": 30.0}


def skins(key: str, *pairs: tuple) -> list[dict]:
    """The faces of both skins of a sheet."""
    return [{key: list(place), "kind": "plane"} for place in pairs]


RECIPE = {
    "sheetmorph": 1,
    "parts": [{"name": COVER, "thin": "auto"}],
    "energy": "natural",
    "fixed": [
        {"part": COVER, "where": skins("cad_face_at", (580, 129, -183), (581, 129, -183))},
    ],
    "handles": [
        {
            "name": "left flange",
            "part": COVER,
            "pivot": [305, 129, -138.5],
            "where": skins("cad_face_at", (304, 129, -138), (305, 129, -138)),
        }
    ],
    "pose": {
        "left flange": {
            "translation": [0, 15, 0],
            "rotation": {"axis": [0, 0, 1], "degrees": 4},
        }
    },
}
SELECTORS = [
    {"cad_face_at": [442.5, 172, -28], "kind": "plane"},
    {"rim_at": [398.75, 170.25, -27]},
    {"found": "round hole", "diameter": [3.4, 3.6], "holes": 2},
    {"half_space": {"point": [400, 0, 0], "normal": [-1, 0, 0]}},
    {"slab": {"point": [442, 0, 0], "normal": [1, 0, 0], "thickness": 90}},
    {"cylinder": {"point": [442, 131, 0], "direction": [0, 0, 1], "radius": 25}},
    {"sphere": {"center": [442, 131, -17], "radius": 30}},
    {"box": [[300, 150, -50], [350, 200, 0]]},
    {"minus": [{"all": True}, {"half_space": {"point": [400, 0, 0], "normal": [-1, 0, 0]}}]},
    {"group": "solid LaserChamberv3 v16.ChamblerLeft"},
]


@lru_cache(maxsize=None)
def meshes(edge: float) -> dict[str, PartMesh]:
    """Cover and bracket with edges of a length, mm."""
    file = read_part(recipes.data_folder() / FILE, {"edge": edge, **SIZES})
    return {name: part_of(file.mesh, file.bodies[name], name)[0] for name in (COVER, BRACKET)}


@pytest.mark.parametrize("selector", SELECTORS, ids=lambda selector: next(iter(selector)))
def test_a_region_is_the_same_by_area_at_edges_of_12_6_and_3_mm(selector):
    areas = []
    for edge in EDGES:
        shape = PartShape(meshes(edge)[BRACKET])
        areas.append(shape.area_of(selected(shape, selector)))
    assert np.ptp(areas) <= 0.03 * min(areas), areas


def test_faces_have_the_colours_of_their_file():
    for mesh in meshes(12.0).values():
        faces = [mesh.labels.faces[k] for k in np.unique(mesh.labels.face)]
        colours = {face.colour for face in faces}
        assert all(len(colour) == 7 and colour[0] == "#" for colour in colours), colours
        shape = PartShape(mesh)
        area = sum(shape.area_of(selected(shape, {"group": f"colour {c}"})) for c in colours)
        assert area == pytest.approx(shape.areas.sum(), rel=1e-9)


def test_one_recipe_gives_the_same_shape_at_edges_of_12_6_and_3_mm():
    results = {edge: Session(RECIPE, {COVER: meshes(edge)[COVER]}).deform() for edge in EDGES}
    regions = [result.report()["regions"] for result in results.values()]
    for same in zip(*regions):
        areas = [region["area"] for region in same]
        assert np.ptp(areas) <= 0.03 * min(areas) and max(r["distance"] for r in same) < 0.01
    fine, rest = results[3.0].positions[COVER], meshes(3.0)[COVER]
    tree = _core.PickingTree(rest.points, rest.triangles)
    for edge in (12.0, 6.0):
        mesh, positions = meshes(edge)[COVER], results[edge].positions[COVER]
        moved = positions - mesh.points
        off = [
            np.linalg.norm(moved[k] - moved_at(tree, point, (rest, fine)))
            for k, point in enumerate(mesh.points)
        ]
        assert max(off) <= 0.005 * np.linalg.norm(moved, axis=1).max(), (edge, max(off))


def moved_at(tree, point: np.ndarray, shape: tuple[PartMesh, np.ndarray]) -> np.ndarray:
    """How far the place of another mesh that is nearest to a point has moved."""
    mesh, positions = shape
    hit = tree.nearest_point(point)
    corners = mesh.triangles[hit.triangle]
    return np.asarray(hit.barycentric) @ (positions[corners] - mesh.points[corners])
