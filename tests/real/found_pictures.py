# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what is found on the public assemblies: the pictures of finding.md.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/real/found_pictures.py FOLDER [NAME...]

Rims and walls of holes in colours of their kinds, contacts in blue, through the sheet in front of
them; needs python3-matplotlib and the data beside the repository.
"""

from __future__ import annotations

import colorsys
import os
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

from sheetmorph.finding import FindOptions, find_in_files, parts_of_files  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("SHEETMORPH_SHARED", REPOSITORY.parent / "shared")) / "data"
COLOURS = {
    "round hole": (0.10, 0.62, 0.34),
    "slotted hole": (0.95, 0.55, 0.10),
    "rectangular hole": (0.62, 0.30, 0.75),
    "contact": (0.16, 0.42, 0.85),
}
# Files, the direction one looks in, parts left out.
JOBS = {
    "found-support": (
        ["01-riveted-oxygen-bottle-support/W1000BOstat.dat"], (-1.0, 1.2, 0.9), ()
    ),
    "found-wing": (
        [f"04-f1-rear-wing/f1_rw_{n}.stl" for n in ("end_plates", "main_plane", "drs")],
        (-1.0, 0.8, -0.5), (),
    ),
    "found-enclosure": (["03-laser4diy-enclosure/Enclosure_v3_v9.step"], (-0.8, 1.0, -0.7), ()),
    "found-covers": (["05-robotnik-summit-stl/summit_xl_covers.stl"], (-0.5, 1.0, -0.4), ()),
}  # fmt: skip


def draw(name: str, folder: Path) -> str:
    """Draws one assembly; returns what was found, in words."""
    files, direction, left_out = JOBS[name]
    paths = [DATA / file for file in files]
    found = find_in_files(paths, FindOptions())
    meshes = {n: m for n, m in parts_of_files(paths).meshes.items() if n not in left_out}
    painted = _painted(found, meshes)
    triangles, colours = [], []
    for number, (part, mesh) in enumerate(meshes.items()):
        base = np.array(colorsys.hsv_to_rgb(0.58 + 0.07 * (number % 5), 0.06, 0.86))
        triangles.append(np.asarray(mesh.points)[mesh.triangles])
        colours.append(np.where(painted[part] < 0, base, painted[part]))
    _plot((np.vstack(triangles), np.vstack(colours)), _rims(found, meshes), direction)
    plt.savefig(folder / f"{name}.png", bbox_inches="tight", pad_inches=0.05)
    plt.close()
    kinds = [entry["kind"] for entry in found["features"]]
    counts = ", ".join(f"{kinds.count(kind)} {kind}s" for kind in COLOURS if kind in kinds)
    return f"{name}: {len(meshes)} parts, {counts}; {len(found['contacts'])} contacts"


def _painted(found: dict, meshes: dict) -> dict[str, np.ndarray]:
    """(m, 3) colours of triangles by part, -1 where there is none."""
    colours = {part: np.full((len(mesh.triangles), 3), -1.0) for part, mesh in meshes.items()}
    places = [("contact", entry[side]) for entry in found["contacts"] for side in "ab"]
    for entry in found["features"]:
        if entry["kind"] in COLOURS:
            places.append((entry["kind"], entry))
    for kind, place in places:
        if place["part"] in colours:
            mesh = meshes[place["part"]]
            chosen = np.isin(mesh.triangles, mesh.find(place["vertices"])[0]).all(axis=1)
            colours[place["part"]][chosen] = COLOURS[kind]
    return colours


def _rims(found: dict, meshes: dict) -> list[tuple[np.ndarray, tuple]]:
    """((k, 2, 3) edges, colour) of every rim."""
    rims = []
    for entry in found["features"]:
        for rim in entry.get("rims", ()) if entry["kind"] in COLOURS else ():
            mesh = meshes[entry["part"]]
            points = np.asarray(mesh.points)[mesh.find(rim)[0]]
            rims.append(
                (np.stack([points, np.roll(points, -1, axis=0)], 1), COLOURS[entry["kind"]])
            )
    return rims


def _plot(surface: tuple, rims: list, direction) -> None:
    """Seen in a direction, parallel, what is far first; what is marked a little before the rest."""
    triangles, colours = surface
    look = np.array(direction) / np.linalg.norm(direction)
    right = np.cross(look, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    up = np.cross(right, look)
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normals, axis=1)
    keep = length > 0.0
    normals = normals[keep] / length[keep, None]
    light = 0.55 + 0.45 * np.abs(normals @ (0.8 * look + 0.35 * right - 0.5 * up))
    shown = np.clip(colours[keep] * np.minimum(light, 1.0)[:, None], 0.0, 1.0)
    corners = triangles[keep]
    flat = np.stack([corners @ right, corners @ up], axis=-1)
    nearer = 0.012 * np.linalg.norm(np.ptp(flat.reshape(-1, 2), axis=0))
    is_marked = np.ptp(colours[keep], axis=1) > 0.3
    depth = corners.mean(axis=1) @ look - nearer * is_marked
    shapes, paints, depths = list(flat), list(shown), depth.tolist()
    widths = [0.15] * len(shapes)
    for edges, colour in rims:
        shapes += list(np.stack([edges @ right, edges @ up], axis=-1))
        depths += (edges.mean(axis=1) @ look - nearer).tolist()
        paints += [np.array(colour)] * len(edges)
        widths += [1.3] * len(edges)
    order = np.argsort(-np.array(depths), kind="stable")
    paint, width = np.array(paints)[order], np.array(widths)[order]
    _, axes = plt.subplots(figsize=(9, 6), dpi=170)
    ordered = [shapes[k] for k in order]
    axes.add_collection(
        PolyCollection(ordered, facecolors=paint, edgecolors=paint, linewidths=width)
    )
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.axis("off")


def main(folder: Path, names: list[str]) -> None:
    """Draws the pictures with these names, all if there are none."""
    for name in names or JOBS:
        print(draw(name, folder), flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
