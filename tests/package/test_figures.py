# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures drawn on the screen, and what they take; neither needs FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools import figures, sentences
from freecad.sheetmorph.tools.figures import BRUSH, LASSO, RECTANGLE, Camera, Drawing
from freecad.sheetmorph.tools.part_mesh import PartMesh, nearest_part
from freecad.sheetmorph.tools.picking import ADD, REMOVE, REPLACE, VERTEX, Options, RegionPicker
from freecad.sheetmorph.tools.rims import Ray
from freecad.sheetmorph.tools.sentences import DrawnFigure
from freecad.sheetmorph.tools.shortening import farthest, shortened
from sheetmorph import _core

FROM_ABOVE = Camera(np.diag([0.1, 0.1, -0.01, 1.0]), 200.0, 200.0)  # 10 px are 1 mm


def square(height: float = 0.0, count: int = 11) -> PartMesh:
    """A square of 10 mm about the z axis, a vertex at every mm."""
    steps = np.linspace(-5.0, 5.0, count)
    x, y = (g.ravel() for g in np.meshgrid(steps, steps, indexing="ij"))
    points = np.stack([x, y, np.full(x.size, height)], axis=1)
    first = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    a, b, c, d = first, first + count, first + count + 1, first + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)
    return PartMesh(_core, (points, triangles), points)


def area(outline: np.ndarray) -> float:
    """The area, px^2, of a figure that does not cross itself."""
    x, y = outline.T
    return abs(float(x @ np.roll(y, 1) - y @ np.roll(x, 1))) / 2


def test_a_part_beside_a_figure_hides_nothing_and_builds_no_tree():
    part, lid, beside = square(), square(5.0), square(5.0)
    beside = PartMesh(_core, (beside._seen, beside.triangles), beside._seen + (40.0, 0.0, 0.0))
    whole = figures.rectangle((0.0, 0.0), (200.0, 200.0))
    assert len(part.inside(FROM_ABOVE, whole, [part, beside])) == 121
    assert "_tree" not in vars(beside)
    assert len(part.inside(FROM_ABOVE, whole, [part, beside, lid])) == 0


def test_what_may_be_seen_around_a_figure_is_told_from_a_box():
    rng = np.random.default_rng(2)
    clip = np.array([[1.2, 0, 0, 0], [0, 1.6, 0, 0], [0, 0, -1.02, 2], [0, 0, -1.0, 40.0]])
    camera = Camera(clip, 300.0, 200.0)
    for _ in range(200):
        points = rng.uniform(-30, 30, 3) + rng.uniform(-6, 6, (20, 3))
        seen = np.column_stack([points, np.ones(20)]) @ clip.T
        places = 0.5 * (1.0 + seen[:, :2] / seen[:, 3:]) * (300.0, 200.0)
        corner = rng.uniform(0, 250, 2)
        figure = figures.rectangle(tuple(corner), tuple(corner + 30.0))
        inside = (places >= corner) & (places <= corner + 30.0) & (seen[:, 3:] > 0)
        may = camera.may_show(points.min(axis=0), points.max(axis=0), figure)
        assert may or not inside.all(axis=1).any()
    assert not camera.may_show(
        np.array([9.0, 9.0, 0.0]), np.full(3, 10.0), figures.circle((20, 20), 9)
    )


def test_a_swept_circle_covers_both_ends_and_what_is_between():
    figure = figures.swept((10.0, 20.0), (40.0, 60.0), 8.0)
    assert np.isclose(area(figure), 50 * 16 + np.pi * 64, rtol=0.01)
    assert np.allclose(figure.mean(axis=0), (25.0, 40.0))
    assert np.isclose(area(figures.circle((3.0, 4.0), 5.0)), np.pi * 25, rtol=0.01)


def test_the_wheel_changes_the_radius_within_limits():
    assert figures.resized(20.0, 1.0) > 20.0 > figures.resized(20.0, -1.0)
    assert figures.resized(20.0, 99.0) == figures.LARGEST
    assert figures.resized(20.0, -99.0) == figures.SMALLEST


def test_a_rectangle_lies_between_opposite_corners_whichever_way():
    drawing = Drawing(RECTANGLE, (30.0, 40.0))
    assert not drawing.has_extent
    drawing.go_to((10.0, 90.0))
    assert drawing.has_extent and area(drawing.outline()) == 20 * 50


def test_a_lasso_keeps_its_corners_apart():
    drawing = Drawing(LASSO, (0.0, 0.0))
    for place in ((0.5, 0.0), (1.0, 0.5), (50.0, 0.0), (50.0, 50.0)):
        drawing.go_to(place)
    assert drawing.outline().tolist() == [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]]


def test_a_brush_goes_on_from_where_it_was():
    drawing = Drawing(BRUSH, (0.0, 0.0), 4.0)
    assert drawing.has_extent
    drawing.go_to((10.0, 0.0))
    step = drawing.go_to((10.0, 30.0))
    assert step[:, 0].min() >= 6.0 - 1e-9 and step[:, 1].max() == pytest.approx(34.0)
    assert drawing.outline()[:, 1].max() == pytest.approx(34.0)


def test_a_line_of_sight_goes_through_what_the_pixel_shows():
    near, far = FROM_ABOVE.line(130.0, 90.0)
    assert np.allclose(near, [3.0, -1.0, 100.0]) and np.allclose(far, [3.0, -1.0, -100.0])


def test_a_figure_takes_what_is_seen_in_it_or_what_lies_behind_too():
    low, lid = square(), square(2.0, 3)
    picker = RegionPicker(low, others=[lid])
    box = figures.rectangle((45.0, 45.0), (75.0, 65.0))
    assert len(picker.aim_inside(FROM_ABOVE, box)) == 0
    picker.choose(through=True)
    assert len(picker.aim_inside(FROM_ABOVE, box)) == 6
    assert len(RegionPicker(low).aim_inside(FROM_ABOVE, box)) == 6


def test_a_part_in_front_takes_the_click_away_unless_it_goes_through():
    picker = RegionPicker(square(), options=Options(what=VERTEX), others=[square(2.0)])
    ray = Ray(np.array([0.2, 0.1, 50.0]), np.array([0.0, 0.0, -1.0]))
    assert not picker.click(ray)
    assert len(picker.aim(Ray(-ray.origin, -ray.direction))), "from below nothing is in front"
    picker.choose(through=True)
    assert picker.click(ray) and picker.picked.tolist() == [60]


def test_a_stroke_is_one_pick_that_can_be_taken_back():
    picker = RegionPicker(square(), [0])
    picker.choose(what=BRUSH)
    assert picker.mode(shift=False, control=False) == ADD
    assert picker.mode(shift=False, control=True) == REMOVE
    for x in (100.0, 110.0, 120.0):
        stroke = picker.paint(FROM_ABOVE, figures.circle((x, 100.0), 4.0))
    assert len(stroke) == 3
    assert picker.take_painted(ADD) and len(picker.picked) == 4
    assert picker.back() and picker.picked.tolist() == [0] and not picker.back()
    picker.paint(FROM_ABOVE, figures.circle((900.0, 100.0), 4.0))
    assert not picker.take_painted(REPLACE), "an empty stroke changes nothing"


def test_the_chosen_mode_holds_without_keys():
    picker = RegionPicker(square(), options=Options(mode=REMOVE))
    assert picker.mode(shift=False, control=False) == REMOVE
    assert picker.mode(shift=True, control=False) == ADD


def test_inverting_picks_the_rest(picked=(0, 5, 120)):
    picker = RegionPicker(square(), picked)
    assert picker.invert() and len(picker.picked) == 118
    assert picker.invert() and picker.picked.tolist() == list(picked)


def test_a_face_is_asked_for_once_while_the_mouse_stays_in_it():
    picker = RegionPicker(square())
    down = np.array([0.0, 0.0, -1.0])
    aimed = [picker.aim(Ray(np.array([x, 0.3, 50.0]), down)) for x in (-3.2, 2.1)]
    assert aimed[0] is aimed[1] and len(aimed[0]) == 121


def test_a_rim_of_a_closed_solid_ends_where_it_bends():
    angles = 2 * np.pi * np.arange(24) / 24
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(24)], axis=1)
    points = np.concatenate([5 * ring, 5 * ring + [0, 0, 4], [[0, 0, 0], [0, 0, 4]]])
    k, n = np.arange(24), (np.arange(24) + 1) % 24
    sides = np.concatenate([np.stack([k, n, n + 24], 1), np.stack([k, n + 24, k + 24], 1)])
    caps = [np.stack([n, k, 0 * k + 48], 1), np.stack([k + 24, n + 24, 0 * k + 49], 1)]
    mesh = PartMesh(_core, (points, np.concatenate([sides, *caps]).astype(np.int32)), points)
    ray = Ray(np.array([4.5, 0.2, 50.0]), np.array([0.0, 0.0, -1.0]))
    assert mesh.rim(ray, 0, crease=0.5).tolist() == list(range(24, 48))
    assert len(mesh.rim(ray, 0, crease=2.0)) == 0, "an edge of 90 degrees is none then"


def test_the_part_in_front_is_named():
    meshes = {"low": square(), "high": square(2.0)}
    assert nearest_part(meshes, Ray(np.array([0.1, 0.2, 9.0]), np.array([0.0, 0, -1]))) == "high"
    assert nearest_part(meshes, Ray(np.array([90.0, 0, 9]), np.array([0.0, 0, -1]))) == ""
    assert nearest_part({}, Ray(np.zeros(3), np.array([0.0, 0, 1]))) == ""


def drawn_around(radius: float, waves: int, tool: str = LASSO) -> dict:
    """A wavy figure around the middle of the square, as a mouse draws it."""
    angle = np.linspace(0.0, 2.0 * np.pi, 90)
    reach = radius * (1.0 + 0.12 * np.sin(waves * angle))
    places = 100.0 + np.round(np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=1))
    places = figures.lasso(places.tolist()) if tool == LASSO else places
    return DrawnFigure(tool, places.tolist(), FROM_ABOVE.view, 9.0).said()


@pytest.mark.parametrize("radius, waves", [(20.0, 3), (33.0, 5), (45.0, 2), (47.0, 11)])
def test_a_lasso_with_fewer_places_passes_every_vertex_on_the_same_side(radius, waves):
    part, told = square(count=21), drawn_around(radius, waves)
    short = shortened({"minus": [told, told]}, part._seen, 6.0)["minus"][1]["drawn"]
    line, few = (np.array(one["lasso"], float).reshape(-1, 2) for one in (told["drawn"], short))
    assert len(few) < 0.6 * len(line)
    taken = [part.inside(FROM_ABOVE, figures.lasso(one), None).tolist() for one in (line, few)]
    assert taken[0] == taken[1] and len(taken[0]) > 20
    rows = [int(np.flatnonzero((line == corner).all(axis=1))[0]) for corner in few]
    gaps = [farthest(line, a, b) for a, b in zip(rows, rows[1:])]
    assert max(gaps) <= 6.0


def test_a_stroke_keeps_the_places_where_it_bends():
    stroke = drawn_around(40.0, 3, BRUSH)
    short = shortened(stroke, square()._seen, 3.0)["drawn"]
    line, few = (np.array(one["brush"], float).reshape(-1, 2) for one in (stroke["drawn"], short))
    assert 5 < len(few) < 40 and short["radius"] == 9.0
    assert (few[0] == line[0]).all() and (few[-1] == line[-1]).all()
    assert shortened(stroke, square()._seen, 0.0) == stroke


def turned(*degrees: float) -> np.ndarray:
    """A rotation about x, y and z, one after the other."""
    found = np.eye(3)
    for angle, (a, b) in zip(np.radians(degrees), ((1, 2), (2, 0), (0, 1))):
        turn = np.eye(3)
        turn[a, a] = turn[b, b] = np.cos(angle)
        turn[a, b], turn[b, a] = -np.sin(angle), np.sin(angle)
        found = turn @ found
    return found


def cameras(eye, matrix):
    """A camera without and one with perspective that look along -z of a rotation."""
    rows = np.column_stack([matrix, -matrix @ eye])
    parallel = np.vstack([rows[:2] * 0.02, -rows[2] / 200.0, [0, 0, 0, 1.0]])
    with_eye = np.vstack([rows[:2] * 1.3, -1.1 * rows[2] - [0, 0, 0, 20.0], -rows[2]])
    return Camera(parallel, 800.0, 800.0), Camera(with_eye, 800.0, 800.0)


def seen_by(camera: Camera, points: np.ndarray) -> np.ndarray:
    """Where points are on the screen, px, and how deep."""
    found = np.column_stack([points, np.ones(len(points))]) @ camera.to_pixels.T
    return found[:, :3] / found[:, 3:]


def test_a_view_shows_the_same_in_the_same_order_of_depth():
    rng = np.random.default_rng(5)
    for turn in ((0, 0, 0), (-90, 0, 0), (0, 0, 180), (0, 180, 0), (17, -80, 120)):
        matrix, points = turned(*turn), rng.uniform(-40, 40, (30, 3)) + (500, 9, 0)
        for camera, count in zip(cameras((500, 9, 0) + 100.0 * matrix[2], matrix), (8, 12)):
            assert len(camera.view) == count
            again = Camera.of_view(camera.view, points)
            before, after = seen_by(camera, points), seen_by(again, points)
            np.testing.assert_allclose(before[:, :2], after[:, :2], atol=1e-9)
            assert np.argsort(before[:, 2]).tolist() == np.argsort(after[:, 2]).tolist()
            assert np.abs(after[:, 2]).max() < 1.0


def test_a_view_follows_an_enlarged_part():
    points = square()._seen
    for camera in cameras(np.array([3.0, 4.0, 90.0]), turned(10, 20, 30)):
        told = {"drawn": {"lasso": [0, 0, 9, 0, 0, 9], "view": camera.view}}
        larger = sentences.view_of(sentences.scaled(told, 4.0)["drawn"])
        after = seen_by(Camera.of_view(larger, 4.0 * points), 4.0 * points)
        np.testing.assert_allclose(seen_by(camera, points)[:, :2], after[:, :2], atol=1e-9)


def test_a_figure_of_an_older_document_takes_the_same():
    part, told = square(), drawn_around(30.0, 3)["drawn"]
    taken = []
    for rows in (told, {"camera": FROM_ABOVE.to_pixels[:3].ravel().tolist()},
                 {"camera": FROM_ABOVE.to_pixels.ravel().tolist()}):  # fmt: skip
        figure = sentences.figure_of({**rows, "lasso": told["lasso"]})
        camera = Camera.of_view(figure.view, part._seen)
        taken.append(part.inside(camera, figures.outlines(figure)[0], [part]).tolist())
    assert taken[0] == taken[1] == taken[2] and len(taken[0]) > 20
    with pytest.raises(ValueError, match="8 or 12 numbers"):
        sentences.figure_of({"lasso": told["lasso"], "view": [1.0] * 7})
