# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes of a changed part are matched with those before, or they are a question: never a guess."""

import numpy as np
import pytest

from sheetmorph.selecting.correspondence import Holes, matched

PITCHES = (22.0, 30.0, 41.0)


def holes(places, kinds=None, sizes=None) -> Holes:
    """Holes through a plate in the plane z = 0."""
    places = np.column_stack([np.asarray(places, float).reshape(-1, 2), np.zeros(len(places))])
    count = len(places)
    axes = np.tile([0.0, 0.0, 1.0], (count, 1))
    sizes = np.full((count, 2), 9.0) if sizes is None else np.asarray(sizes, float)
    return Holes(list(kinds or ["round hole"] * count), places, axes, sizes.reshape(-1, 2))


def found(old: Holes, new: Holes) -> list:
    """The new hole of every old one, None for a question."""
    return [match.new for match in matched(old, new)]


def row(shift: float = 0.0, count: int = 4) -> np.ndarray:
    """Places of holes at a pitch of 30 mm."""
    return np.column_stack([30.0 * np.arange(count) + shift, np.zeros(count)])


def random_pattern(rng) -> Holes:
    """A grid, a circle or scattered holes, of one size, of two, or of two kinds."""
    pitch = float(rng.choice(PITCHES))
    form = rng.integers(3)
    if form == 0:
        across = np.arange(rng.integers(1, 5)), np.arange(rng.integers(1, 5))
        places = pitch * np.stack(np.meshgrid(*across), axis=-1).reshape(-1, 2).astype(float)
    elif form == 1:
        turns = 2.0 * np.pi * np.arange(count := rng.integers(3, 9)) / count
        places = pitch * np.column_stack([np.cos(turns), np.sin(turns)]) / np.sin(np.pi / count) / 2
    else:
        places = np.zeros((0, 2))
        while len(places) < 5:
            place = rng.uniform(-90.0, 90.0, 2)
            if not len(places) or np.linalg.norm(places - place, axis=1).min() > 20.0:
                places = np.vstack([places, place])
    kinds, sizes = ["round hole"] * len(places), np.full((len(places), 2), 9.0)
    for k in np.flatnonzero(rng.random(len(places)) < rng.choice([0.0, 0.0, 0.4])):
        kinds[k] = str(rng.choice(["round hole", "slotted hole"]))
        sizes[k] = (6.0, 6.0) if kinds[k] == "round hole" else (14.0, 8.0)
    return holes(places, kinds, sizes)


def turned(places: np.ndarray, angle: float) -> np.ndarray:
    """Places turned about their middle."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return (places - places.mean(axis=0)) @ turn.T + places.mean(axis=0)


def changed(rng, old: Holes) -> tuple[Holes, list]:
    """A small change of a pattern, and the row of every old hole after it, None without one."""
    places, sizes = old.places[:, :2].copy(), old.sizes.copy()
    kinds, rows = list(old.kinds), list(range(len(old)))
    what = rng.choice(["moved", "turned", "one moved", "removed", "added", "resized", "none"])
    one = int(rng.integers(len(old)))
    if what == "moved":
        places += rng.uniform(-35.0, 35.0, 2)
    elif what == "turned":
        places = turned(places, float(rng.uniform(-0.3, 0.3)))
    elif what == "one moved":
        places[one] += rng.uniform(-18.0, 18.0, 2)
    elif what == "resized":
        sizes[one] *= rng.uniform(0.7, 1.4)
    elif what == "added":
        new = places.mean(axis=0) + rng.uniform(-60.0, 60.0, 2)
        places, kinds = np.vstack([places, new]), [*kinds, kinds[one]]
        sizes = np.vstack([sizes, sizes[one]])
    elif what == "removed":
        keep = [k for k in rows if k != one]
        places, sizes, kinds = places[keep], sizes[keep], [kinds[k] for k in keep]
        rows = [None if k == one else k - (k > one) for k in rows]
    order = rng.permutation(len(places))
    number = {int(k): i for i, k in enumerate(order)}
    after = holes(places[order], [kinds[k] for k in order], sizes[order])
    return after, [None if k is None else number[k] for k in rows]


def test_a_moved_pattern_is_followed_as_a_whole():
    for shift in (1.0, 9.0, 14.0, 16.0, 21.0):
        assert found(holes(row()), holes(row(shift))) == [0, 1, 2, 3], shift


def test_a_pattern_that_moved_by_its_pitch_may_have_lost_one_hole_and_won_another():
    matches = matched(holes(row()), holes(row(30.0)))
    assert [match.new for match in matches[1:]] == [None] * 3
    assert matches[1].rivals == [0, 1]


def test_a_hole_that_moved_half_the_way_to_its_neighbour_is_a_question():
    places = row()
    places[1, 0] = 44.0
    matches = matched(holes(row()), holes(places))
    assert [match.new for match in matches] == [0, None, 2, 3]
    assert matches[1].rivals == [1, 0]
    places[1, 0] = 38.0
    assert found(holes(row()), holes(places)) == [0, 1, 2, 3]


def test_a_removed_hole_is_a_question_and_the_others_stay():
    assert found(holes(row()), holes(row()[[0, 2, 3]])) == [0, None, 1, 2]


def test_sizes_and_kinds_tell_holes_apart_in_a_pattern_moved_by_its_pitch():
    kinds = ["round hole", "slotted hole", "round hole", "slotted hole"]
    sizes = [(9, 9), (14, 8), (6, 6), (20, 8)]
    old, new = (holes(row(shift), kinds, sizes) for shift in (0.0, 30.0))
    assert found(old, new) == [0, 1, 2, 3]


def test_part_of_a_pattern_that_moved_is_followed_and_the_rest_stays():
    places = np.vstack([row(), row() + [0.0, 60.0]])
    after = places.copy()
    after[4:, 0] += 16.0
    assert found(holes(places), holes(after)) == list(range(8))


def test_a_circle_turned_by_nearly_half_its_pitch_is_a_question():
    angles = np.pi / 3.0 * np.arange(6)
    places = 40.0 * np.column_stack([np.cos(angles), np.sin(angles)])
    assert found(holes(places), holes(turned(places, 0.15))) == list(range(6))
    assert found(holes(places), holes(turned(places, 0.5))) == [None] * 6


def test_no_holes_on_either_side():
    assert found(holes([]), holes(row())) == []
    assert found(holes(row()), holes([])) == [None] * 4


@pytest.mark.parametrize("seed", range(6))
def test_small_changes_give_the_true_match_or_a_question(seed):
    rng = np.random.default_rng(seed)
    questions = 0
    for _ in range(40):
        old = random_pattern(rng)
        new, truth = changed(rng, old)
        for match, true in zip(matched(old, new), truth):
            assert match.new is None or match.new == true
            questions += match.new is None and true is not None
    assert questions < 100
