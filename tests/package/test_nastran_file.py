# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran decks: numbers, cards, and that nothing but coordinates changes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from part_samples import NASTRAN, moved
from sheetmorph import FileError, read_part
from sheetmorph.decks.numbers import format_real, parse_real


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.5", 1.5),
        ("1.5-3", 1.5e-3),
        ("-.25+2", -25.0),
        ("1.E+3", 1000.0),
        ("1.d-2", 0.01),
        ("7", 7.0),
        ("  2. ", 2.0),
        ("", 0.0),
        ("1.5e", None),
        ("one", None),
        ("nan", None),
        ("1.+999", None),
        ("1 5.", None),
    ],
)
def test_a_field_has_the_value_nastran_gives_it(text: str, value: float | None):
    assert parse_real(text) == value


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0."),
        (-0.0, "0."),
        (1.0, "1."),
        (0.5, ".5"),
        (-1226.6, "-1226.6"),
        (3.141592653589793, "3.141593"),
        (-3.141592653589793, "-3.14159"),
        (9.99999999, "10."),
        (-0.99999999, "-1."),
        (1234567.8, "1234568."),
        (123456789.0, "1.2346+8"),
        (1.23456789e-5, "1.2346-5"),
        (1.23456789e-10, ".12346-9"),
        (-1.23456789e-10, "-.1235-9"),
    ],
)
def test_the_nearest_number_of_eight_characters_is_written(value: float, text: str):
    written = format_real(value, 8)
    assert abs(parse_real(written) - value) == abs(parse_real(text) - value)
    assert len(written) <= 8 and "." in written


@pytest.mark.parametrize(("width", "digits"), [(8, 4), (16, 12)])
def test_random_numbers_keep_as_many_digits_as_a_field_has_room_for(width: int, digits: int):
    random = np.random.default_rng(1)
    for exponent in range(-12, 13):
        for value in random.uniform(-1.0, 1.0, 40) * 10.0**exponent:
            written = format_real(float(value), width)
            assert len(written) <= width and "." in written
            # One digit less for a minus sign or a long exponent.
            assert abs(parse_real(written) - value) <= 10.0 ** -(digits - 2) * abs(value)


def test_a_number_beyond_any_field_is_refused():
    with pytest.raises(ValueError, match="does not fit a field of 4 characters"):
        format_real(-1e-300, 4)


@pytest.fixture
def deck(tmp_path: Path) -> Path:
    path = tmp_path / "deck.nas"
    path.write_bytes(NASTRAN)
    return path


def test_vertices_are_the_nodes_of_shells_and_keep_their_ids(deck: Path):
    part = read_part(deck)
    assert part.mesh.ids.tolist() == [10, 20, 30, 40, 50]
    assert part.mesh.points.tolist() == [[0, 0, 0], [1.5, 0, 0], [1.5, 1, 0.25], [0, 1, 0],
                                         [-1, 0, 0]]  # fmt: skip
    assert part.mesh.triangles.tolist() == [[0, 1, 3], [1, 2, 3], [0, 3, 4], [4, 3, 0]]
    assert part.precision == "8 characters"


def test_only_fields_of_moved_nodes_change(deck: Path, tmp_path: Path):
    part = read_part(deck)
    out = tmp_path / "out.nas"
    part.write(out, moved(part.mesh.points))
    before, after = NASTRAN.split(b"\n"), out.read_bytes().split(b"\n")
    assert len(before) == len(after)
    changed = [k for k in range(len(before)) if before[k] != after[k]]
    assert [before[k].split(b",")[0].split()[0] for k in changed] == [
        b"GRID", b"GRID", b"GRID", b"GRID*", b"*G40", b"GRID", b"GRID"
    ]  # fmt: skip
    assert before[changed[-1]].split()[1] == b"99"  # hangs on node 10 by a CBUSH
    second = next(line for line in after if line.startswith(b"GRID     20"))
    assert second[:24] == b"GRID     20      0      "
    assert second.endswith(b"$ a comment") and len(second) == 48 + len("$ a comment")


def test_a_large_field_keeps_sixteen_characters(deck: Path, tmp_path: Path):
    part = read_part(deck)
    positions = part.mesh.points + np.pi * 1000.0
    out = tmp_path / "out.nas"
    part.write(out, positions)
    error = np.abs(part.stored_positions(out) - positions).max(axis=1)
    assert error[3] < 1e-11 < error[0] < 1e-3


def test_every_coordinate_of_a_short_line_can_be_written(tmp_path: Path):
    text = NASTRAN.replace(b"GRID     10             0.      0.      0.", b"GRID     10")
    text = text.replace(b"GRID,50,,-1.0,0.,0.", b"GRID,50,,-1.0")
    path = tmp_path / "short.nas"
    path.write_bytes(text)
    part = read_part(path)
    positions = part.mesh.points.copy()
    positions[[0, 4], 2] = 2.5
    part.write(tmp_path / "out.nas", positions)
    again = read_part(tmp_path / "out.nas")
    assert np.array_equal(again.mesh.points, positions)
    assert b"GRID,50,,-1.,0.,2.5" in (tmp_path / "out.nas").read_bytes()


def test_a_default_coordinate_system_counts(deck: Path):
    system = (
        b"GRDSET          7\nCORD2R  7               1.      2.      3.      1.      2.      4.\n"
    )
    system += b"        2.      2.      3."
    deck.write_bytes(NASTRAN.replace(b"$ nodes", system))
    points = read_part(deck).mesh.points
    assert np.allclose(points[0], [1, 2, 3], atol=1e-15)
    assert points[1].tolist() == [1.5, 0, 0]  # its own field says 0


def test_a_deck_without_begin_bulk_is_read(tmp_path: Path):
    path = tmp_path / "include.blk"
    path.write_bytes(NASTRAN[NASTRAN.index(b"$ nodes") : NASTRAN.index(b"ENDDATA")])
    assert len(read_part(path).mesh.points) == 5


def test_an_include_that_is_not_there_is_named(deck: Path):
    text = NASTRAN.replace(b"GRID,50,,-1.0,0.,0.", b"INCLUDE 'nodes.blk'")
    deck.write_bytes(text)
    with pytest.raises(FileError, match='the include "nodes.blk" does not exist'):
        read_part(deck)
