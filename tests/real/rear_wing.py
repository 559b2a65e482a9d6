# SPDX-License-Identifier: LGPL-2.1-or-later
"""A racing car's rear wing: three STL files, two end plates in one of them, four butt contacts."""

from __future__ import annotations

from pathlib import Path

from selection import Touching, contacts, read_meshes, region

FOLDER = "04-f1-rear-wing"
PLATES = "f1_rw_end_plates"
LEFT = f"{PLATES}/1"
RIGHT = f"{PLATES}/2"
GAP = 0.1  # mm; the wings' tips lie in the faces of the end plates


def entries(data: Path) -> list[dict]:
    """The three files."""
    folder = data / FOLDER
    return [
        {"file": str(folder / f"{PLATES}.stl"), "split": True},
        {"name": "main plane", "file": str(folder / "f1_rw_main_plane.stl")},
        {"name": "flap", "file": str(folder / "f1_rw_drs.stl")},
    ]


def wing(data: Path, kind: str = "rigid") -> dict:
    """The whole wing: the feet stay, the top of one end plate moves 80 mm back and 40 up."""
    meshes = read_meshes(entries(data), data)
    left, right = meshes[LEFT].points[:, 2], meshes[RIGHT].points[:, 2]
    return {
        "sheetmorph": 1,
        "parts": entries(data),
        "primary": LEFT,
        "fixed": [
            region(meshes, LEFT, left < 60.0, name="left foot"),
            region(meshes, RIGHT, right < 60.0, name="right foot"),
        ],
        "handles": [region(meshes, LEFT, left > 640.0, name="top")],
        "contacts": contacts(meshes, Touching(GAP, kind)),
        "pose": {"top": {"translation": [-80.0, 0.0, 40.0]}},
    }


def end_plate_alone(data: Path) -> dict:
    """One end plate: its foot stays, its top moves out and turns."""
    recipe = wing(data)
    turn = {"axis": [1, 0, 0], "degrees": 20.0}
    return {
        **recipe,
        "parts": recipe["parts"][:1],
        "contacts": [],
        "fixed": recipe["fixed"][:1],
        "pose": {"top": {"translation": [0.0, -120.0, -20.0], "rotation": turn}},
    }
