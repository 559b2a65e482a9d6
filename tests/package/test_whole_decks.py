# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks are read whole, or refused: wrong endings, names of includes, ends cut off, marks."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import numpy as np
import pytest
from deck_samples import ABAQUS, CALCULIX, DYNA, GMSH, GMSH_4, NASTRAN, RADIOSS

from sheetmorph import FileError
from sheetmorph.cli import main
from sheetmorph.decks import read_deck, suffixes
from sheetmorph.decks.abaqus import SUFFIXES as OF_ABAQUS
from sheetmorph.decks.dyna import SUFFIXES as OF_DYNA
from sheetmorph.decks.gmsh import SUFFIXES as OF_GMSH
from sheetmorph.decks.nastran import SUFFIXES as OF_NASTRAN
from sheetmorph.decks.radioss import SUFFIXES as OF_RADIOSS

MARK = b"\xef\xbb\xbf"
SAMPLES = {
    "nastran": (NASTRAN, OF_NASTRAN),
    "large nastran": (b"GRID*                  1                              1.              2."
                      b"*\n*                     3.\nENDDATA\n", OF_NASTRAN),
    "dyna": (DYNA, OF_DYNA),
    "abaqus": (ABAQUS, OF_ABAQUS),
    "calculix": (CALCULIX, OF_ABAQUS),
    "radioss": (RADIOSS, OF_RADIOSS),
    "gmsh": (GMSH, OF_GMSH),
    "gmsh 4": (GMSH_4, OF_GMSH),
}  # fmt: skip


@pytest.mark.parametrize("suffix", suffixes())
@pytest.mark.parametrize("name", list(SAMPLES))
def test_a_deck_under_the_ending_of_another_format_is_refused(name: str, suffix: str):
    data, own = SAMPLES[name]
    if suffix in own:
        assert len(read_deck(Path(f"deck{suffix}"), lambda _: data).ids)
    else:
        with pytest.raises(FileError, match="this is .*, but its name says .*; give it the ending"):
            read_deck(Path(f"deck{suffix}"), lambda _: data)


@pytest.mark.parametrize("name", ["nastran", "dyna", "abaqus", "calculix", "radioss", "gmsh"])
def test_a_mark_in_front_of_a_deck_loses_nothing_and_is_written_again(name: str, tmp_path: Path):
    data, own = SAMPLES[name]
    plain = read_deck(Path(f"deck{own[0]}"), lambda _: data)
    marked = read_deck(Path(f"deck{own[0]}"), lambda _: MARK + data)
    assert marked.ids.tolist() == plain.ids.tolist()
    assert np.array_equal(marked.points, plain.points)
    place = tmp_path / f"deck{own[0]}"
    place.write_bytes(MARK + data)
    assert main(["copy", str(place), "-o", str(tmp_path / "out")]) == 0
    assert (tmp_path / "out" / place.name).read_bytes() == MARK + data


def test_a_mark_in_front_of_the_first_node_does_not_lose_it():
    data = b"GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nCTRIA3,1,1,1,2,3\nENDDATA\n"
    deck = read_deck(Path("a.bdf"), lambda _: MARK + data)
    assert deck.ids.tolist() == [1, 2, 3]


@pytest.mark.parametrize("mark", [b"\xff\xfe", b"\xfe\xff"])
def test_text_in_utf_16_is_refused(mark: bytes):
    code = "utf-16-le" if mark == b"\xff\xfe" else "utf-16-be"
    data = mark + NASTRAN.decode("latin-1").encode(code)
    with pytest.raises(FileError, match="UTF-16"):
        read_deck(Path("a.bdf"), lambda _: data)


INCLUDES = {
    "a.bdf": (b"BEGIN BULK\nGRID,1,,0.,0.,0.\nINCLUDE '%s'\nENDDATA\n", b"GRID,2,,1.,0.,0.\n"),
    "a.k": (b"*KEYWORD\n*NODE\n       1\n*INCLUDE\n%s\n*END\n", b"*NODE\n       2\n*END\n"),
    "a.inp": (b"*NODE\n1, 0.\n*INCLUDE, INPUT=%s\n", b"*NODE\n2, 1.\n"),
    "a.rad": (b"#RADIOSS\n/NODE\n         1\n#include %s\n/END\n", b"/NODE\n         2\n"),
}
NAME = "blech ü.inc"


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are bytes")
@pytest.mark.parametrize("on_disk", ["utf-8", "latin-1"])
@pytest.mark.parametrize("in_deck", ["utf-8", "latin-1"])
@pytest.mark.parametrize("deck", list(INCLUDES))
def test_names_of_includes_are_utf_8_or_latin_1(deck: str, in_deck: str, on_disk: str, tmp_path):
    text, include = INCLUDES[deck]
    (tmp_path / deck).write_bytes(text % NAME.encode(in_deck))
    (tmp_path / os.fsdecode(NAME.encode(on_disk))).write_bytes(include)
    found = read_deck(tmp_path / deck)
    assert sorted(found.ids.tolist()) == [1, 2]
    assert main(["copy", str(tmp_path / deck), "-o", str(tmp_path / "out")]) == 0
    copied = tmp_path / "out" / os.fsdecode(NAME.encode(on_disk))
    assert copied.read_bytes() == include


def test_an_include_that_is_not_there_is_named_as_people_wrote_it(tmp_path: Path):
    (tmp_path / "a.k").write_bytes(INCLUDES["a.k"][0] % NAME.encode())
    with pytest.raises(FileError, match='the include "blech ü.inc" does not exist'):
        read_deck(tmp_path / "a.k")


WHOLE = {
    "a.bdf": NASTRAN,
    "a.k": DYNA,
    "a.rad": RADIOSS,
    "a.inp": ABAQUS,
    "step.inp": CALCULIX + b"*STEP\n*STATIC\n*END STEP\n",
}


@pytest.mark.parametrize("name", list(WHOLE))
def test_a_deck_cut_at_the_end_of_a_line_says_what_is_missing(name: str):
    data = WHOLE[name]
    whole = read_deck(Path(name), lambda _: data)
    assert whole.raw.cut == []
    ends = [k + 1 for k, code in enumerate(data) if code == 10]
    silent = []
    for end in ends[:-1]:
        try:
            deck = read_deck(Path(name), lambda _: data[:end])
        except FileError:
            continue
        if not deck.raw.cut:
            silent.append(data[:end].splitlines()[-1])
    # Input files of Abaqus have no mark at their end; these are whole as they are.
    allowed = {
        "a.inp": [b"** in two parts", b"*End Assembly"],
        "step.inp": [b"2,1.5,0,0", b"1,0,0,0", b"2,1,0,0", b"3,1,1,0", b"1,1,2,3", b"1,3,1",
                     b"*RIGID BODY,NSET=N,REF NODE=3", b"BEAM,1,2", b"1,1,1.,2,1,-1."],
    }  # fmt: skip
    assert set(silent) <= set(allowed.get(name, [])), silent


def test_a_card_that_goes_on_in_a_missing_line_is_named():
    text = b"BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nRBE2,7,1,123,2,,,,,+\nENDDATA\n"
    deck = read_deck(Path("a.bdf"), lambda _: text.replace(b"ENDDATA\n", b""))
    assert any("line 4: the last card has a continuation line" in one for one in deck.raw.cut)


def test_an_element_of_missing_nodes_is_named():
    text = b"BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCROD,7,1,1,9\nENDDATA\n"
    deck = read_deck(Path("a.bdf"), lambda _: text)
    assert "a.bdf, line 4: CROD 7 names nodes that do not exist: 9" in deck.notes


def test_a_quadrilateral_with_three_corners_is_named():
    text = NASTRAN.replace(
        b"CQUAD4  1       1       1       3       6       4", b"CQUAD4,1,1,1,3,6"
    )
    deck = read_deck(Path("a.bdf"), lambda _: text)
    assert any("CQUAD4 1 has 3 of its 4 corners" in one for one in deck.notes)
