# SPDX-License-Identifier: LGPL-2.1-or-later
"""Public decks and meshes, where they are at hand beside the repository."""

from __future__ import annotations

import itertools
import json
import os
from pathlib import Path

import numpy as np
import pytest

from part_samples import moved
from sheetmorph import PartMesh, Session, read_part, run
from sheetmorph.recipe.model import model_of
from sheetmorph.recipe.parts import read_parts

REPOSITORY = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("SHEETMORPH_SHARED", REPOSITORY.parent / "shared"))
# File, vertices, triangles, precision of its coordinates.
FILES = [
    ("01-riveted-oxygen-bottle-support/W1000BOstat.dat", 6291, 11381, "8 characters"),
    ("02-wingbox-skin-and-spars/wingbox_stitched_together-000.bdf", 2673, 4928, "8 characters"),
    ("04-f1-rear-wing/f1_rw_end_plates.stl", 12961, 25791, "float32"),
    ("05-robotnik-summit-stl/summit_xl_chassis.stl", 1448, 2892, "float32"),
    ("07-deformation-classics/bar.off", 6084, 12106, "double"),
    ("07-deformation-classics/cylinder.off", 4802, 9600, "double"),
    ("08-isometric-roll-reference/plate4SD.ply", 1089, 2048, "double"),
]


def real_file(name: str) -> Path:
    """The path of a file of the test data; skips the test where it is absent."""
    path = SHARED / "data" / name
    if not path.is_file():
        pytest.skip(f"{name} is not at hand; set SHEETMORPH_SHARED to the folder above data/")
    return path


@pytest.mark.parametrize("entry", FILES, ids=[name.split("/")[1] for name, *_ in FILES])
def test_a_real_file_comes_back_and_takes_new_coordinates(entry: tuple, tmp_path: Path):
    name, vertices, triangles, precision = entry
    source = real_file(name)
    part = read_part(source)
    assert (len(part.mesh.points), len(part.mesh.triangles)) == (vertices, triangles)
    assert part.precision == precision
    out = tmp_path / source.name
    part.write(out, part.mesh.points)
    assert out.read_bytes() == source.read_bytes()
    positions = moved(part.mesh.points)
    part.write(out, positions)
    largest = np.abs(positions).max()
    rounding = {"double": 0.0, "float32": 1.1e-7 * largest, "8 characters": 1e-5 * largest}
    assert part.read_back_error(out, positions) <= rounding[precision]
    assert read_part(out).mesh.triangles.shape == part.mesh.triangles.shape


def test_a_deck_with_several_meshes_deforms_where_it_is_driven():
    """The largest mesh of the riveted support: its lowest nodes fixed, its highest lifted."""
    from sheetmorph import _core

    mesh = read_part(real_file(FILES[0][0])).mesh
    labels = _core.components(_core.TriangleMesh(mesh.points, mesh.triangles))
    fixed, lifted = [], []
    for label in range(labels.max() + 1):
        vertices = np.flatnonzero(labels == label)
        fixed += vertices[:3].tolist()
        if len(vertices) == np.bincount(labels).max():
            heights = mesh.points[vertices, 2]
            fixed += vertices[heights < np.quantile(heights, 0.1)].tolist()
            lifted = vertices[heights > np.quantile(heights, 0.95)].tolist()
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "support"}],
        "fixed": [{"part": "support", "vertices": mesh.file_ids(fixed)}],
        "handles": [{"name": "top", "part": "support", "vertices": mesh.file_ids(lifted)}],
        "pose": {"top": {"translation": [0, 0, 10.0]}},
    }
    positions = Session(recipe, {"support": mesh}).deform().positions["support"]
    shift = positions - mesh.points
    assert np.isfinite(shift).all()
    assert np.array_equal(positions[lifted], mesh.points[lifted] + [0, 0, 10.0])
    assert 9.0 < np.abs(shift).max() < 30.0


def near(points: np.ndarray, mesh: PartMesh) -> np.ndarray:
    """Indices (k,) of points (n, 3) within 4 mm of a mesh's vertices, edges or triangles."""
    spatial = pytest.importorskip("scipy.spatial")
    corners = mesh.points[mesh.triangles]
    middles = [(corners[:, k] + corners[:, (k + 1) % 3]) / 2.0 for k in range(3)]
    tree = spatial.cKDTree(np.concatenate([mesh.points, corners.mean(axis=1), *middles]))
    return np.flatnonzero(tree.query(points)[0] < 4.0)


def touching(meshes: dict[str, PartMesh]) -> list[dict]:
    """A contact for every pair of parts that touch."""
    found = []
    for a, b in itertools.combinations(meshes, 2):
        sides = {"a": (a, near(meshes[a].points, meshes[b])),
                 "b": (b, near(meshes[b].points, meshes[a]))}  # fmt: skip
        if all(len(vertices) > 2 for _, vertices in sides.values()):
            entry: dict = {"name": f"{a} - {b}"}
            for key, (part, vertices) in sides.items():
                entry[key] = {"part": part, "vertices": meshes[part].file_ids(vertices)}
            found.append(entry)
    return found


def round_holes(meshes: dict[str, PartMesh]) -> list[dict]:
    """A form feature for every round hole."""
    from sheetmorph import _core

    return [
        {"part": name, "vertices": mesh.file_ids(hole.rim)}
        for name, mesh in meshes.items()
        for hole in _core.round_holes(_core.TriangleMesh(mesh.points, mesh.triangles), 0.05)
    ]


def test_the_riveted_support_follows_as_a_whole_and_keeps_its_holes(tmp_path: Path):
    source = real_file(FILES[0][0])
    # The pose bends rigid bodies, which the run would refuse.
    entries = [{"file": str(source), "split": True, "joints": {"broken": "tell"}}]
    meshes = read_parts(model_of({"parts": entries}).parts, tmp_path).meshes
    assert len(meshes) == 12
    first = "W1000BOstat/1"
    along = meshes[first].points[:, np.ptp(meshes[first].points, axis=0).argmax()]
    held = np.flatnonzero(along <= np.quantile(along, 0.03))
    pulled = np.flatnonzero(along >= np.quantile(along, 0.97))
    recipe = {
        "sheetmorph": 1,
        "parts": entries,
        "primary": first,
        "fixed": [{"part": first, "vertices": meshes[first].file_ids(held)}],
        "handles": [{"name": "tip", "part": first, "vertices": meshes[first].file_ids(pulled)}],
        "features": round_holes(meshes),
        "contacts": touching(meshes),
        "pose": {"tip": {"translation": [0, 0, 15.0]}},
    }
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(recipe))
    report = run(path, tmp_path / "out")
    assert len(report["features"]) == 16
    assert report["certificate"]["passed"] and report["unreached"] == []
    assert max(contact["gap_change"] for contact in report["contacts"]) < 2.0
    assert sum(part["quality"]["flipped"] for part in report["parts"]) == 0
    # Coordinates of 8 characters, far from the origin: 3482.17 is good for 0.005 mm an axis.
    assert max(feature["file_edge_error"] for feature in report["features"]) < 0.02
