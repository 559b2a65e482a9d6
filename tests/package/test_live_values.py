# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the colours say while a morph moves, which needs no FreeCAD."""

import numpy as np
import pytest
from freecad.sheetmorph.tools import colour_scale, wires
from freecad.sheetmorph.tools.element_quality import MEASURES, ElementQuality
from freecad.sheetmorph.tools.live_values import Displacement, Gaps, Quality, Region, Side, Stretch
from freecad.sheetmorph.tools.live_values import legend_of, turn_of
from sheetmorph import _core
from sheetmorph.measuring import quality
from sheetmorph.measuring.strain import PrincipalStretches

SQUARE = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float)
HALVES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)


def test_displacement_is_the_way_from_rest():
    valuer = Displacement({"a": SQUARE, "b": SQUARE})
    shown = {"a": SQUARE + (3.0, 0.0, 4.0), "b": SQUARE}
    values = valuer(shown)
    assert values["a"] == pytest.approx(np.full(4, 5.0)) and not values["b"].any()
    legend = legend_of(valuer, shown, values)
    assert (legend.span, legend.extreme, legend.part) == ((0.0, 5.0), 5.0, "a")


def test_quality_tells_the_sharpest_corner():
    valuer = Quality(_core, {"flat": HALVES, "thin": HALVES})
    shown = {"flat": SQUARE, "thin": SQUARE * (1.0, 0.1, 1.0)}
    legend = legend_of(valuer, shown, valuer(shown))
    assert legend.span == (0.0, 60.0) and legend.part == "thin"
    assert legend.extreme == pytest.approx(np.degrees(np.arctan(0.1)))


def test_a_stretch_tells_its_worst_places_apart_from_each_other_and_what_is_near():
    x = np.linspace(0.0, 40.0, 41)
    rest = np.array([(a, b, 0.0) for a in x for b in (0.0, 1.0)])
    a = 2 * np.arange(40)[:, None]
    triangles = np.vstack([a + (0, 2, 3), a + (0, 3, 1)]).astype(np.int32)
    now = rest.copy()
    now[rest[:, 0] > 5.0, 0] += 0.5  # between 5 and 6: half as long again
    now[rest[:, 0] > 30.0, 0] += 0.2
    regions = [Region("flange", "strip", np.array([0, 1])), Region("far", "other", np.array([0]))]
    valuer = Stretch(PrincipalStretches, {"strip": (rest, triangles)}, regions)
    legend = legend_of(valuer, {"strip": now}, valuer({"strip": now}))
    assert [place.value for place in legend.places] == pytest.approx([50.0, 20.0])
    assert legend.near == "flange" and valuer.near({"strip": now}, legend.places[1]) == ""
    assert np.all(
        np.abs([place.point[0] for place in legend.places] - np.array([5.5, 30.5])) <= 0.5
    )
    assert legend_of(valuer, {"strip": rest}, valuer({"strip": rest})).places == ()


def gaps(above: np.ndarray) -> dict:
    """Two squares, one 1 mm above the other at rest; the values with the upper one elsewhere."""
    meshes = {"low": (SQUARE, HALVES), "high": (SQUARE + (0.0, 0.0, 1.0), HALVES)}
    sides = [Side("high", np.array([0, 2]), "low"), Side("low", np.array([1]), "high")]
    return Gaps(_core, meshes, sides)({"low": SQUARE, "high": above})


def test_a_gap_that_stays_has_not_changed_wherever_both_go():
    values = gaps(SQUARE + (0.0, 0.0, 1.0))
    assert values["high"][[0, 2]] == pytest.approx((0.0, 0.0))
    assert np.isnan(values["high"][[1, 3]]).all() and np.isnan(values["low"][[0, 2, 3]]).all()


def test_a_gap_that_opens_or_closes_shows_where():
    assert gaps(SQUARE + (0.0, 0.0, 1.5))["high"][[0, 2]] == pytest.approx((0.5, 0.5))
    assert gaps(SQUARE + (0.0, 0.0, 0.25))["low"][1] == pytest.approx(0.75)


def test_without_contacts_there_is_nothing_to_say():
    valuer = Gaps(_core, {"low": (SQUARE, HALVES)}, [])
    legend = legend_of(valuer, {"low": SQUARE}, valuer({"low": SQUARE}))
    assert (legend.part, legend.span) == ("", (0.0, 1.0))


@pytest.mark.parametrize(("value", "end"), [(0.0, 1.0), (0.03, 0.05), (1.0, 1.0), (18.0, 20.0)])
def test_a_legend_ends_at_a_round_number(value, end):
    assert colour_scale.round_up(value) == pytest.approx(end)


@pytest.mark.parametrize("degrees", [0.0, 1e-5, 90.0, 179.9999])
def test_a_turn_is_told_in_degrees(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    assert turn_of(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])) == pytest.approx(degrees)


def elements(name: str, limits: dict, places: np.ndarray) -> ElementQuality:
    def measured(points, faces):
        return quality.measured(quality.MEASURES[name], points, faces)

    faces = np.array([[0, 1, 2, 3], [0, 1, 2, -1]])
    valuer = ElementQuality(name, measured, limits, {"a": (SQUARE, faces)})
    valuer({"a": places})
    return valuer


def test_elements_are_measured_as_quads_and_counted():
    valuer = elements("aspect", {"max": 3.0}, SQUARE)
    assert legend_of(valuer, {"a": SQUARE}, valuer({"a": SQUARE})).span == (1.0, 2.0)
    values = valuer({"a": SQUARE * (5.0, 1.0, 1.0)})["a"]
    assert values == pytest.approx([np.sqrt(26.0)] * 3 + [5.0])
    histogram = valuer.histogram
    assert (histogram.count, histogram.failing, histogram.rest.sum()) == (2, 2, 2)
    assert histogram.place_of_limit() == pytest.approx((3.0 - 1.0) / (histogram.span[1] - 1.0))
    assert max(bar[2] for bar in histogram.bars(240.0, 60.0)) == pytest.approx(60.0)


def test_a_low_value_is_the_worst_of_angles():
    valuer = elements("min_angle", {}, SQUARE)
    found = legend_of(valuer, {"a": SQUARE}, valuer({"a": SQUARE}))
    assert found.extreme == pytest.approx(45.0) and found.span == (0.0, 90.0)
    assert found.histogram.place_of_limit() is None


def test_all_measures_of_the_certificate_have_colours():
    assert list(MEASURES) == list(quality.MEASURES)


def test_edges_of_quads_leave_their_diagonals_out():
    faces = np.array([[0, 1, 2, 3], [1, 4, 2, -1]])
    assert wires.of_faces(faces).tolist() == [[0, 1], [0, 3], [1, 2], [1, 4], [2, 3], [2, 4]]
