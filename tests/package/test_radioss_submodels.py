# SPDX-License-Identifier: LGPL-2.1-or-later
"""Submodels of Radioss: the same ids twice, told apart by the offsets of //SUBMODEL."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from sheetmorph import FileError, run
from sheetmorph.decks import read_deck

PLATE = "".join(
    [
        "/NODE\n",
        *(f"{k:10d}{x:20.4f}{y:20.4f}{0.0:20.4f}\n"
          for k, (x, y) in enumerate([(x, y) for x in range(0, 60, 10) for y in (0, 10, 20)], 1)),
        "/SHELL/5\n",
        *(f"{3 * i + j + 1:10d}" + "".join(f"{n:10d}" for n in (a, a + 3, a + 4, a + 1)) + "\n"
          for i in range(5) for j in range(2) for a in [3 * i + j + 1]),
        "/PART/5\nplate\n         7         1\n/PROP/SHELL/7\nsheet\n         1\n#\n",
        "                   0\n         0         0                 1.3\n",
        "/GRNOD/NODE/4\nends\n         1         2\n/RBODY/1\nbody\n",
        "         3         0         0         0                   0         4\n",
    ]
)  # fmt: skip
HEAD = "#RADIOSS STARTER\n/BEGIN\nplates\n      2022         0\n"


def main_file(one: str, two: str) -> str:
    return (
        f"{HEAD}//SUBMODEL/1\nfirst\n{one}\n#include plate.inc\n//ENDSUB\n"
        f"//SUBMODEL/2\nsecond\n# a comment\n{two}\n{PLATE}//ENDSUB\n/END\n"
    )


def write(folder: Path, one: str, two: str) -> Path:
    (folder / "plate.inc").write_text(PLATE)
    place = folder / "plates_0000.rad"
    place.write_text(main_file(one, two))
    return place


def test_ids_are_shifted_by_the_offsets_of_their_submodel(tmp_path: Path):
    deck = read_deck(write(tmp_path, "", "      1000      2000         0      4000"))
    assert sorted(deck.ids.tolist()) == [*range(1, 19), *range(2001, 2019)]
    shells = [block for block in deck.elements if block.kind == "shell"]
    found = {block.file: block for block in shells}
    assert found[1].nodes[0].tolist() == [1, 4, 5, 2]
    assert found[0].nodes[0].tolist() == [2001, 2004, 2005, 2002]
    assert found[0].ids[0] == 1001 and set(found[0].properties.tolist()) == {4005}
    assert deck.raw.thickness == {5: 1.3, 4005: 1.3}
    bodies = [block.nodes.tolist() for block in deck.elements if block.kind == "rigid"]
    assert sorted(bodies) == [[[3, 1, 2]], [[2003, 2001, 2002]]]


def test_a_deck_of_submodels_is_morphed_in_all_its_files(tmp_path: Path):
    place = write(tmp_path, "", "         0      2000      2000      2000")
    recipe = {
        "sheetmorph": 1,
        "primary": "plates_0000/2005",
        "parts": [{"file": place.name, "split": "property"}],
        "fixed": [{"part": "plates_0000/2005", "vertices": [2001, 2002, 2003]}],
        "handles": [{"name": "end", "part": "plates_0000/2005", "vertices": [2016, 2017, 2018]}],
        "pose": {"end": {"translation": [0, 0, 5]}},
    }
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    run(tmp_path / "recipe.json", tmp_path / "out")
    assert (tmp_path / "out" / "plate.inc").read_text() == PLATE
    moved = read_deck(tmp_path / "out" / place.name)
    rows = moved.find(np.array([16, 2016]))
    assert moved.points[rows, 2].tolist() == [0.0, 5.0]


def test_the_same_ids_without_offsets_are_one_node_each(tmp_path: Path):
    text = PLATE.replace("10.0000              0.0000\n", "11.0000              0.0000\n", 1)
    (tmp_path / "plate.inc").write_text(text)
    place = tmp_path / "plates_0000.rad"
    place.write_text(main_file("", ""))
    with pytest.raises(FileError, match="defined twice, differently"):
        read_deck(place)


def test_a_submodel_in_an_old_version_is_refused_in_words(tmp_path: Path):
    place = tmp_path / "old_0000.rad"
    place.write_text(f"{HEAD}//SUBMODEL/1/0/V41\nold\n\n{PLATE}//ENDSUB\n/END\n")
    with pytest.raises(FileError, match="version 41 of the format"):
        read_deck(place)
