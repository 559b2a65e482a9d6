# SPDX-License-Identifier: LGPL-2.1-or-later
"""The classic meshes bent by SheetMorph and by CGAL's smooth ARAP: against_cgal.py SHARED_DATA OUT

A patch in the middle of each mesh is a form feature of ours; CGAL has no rigid features. Prints
bending (squared change of dihedral angles), worst feature edge (mm), smallest angle (degrees);
writes both shapes as OBJ files into OUT.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np

import sheetmorph
from classics import FOLDER, TURNS, classic
from selection import read_meshes

FLAGS = ("-std=c++17", "-O3", "-DNDEBUG", "-isystem", "/usr/include/eigen3")


def bending(points: np.ndarray, rest: np.ndarray, triangles: np.ndarray) -> float:
    """Sum over inner edges of the squared change of the dihedral angle, rad^2."""

    def angles(at: np.ndarray) -> np.ndarray:
        normals = np.cross(
            at[triangles[:, 1]] - at[triangles[:, 0]], at[triangles[:, 2]] - at[triangles[:, 0]]
        )
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        one, other = normals[pairs[:, 0]], normals[pairs[:, 1]]
        along = at[ends[:, 1]] - at[ends[:, 0]]
        along /= np.linalg.norm(along, axis=1)[:, None]
        sine = np.einsum("ij,ij->i", np.cross(one, other), along)
        return np.arctan2(sine, np.einsum("ij,ij->i", one, other))

    uses: dict[tuple[int, int], list[int]] = {}
    for t, triangle in enumerate(triangles):
        for k in range(3):
            a, b = int(triangle[k]), int(triangle[(k + 1) % 3])
            uses.setdefault((min(a, b), max(a, b)), []).append(t)
    inner = [(edge, sides) for edge, sides in uses.items() if len(sides) == 2]
    ends = np.array([edge for edge, _ in inner])
    pairs = np.array([sides for _, sides in inner])
    change = angles(points) - angles(rest)
    change = (change + np.pi) % (2.0 * np.pi) - np.pi
    return float((change**2).sum())


def smallest_angle(points: np.ndarray, triangles: np.ndarray) -> float:
    """Degrees."""
    worst = 180.0
    for k in range(3):
        a = points[triangles[:, (k + 1) % 3]] - points[triangles[:, k]]
        b = points[triangles[:, (k + 2) % 3]] - points[triangles[:, k]]
        cosine = np.einsum("ij,ij->i", a, b) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
        worst = min(worst, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).min()))
    return worst


def feature_error(points: np.ndarray, rest: np.ndarray, ids: np.ndarray) -> float:
    """Largest change of the distance of two vertices of the feature, mm."""

    def distances(at: np.ndarray) -> np.ndarray:
        return np.linalg.norm(at[ids][:, None] - at[ids][None], axis=2)

    return float(np.abs(distances(points) - distances(rest)).max())


def compared(name: str, data: Path, out: Path) -> None:
    """One mesh: both answers, their figures, their shapes."""
    recipe = classic(data, name)
    mesh = read_meshes(recipe["parts"], data)[name]
    rest, triangles = np.asarray(mesh.points), np.asarray(mesh.triangles)
    extent = np.ptp(rest, axis=0)
    nearest = np.argsort(np.linalg.norm(rest - rest.mean(axis=0), axis=1))[0]
    patch = np.flatnonzero(np.linalg.norm(rest - rest[nearest], axis=1) < 0.06 * extent.max())
    recipe["features"] = [{"name": "patch", "part": name, "vertices": patch.tolist()}]
    ours = np.asarray(sheetmorph.Session(recipe, {name: mesh}).deform().positions[name])
    known = recipe["fixed"][0]["vertices"] + recipe["handles"][0]["vertices"]
    targets, answer = out / f"{name}.targets", out / f"{name}.xyz"
    targets.write_text("".join("%d %.17g %.17g %.17g\n" % (i, *ours[i]) for i in known))
    off = data / FOLDER / f"{name}.off"
    subprocess.run([str(out / "cgal_answer"), str(off), str(targets), str(answer)], check=True)
    theirs = np.loadtxt(answer)
    for label, shape in (("SheetMorph", ours), ("CGAL SRE_ARAP", theirs)):
        print(
            f"| {name} | {label} | {bending(shape, rest, triangles):.3g} "
            f"| {feature_error(shape, rest, patch):.1e} | {smallest_angle(shape, triangles):.1f} |"
        )
        lines = ["v %.9g %.9g %.9g\n" % tuple(p) for p in shape]
        lines += ["f %d %d %d\n" % tuple(t + 1) for t in triangles]
        (out / f"{name}-{label.split()[0].lower()}.obj").write_text("".join(lines))


def main(data: Path, out: Path) -> None:
    """The table, a row a mesh and method."""
    out.mkdir(parents=True, exist_ok=True)
    source = Path(__file__).with_name("cgal_answer.cpp")
    subprocess.run(
        ["g++", *FLAGS, str(source), "-o", str(out / "cgal_answer"), "-lgmp", "-lmpfr"], check=True
    )
    print("| mesh | method | bending | feature error, mm | smallest angle |\n|---|---|---|---|---|")
    for name in TURNS:
        compared(name, data, out)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
