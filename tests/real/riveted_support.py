# SPDX-License-Identifier: LGPL-2.1-or-later
"""A riveted aluminium support of 12 meshes in one Nastran deck, with 16 round holes."""

from __future__ import annotations

from pathlib import Path

from selection import Meshes, Touching, contacts, read_meshes, region, round_holes

DECK = "01-riveted-oxygen-bottle-support/W1000BOstat.dat"
SHELF = "W1000BOstat/1"
BRACKET = "W1000BOstat/10"
GAP = 1.1  # mm; the deck's gaps between riveted flanges go up to 1.05 mm


def support(data: Path, kind: str = "tied") -> dict:
    """The whole support: one end of the shelf stays, the other is lifted 60 mm and turned."""
    entries = [{"file": str(data / DECK), "split": True}]
    meshes = read_meshes(entries, data)
    x = meshes[SHELF].points[:, 0]
    return {
        "sheetmorph": 1,
        "parts": entries,
        "primary": SHELF,
        "fixed": [region(meshes, SHELF, x < 2885.0, name="left end")],
        "handles": [region(meshes, SHELF, x > 3485.0, name="right end")],
        "features": round_holes(meshes),
        "contacts": contacts(meshes, Touching(GAP, kind, smallest=1)),
        "pose": {"right end": lifted(60.0, -8.0)},
    }


def shelf_alone(data: Path) -> dict:
    """The shelf with its 13 holes: one end stays, the other is twisted and lifted."""
    meshes = one_of_the_deck(data, SHELF)
    x = meshes[SHELF].points[:, 0]
    recipe = alone(data, meshes, SHELF)
    recipe["fixed"] = [region(meshes, SHELF, x < 2885.0, name="left end")]
    recipe["handles"] = [region(meshes, SHELF, x > 3485.0, name="right end")]
    recipe["pose"] = {"right end": lifted(40.0, 20.0, (1, 0, 0))}
    return recipe


def bracket_alone(data: Path) -> dict:
    """A bracket with 3 holes: one end is pulled aside 30 mm."""
    meshes = one_of_the_deck(data, BRACKET)
    y = meshes[BRACKET].points[:, 1]
    recipe = alone(data, meshes, BRACKET)
    recipe["fixed"] = [region(meshes, BRACKET, y > -1070.0, name="back")]
    recipe["handles"] = [region(meshes, BRACKET, y < -1325.0, name="front")]
    recipe["pose"] = {"front": lifted(30.0, 10.0, (1, 0, 0))}
    return recipe


def one_of_the_deck(data: Path, part: str) -> Meshes:
    """One of the deck's 12 meshes."""
    return {part: read_meshes([{"file": str(data / DECK), "split": True}], data)[part]}


def alone(data: Path, meshes: Meshes, part: str) -> dict:
    """A recipe of the deck whose primary is one part; no contact leads to the others."""
    return {
        "sheetmorph": 1,
        "parts": [{"file": str(data / DECK), "split": True}],
        "primary": part,
        "features": round_holes(meshes),
    }


def lifted(height: float, degrees: float, axis: tuple = (0, 1, 0)) -> dict:
    """A handle's motion: up by mm, turned about an axis."""
    turn = {"axis": list(axis), "degrees": degrees}
    return {"translation": [0.0, 0.0, height], "rotation": turn}
