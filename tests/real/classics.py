# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshes on which deformation methods are compared: one end is fixed, the other moves."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from selection import read_meshes, region

FOLDER = "07-deformation-classics"
TURNS = {"bar": 60.0, "cylinder": 90.0, "bumpy_plane": 50.0}
"""Degrees by which one end turns against the other, so that the whole bends along an arc."""


def classic(data: Path, name: str) -> dict:
    """One of the meshes, ends taken along its longest direction (the last of equal ones)."""
    entry = {"name": name, "file": str(data / FOLDER / f"{name}.off")}
    meshes = read_meshes([entry], data)
    points = meshes[name].points
    extent = np.ptp(points, axis=0)
    along = int(np.flatnonzero(extent > 0.999 * extent.max())[-1])
    side = int(extent.argmin())
    place = (points[:, along] - points[:, along].min()) / extent[along]
    # The ends of an arc as long as the mesh: the moved end's shift aside and along.
    angle = np.radians(TURNS[name])
    shift = np.zeros(3)
    shift[side] = extent[along] * (1.0 - np.cos(angle)) / angle
    shift[along] = extent[along] * (np.sin(angle) / angle - 1.0)
    turn = np.cross(np.eye(3)[along], np.eye(3)[side])
    return {
        "sheetmorph": 1,
        "parts": [entry],
        "fixed": [region(meshes, name, place < 0.05, name="fixed end")],
        "handles": [region(meshes, name, place > 0.95, name="moved end")],
        "pose": {
            "moved end": {
                "translation": shift.tolist(),
                "rotation": {"axis": turn.tolist(), "degrees": TURNS[name]},
            }
        },
    }
