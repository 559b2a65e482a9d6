# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stainless plate with lettering and 71 holes, an STL from CAD in metres, bent and twisted.

    /usr/bin/python3 tests/real/stainless_plate.py

Prints what the report says of the plate as it comes and as the doctor would have it, and how much
halving its edges changes it; needs the staged package on PYTHONPATH. take_pictures.py takes the
picture of both.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))

from bending import Bend, bent_and_twisted, halving_changes  # noqa: E402
from selection import Meshes, read_meshes, region  # noqa: E402

FILE = "05-robotnik-summit-stl/summit_xls_chapas_inox_tapas.stl"
NAME = "plate"
BEND, TWIST = 30.0, 20.0  # degrees
END = 0.03  # of the length, held and moved
METRES = {"scale": 1000.0}
CURES = {**METRES, "weld": 1e-3, "remesh": {"edge": 5.0}, "thin": "auto"}


def stainless_plate(data: Path, keys: dict = CURES) -> dict:
    """The plate with some keys of its part: one end held, the other turned, every hole a feature.

    Vertex ids are those of the file, so that the plate is held alike whatever is done to it.
    """
    cured = [{"name": NAME, "file": str(data / FILE), **CURES}]
    meshes = read_meshes(cured, data)
    along = meshes[NAME].source.points[:, 1]
    low, length = along.min(), np.ptp(along)
    held, moved = along < low + END * length, along > low + (1.0 - END) * length
    holes = []
    for vertices in through_holes(meshes):
        for end in (held, moved):  # a hole at an end goes with the end
            end[vertices] |= end[vertices].any()
        if not (held[vertices].any() or moved[vertices].any()):
            holes.append(vertices)
    whole: Meshes = {NAME: meshes[NAME].source}
    return {
        "sheetmorph": 1,
        "parts": [{"name": NAME, "file": str(data / FILE), **keys}],
        "fixed": [region(whole, NAME, held)],
        "handles": [region(whole, NAME, moved, name="end")],
        "features": [
            {"name": f"hole{k}", "part": NAME, "vertices": vertices.tolist()}
            for k, vertices in enumerate(holes, start=1)
        ],
        "pose": {"end": bent_and_twisted((1.0 - 2.0 * END) * length, BEND, TWIST)},
    }


def through_holes(meshes: Meshes) -> list[np.ndarray]:
    """The holes through both skins, vertices of the file."""
    from sheetmorph import _core

    mesh = meshes[NAME]
    solid, reason = _core.find_thin_solid(_core.TriangleMesh(mesh.points, mesh.triangles), 0.0)
    if solid is None:
        raise ValueError(reason)
    return [np.unique(mesh.file_ids(hole.vertices)) for hole in solid.holes]


def main() -> None:
    """A line as it comes, a line cured."""
    import recipes
    from sheetmorph import Session, _core

    data = recipes.data_folder()
    if data is None:
        print(recipes.ABSENT)
        return
    for title, keys in (("as it comes", METRES), ("cured", CURES)):
        recipe = stainless_plate(data, keys)
        meshes = read_meshes(recipe["parts"], data)
        result = Session(recipe, meshes).deform()
        (part,) = result.report()["parts"]
        moved = _core.TriangleMesh(result.positions[NAME], meshes[NAME].triangles)
        crossing = len(_core.self_intersections(moved))
        print(f"{title}: {len(recipe['features'])} holes, {crossing} pairs of triangles cross")
        print(f"  thin: {part['thin']}\n  quality: {part['quality']}")

    print_convergence(data)


def print_convergence(data: Path) -> None:
    """How far finer meshes, and the open sheet in its middle, are apart; percent of the largest
    displacement."""
    meshes = {}
    for edge in (16.0, 8.0, 4.0):
        part = {"name": NAME, "file": str(data / FILE), **CURES, "remesh": {"edge": edge}}
        meshes[edge] = read_meshes([part], data)[NAME]
    for bend in (Bend(BEND), Bend(BEND, TWIST), Bend(BEND, TWIST, "natural")):
        for edge in (16.0, 8.0):
            changes = halving_changes(meshes[edge], meshes[edge / 2.0], bend)
            told = ", ".join(f"{name} {100.0 * share:.2g} %" for name, share in changes.items())
            print(f"{bend}: {edge:g} mm to {edge / 2.0:g} mm: {told}")


if __name__ == "__main__":
    main()
