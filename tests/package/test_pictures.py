# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures without a display: what they show, and what is said where none can be drawn."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import sheetmorph
from sheetmorph.cli import main
from sheetmorph.recipe.reading import read_json
from sheetmorph.pictures import (
    Arrow,
    Painter,
    PictureError,
    Scene,
    Sheet,
    before_and_after,
    draw,
    drawing,
    drawn,
)
from sheetmorph.pictures.scene import ROLES

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
HALVES = np.array([[0, 1, 2], [0, 2, 3]])


def pixels(path: Path) -> np.ndarray:
    """(height, width, channels) of a PNG, as VTK reads it."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def share_near(picture: np.ndarray, colour: tuple[float, float, float], within: int = 60) -> float:
    """The share of pixels that look like a colour."""
    apart = np.abs(picture[..., :3].astype(int) - (255 * np.array(colour)).astype(int))
    return float((apart.max(axis=2) < within).mean())


def test_a_scene_shows_its_sheets_marks_and_arrows(tmp_path: Path):
    red, blue = (0.9, 0.1, 0.1), (0.1, 0.1, 0.9)
    marked = [Sheet(SQUARE, HALVES[1:]), Sheet(SQUARE, HALVES[:1], red)]
    arrow = Arrow((0.5, 0.5, 0.0), (0.5, 0.5, 0.8), blue)
    first = Scene(marked, [arrow], "a title", {"red": red}, size=(320, 240), view=(0, 0, 1))
    second = Scene([Sheet(SQUARE, HALVES)], size=(320, 240), view=(0, 0, 1))
    draw([(first, tmp_path / "first.png"), (second, tmp_path / "second.png")])
    seen, plain = pixels(tmp_path / "first.png"), pixels(tmp_path / "second.png")
    assert seen.shape[:2] == (240, 320)
    # The square is as high as the picture without margin and room for texts; half of it is red.
    side = (240 - 2 * 56) / 1.12
    assert share_near(seen, red) == pytest.approx(0.5 * side**2 / (240 * 320), abs=0.02)
    assert share_near(plain, red) == 0.0


def test_an_arrow_hides_behind_no_sheet(tmp_path: Path):
    blue = (0.1, 0.1, 0.9)
    arrows = [Arrow((0.2, 0.5, -20.0), (0.8, 0.5, -20.0), blue)]
    arrows.append(Arrow((0.2, 0.8, 30.0), (0.8, 0.8, 30.0), blue))
    plain = Scene([Sheet(SQUARE, HALVES)], size=(320, 240), view=(0, 0, 1))
    shown = {"behind": arrows[:1], "both": arrows}
    draw([(replace(plain, arrows=those), tmp_path / name) for name, those in shown.items()])
    behind, both = (share_near(pixels(tmp_path / name), blue, 90) for name in shown)
    assert behind > 0.002 and both > 1.5 * behind


def test_no_picture_appears_where_none_can_be_drawn(tmp_path: Path, monkeypatch):
    monkeypatch.setattr(drawing.shutil, "which", lambda _: None)
    with pytest.raises(PictureError, match="install xvfb"):
        draw([(Scene([Sheet(SQUARE, HALVES)]), tmp_path / "no.png")])
    assert list(tmp_path.iterdir()) == []


def test_a_driver_that_gives_up_is_one_sentence(tmp_path: Path, monkeypatch):
    (tmp_path / "bin").mkdir()
    screen = tmp_path / "bin" / "Xvfb"
    screen.write_text('#!/bin/sh\neval "echo 987 >&$2"\n')  # the number of no screen
    screen.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    # Since VTK 9.4 others take over where there is no screen, if they may.
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkXOpenGLRenderWindow")
    with pytest.raises(PictureError, match="VTK could not draw"):
        draw([(Scene([Sheet(SQUARE, HALVES)]), tmp_path / "no.png")])
    assert not (tmp_path / "no.png").exists()


def test_a_painter_draws_the_same_whatever_it_drew_before():
    plain = Scene([Sheet(SQUARE, HALVES)], size=(240, 180))
    arrow = Arrow((0.2, 0.5, 0.0), (0.8, 0.5, 9.0))
    other = Scene([], [arrow], "a title", {"red": (1.0, 0.0, 0.0)}, "height", size=(320, 240))
    assert drawn([plain, other, plain])[2] == drawn([plain])[0]


def test_colours_belong_to_faces_and_quads_have_no_diagonal(tmp_path: Path):
    quads = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 5, -1]])
    points = np.array([[x, y, 0.0] for y in (0.0, 1.0) for x in (0.0, 1.0, 2.0)])
    points[4, 1] = 0.9
    values = np.array([0.0, 1.0, 0.0])
    blue, red = (0.1, 0.1, 0.9), (0.9, 0.1, 0.1)
    sheet = Sheet(points, quads, values=values, is_by_face=True, has_edges=True)
    draw([(Scene([sheet], ramp=(blue, red), size=(320, 240), view=(0, 0, 1)), tmp_path / "a.png")])
    picture = pixels(tmp_path / "a.png")
    share = share_near(picture, red, 70) / share_near(picture, blue, 70)
    assert share == pytest.approx(0.95 / 1.05, abs=0.05)


def test_a_dead_painter_leaves_no_screen_behind():
    painter = Painter()
    painter.draw(Scene([Sheet(SQUARE, HALVES)], size=(240, 180)))
    (screen,) = children_of(painter.process.pid)
    painter.process.kill()
    with pytest.raises(PictureError, match="VTK could not draw"):
        painter.draw(Scene([Sheet(SQUARE, HALVES)], size=(240, 180)))
    painter.close()
    deadline = time.monotonic() + 60.0
    while is_alive(screen) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not is_alive(screen)


def children_of(process: int) -> list[int]:
    """The process ids of the children of a process."""
    return [
        int(pid) for pid in Path(f"/proc/{process}/task/{process}/children").read_text().split()
    ]


def is_alive(process: int) -> bool:
    """Whether a process runs; one that ended and has no parent to notice does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def test_show_draws_what_a_recipe_means(folder: Path, capsys):
    assert main(["show", "recipe.json", "-o", "rest.png", "--view", "0.1,-0.3,1"]) == 0
    picture = pixels(Path("rest.png"))
    for role in ("fixed", "handle", "form feature"):
        assert share_near(picture, ROLES[role]) > 1e-4, role
    assert main(["show", "recipe.json", "-o", "moved.png", "--after"]) == 0
    moved = pixels(Path("moved.png"))
    assert share_near(moved, ROLES["fixed"], 20) == 0.0
    assert main(["show", "recipe.json", "-o", "no.png", "--pose", "open"]) == 2
    assert 'there is no pose "open"' in capsys.readouterr().err
    assert not Path("no.png").exists()


def test_run_puts_pictures_beside_the_parts(folder: Path):
    assert main(["run", "recipe.json", "-o", "out", "--pictures"]) == 0
    assert sorted(path.name for path in Path("out").iterdir()) == [
        "after.png",
        "before.png",
        "plate.obj",
    ]
    assert not np.array_equal(pixels(Path("out/before.png")), pixels(Path("out/after.png")))


def test_before_and_after_are_seen_from_one_place_at_one_scale(folder: Path):
    recipe = read_json(folder / "recipe.json")
    meshes = {"plate": sheetmorph.read_part("plate.obj").mesh}
    scenes = before_and_after(sheetmorph.Session(recipe, meshes).deform())
    aslant = np.array([[0.8, 0.6, 0.3], [-0.5, 0.7, 0.9], [0.1, -0.4, 0.8]])
    seen = [all_places(scene) @ aslant for scene in scenes]
    assert np.ptp(seen[0], axis=0).tolist() == pytest.approx(np.ptp(seen[1], axis=0), abs=1e-12)
    assert seen[0].min(axis=0).tolist() == pytest.approx(seen[1].min(axis=0), abs=1e-12)


def all_places(scene: Scene) -> np.ndarray:
    """Of sheets and arrows: what a picture makes room for (n, 3)."""
    ends = [point for arrow in scene.arrows for point in (arrow.start, arrow.end)]
    return np.concatenate(
        [*(sheet.points for sheet in scene.sheets), *np.reshape(ends, (-1, 1, 3))]
    )
