# SPDX-License-Identifier: LGPL-2.1-or-later
"""`init` writes a recipe that `run` takes unchanged, also of plates with ribs, bosses and holes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from lumpy_plates import raised
from plates import Plate, write_plate
from sheet_meshes import circle, flat, inside, polygon
from sheetmorph.cli import main
from sheetmorph.recipe.reading import read_json

STEP = 5.0


def rectangle(x: float, y: float, length: float, width: float) -> np.ndarray:
    """A closed rectangle around a place."""
    sides = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (length / 2, width / 2)
    return polygon((x, y) + sides, STEP)


def random_plate(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles of a plate 2 mm thick with a rib along it, a boss and holes."""
    rng = np.random.default_rng(seed)
    length, width = rng.uniform(100, 160), rng.uniform(50, 80)
    outline = polygon([(0, 0), (length, 0), (length, width), (0, width)], STEP)
    reach = rng.choice([0.5, 0.94, 0.97])  # of the length: the last two touch both ends
    rib = rectangle(length / 2, width * 0.5, reach * length, 6.0)
    boss = circle((length * 0.3, width * 0.82), 5.0, 16)
    holes = [
        circle((length * x, width * 0.2), 4.0, 16) for x in rng.uniform((0.2, 0.6), (0.4, 0.8))
    ]
    places, triangles = flat(outline, holes, STEP, [rib, boss])
    rise = np.zeros(len(triangles))
    for loop, height in ((rib, 10.0), (boss, 8.0)):
        rise[inside(loop, places[triangles].mean(axis=1))] = height
    points, faces = raised(places, triangles, rise)
    turn = np.roll(np.eye(3), seed % 3, axis=0)
    return points @ turn.T, faces


@pytest.mark.parametrize("seed", range(6))
def test_init_and_run_take_plates_with_ribs_and_bosses(seed: int, tmp_path: Path, capsys):
    points, triangles = random_plate(seed)
    plate = Plate(points, triangles, [], [])
    write_plate(plate, tmp_path / "plate.obj", "obj")
    recipe = tmp_path / ("recipe.toml" if seed % 2 else "recipe.json")
    assert main(["init", str(tmp_path / "plate.obj"), "-o", str(recipe), "--quiet"]) == 0
    assert (
        main(["run", str(recipe), "-o", str(tmp_path / "out"), "--quiet"]) == 0
    ), capsys.readouterr().err


def test_a_recipe_in_toml_says_the_same_as_one_in_json(tmp_path: Path):
    points, triangles = random_plate(0)
    write_plate(Plate(points, triangles, [], []), tmp_path / 'a "b".obj', "obj")
    for name in ("r.json", "r.toml"):
        wanted = ["init", str(tmp_path / 'a "b".obj'), "-o", str(tmp_path / name), "--quiet"]
        assert main(wanted) == 0
    assert read_json(tmp_path / "r.toml") == read_json(tmp_path / "r.json")
    assert (tmp_path / "r.toml").read_text().startswith("# `init` found this")
