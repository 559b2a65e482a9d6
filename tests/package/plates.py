# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plate with round holes, made in code: mesh, regions, and files of it in every format."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

FORMATS = ("obj", "off", "ascii.ply", "binary.ply", "nas", "large.nas", "ascii.stl", "binary.stl",
           "vtk", "vtu")  # fmt: skip


@dataclass
class Plate:
    """points (n, 3) mm, triangles (m, 3); indices of the left and right edges and of hole rims."""

    points: np.ndarray
    triangles: np.ndarray
    left: list[int]
    right: list[int]
    rims: list[list[int]] = field(default_factory=list)


def plate(holes: int = 3, cells: int = 6, scale: float = 1.0, start: float = 0.5) -> Plate:
    """A strip of square cells 20 mm wide in a row, a round hole in the middle of each.

    Each cell is a ring of quads between the circle and the square, cut into triangles. The first
    is `start` steps round; from 0, with even `cells`, the squares have their corners.
    """
    around = 4 * cells
    angles = 2.0 * np.pi * (np.arange(around) + start) / around
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    square = 10.0 * circle / np.abs(circle).max(axis=1)[:, None]
    points: list[tuple[float, float, float]] = []
    triangles, rims = [], []
    for hole in range(holes):
        shift = np.array([20.0 * hole, 0.0])
        rings = []
        for share in (0.0, 0.3, 0.65, 1.0):
            places = (1.0 - share) * 4.0 * circle + share * square + shift
            rings.append(_indices(points, places))
        rims.append(rings[0])
        for inner, outer in zip(rings, rings[1:]):
            for k in range(around):
                j = (k + 1) % around
                triangles += [[inner[k], outer[k], outer[j]], [inner[k], outer[j], inner[j]]]
    array = np.array(points)
    left = np.flatnonzero(array[:, 0] < -9.99).tolist()
    right = np.flatnonzero(array[:, 0] > 20.0 * holes - 10.01).tolist()
    return Plate(array * scale, np.array(triangles, dtype=np.int32), left, right, rims)


def _indices(points: list[tuple[float, float, float]], places: np.ndarray) -> list[int]:
    """Indices of plane places in `points`; new ones are added, equal ones shared."""
    found = []
    for x, y in np.round(places, 9).tolist():
        place = (x, y, 0.0)
        if abs(abs(y) - 10.0) < 1e-6 or abs((x + 10.0) % 20.0) < 1e-6:
            if place in points:
                found.append(points.index(place))
                continue
        points.append(place)
        found.append(len(points) - 1)
    return found


def write_plate(part: Plate, path: Path, kind: str) -> Path:
    """Write a plate in one of FORMATS; returns the path. Node ids of a deck are 101 + index."""
    writer = {"obj": _obj, "off": _off, "ascii.ply": _ply, "nas": _nas, "ascii.stl": _stl}
    binary = {"binary.ply": _binary_ply, "binary.stl": _binary_stl, "large.nas": _large_nas}
    if kind in ("vtk", "vtu"):
        import meshio

        meshio.Mesh(part.points, [("triangle", part.triangles)]).write(path)
    else:
        path.write_bytes((writer | binary)[kind](part))
    return path


def _rows(array: np.ndarray, form: str) -> str:
    return "".join(form.format(*row) for row in array.tolist())


def _obj(part: Plate) -> bytes:
    text = _rows(part.points, "v {} {} {}\n") + _rows(part.triangles + 1, "f {} {} {}\n")
    return f"# a plate\n{text}".encode()


def _off(part: Plate) -> bytes:
    counts = f"{len(part.points)} {len(part.triangles)} 0\n"
    body = _rows(part.points, "{} {} {}\n") + _rows(part.triangles, "3 {} {} {}\n")
    return f"OFF\n{counts}{body}".encode()


def _ply_head(part: Plate, form: str, kind: str) -> str:
    numbers = "".join(f"property {kind} {axis}\n" for axis in "xyz")
    return (
        f"ply\nformat {form} 1.0\nelement vertex {len(part.points)}\n{numbers}"
        f"element face {len(part.triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )


def _ply(part: Plate) -> bytes:
    body = _rows(part.points, "{} {} {}\n") + _rows(part.triangles, "3 {} {} {}\n")
    return (_ply_head(part, "ascii", "double") + body).encode()


def _binary_ply(part: Plate) -> bytes:
    faces = b"".join(struct.pack("<B3i", 3, *row) for row in part.triangles.tolist())
    head = _ply_head(part, "binary_little_endian", "float").encode()
    return head + part.points.astype("<f4").tobytes() + faces


def _nas(part: Plate, grid: str = "GRID    {:<16}{:<8.4f}{:<8.4f}{:<8.4f}\n") -> bytes:
    nodes = "".join(grid.format(101 + k, *row) for k, row in enumerate(part.points.tolist()))
    shells = "".join(
        "CTRIA3  {:<8}1       {:<8}{:<8}{:<8}\n".format(k + 1, *row)
        for k, row in enumerate((part.triangles + 101).tolist())
    )
    return f"SOL 101\nCEND\nBEGIN BULK\n{nodes}{shells}ENDDATA\n".encode()


def _large_nas(part: Plate) -> bytes:
    return _nas(part, "GRID*   {:<32}{:<16.10f}{:<16.10f}*\n*       {:<16.10f}\n")


def _stl(part: Plate) -> bytes:
    facet = "facet normal 0 0 1\nouter loop\n" + "vertex {} {} {}\n" * 3 + "endloop\nendfacet\n"
    facets = _rows(part.points[part.triangles].reshape(-1, 9), facet)
    return f"solid plate\n{facets}endsolid plate\n".encode()


def _binary_stl(part: Plate) -> bytes:
    corners = part.points[part.triangles].reshape(-1, 9).tolist()
    body = b"".join(struct.pack("<12fH", 0, 0, 1, *row, 0) for row in corners)
    return b"plate".ljust(80) + struct.pack("<I", len(corners)) + body


def recipe_of(part: Plate, name: str, ids: np.ndarray | None = None) -> dict:
    """A recipe that holds the left edge, lifts and turns the right one and keeps the holes."""

    def own(indices: list[int]) -> list[int]:
        return [int(i if ids is None else ids[i]) for i in indices]

    return {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": name}],
        "fixed": [{"part": "plate", "vertices": own(part.left)}],
        "handles": [{"name": "tip", "part": "plate", "vertices": own(part.right)}],
        "features": [
            {"name": f"hole{k}", "part": "plate", "vertices": own(rim)}
            for k, rim in enumerate(part.rims)
        ],
        "pose": {
            "tip": {
                "translation": [0.0, 0.0, 12.0],
                "rotation": {"axis": [0, 1, 0], "degrees": -25},
            }
        },
    }


def save_recipe(recipe: dict, folder: Path) -> Path:
    """Write a recipe as recipe.json."""
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe))
    return path
