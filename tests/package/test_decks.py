# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks in five formats: what they say, and that nothing but moved numbers changes."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest

from deck_samples import ABAQUS, CALCULIX, DYNA, GMSH, NASTRAN, RADIOSS, deck_samples
from sheetmorph import FileError, read_part
from sheetmorph.cli import main
from sheetmorph.decks import Deck, read_deck, sheet_of
from sheetmorph.decks.contents import shells_of
from sheetmorph.decks.dyna import assumed_options
from sheetmorph.decks.numbers import format_real, parse_integers, parse_real, parse_reals

SAMPLES = deck_samples()


@pytest.fixture(params=sorted(SAMPLES))
def deck(request, tmp_path: Path) -> Deck:
    path = tmp_path / request.param
    path.write_bytes(SAMPLES[request.param])
    return read_deck(path)


def read(data: bytes, name: str) -> Deck:
    """A deck from bytes."""
    return read_deck(Path(name), lambda path: data)


def written(deck: Deck, positions: np.ndarray) -> bytes:
    """The first file of a deck with its nodes moved."""
    out = io.BytesIO()
    deck.save(positions, 0, out)
    return out.getvalue()


def point(deck: Deck, node: int) -> list[float]:
    """Where a node is."""
    return deck.points[deck.find(np.array([node]))[0]].tolist()


def elements(deck: Deck, kind: str) -> list[list[int]]:
    """The nodes of the elements of a kind, zeros left out."""
    rows = [row for block in deck.elements if block.kind == kind for row in block.nodes.tolist()]
    return [[node for node in row if node] for row in rows]


def test_what_did_not_move_stays_byte_for_byte(deck: Deck):
    assert written(deck, deck.points) == deck.texts[0].data


def free(deck: Deck) -> np.ndarray:
    """Which nodes may be moved."""
    return ~np.isin(deck.ids, sorted(deck.raw.locked))


def test_moved_nodes_read_back_and_the_rest_of_the_file_stays(deck: Deck):
    rng = np.random.default_rng(3)
    wanted = deck.points + np.where(
        free(deck)[:, None], rng.uniform(0.1, 0.9, deck.points.shape), 0
    )
    data = written(deck, wanted)
    again = read(data, deck.path.name)
    assert again.ids.tolist() == deck.ids.tolist()
    assert np.abs(again.points - wanted).max() < 2e-5
    assert [len(b.ids) for b in again.elements] == [len(b.ids) for b in deck.elements]
    assert written(again, again.points) == data


def test_one_moved_node_changes_its_own_lines(deck: Deck):
    where = int(np.flatnonzero(free(deck) & (deck.ids > 0))[-1])
    wanted = deck.points.copy()
    wanted[where] += [0.25, 0.5, 0.125]
    before, after = deck.texts[0].data, written(deck, wanted)
    if b"\0" in before:
        assert len(before) == len(after)
        return
    old, new = before.splitlines(), after.splitlines()
    assert len(old) == len(new)
    assert 1 <= sum(one != other for one, other in zip(old, new)) <= 2


def test_nastran_nodes_stand_in_chains_of_systems():
    deck = read(NASTRAN, "a.bdf")
    assert np.allclose(point(deck, 5), [0, 2, 1], atol=1e-12)
    assert point(deck, 4) == [0, 1, 0]
    assert point(deck, 6) == [2, 1, 0] and point(deck, 7) == [1.5, 1, 0.25]
    assert point(deck, 8) == [2.5, 1.5, 0.5]
    assert elements(deck, "rigid") == [[8, 1, 3]]
    assert elements(deck, "constraint") == [[8, 1, 3, 4, 6]]
    assert elements(deck, "mass") == [[8]]
    assert elements(deck, "frame") == [[1, 2, 3]]
    assert (deck.ids < 0).sum() == 1


def test_a_node_follows_or_stays_whatever_its_system_does():
    deck = read(NASTRAN, "a.bdf")
    wanted = deck.points.copy()
    wanted[deck.find(np.array([2, 3]))] += [[0.3, 0, 0], [0, 0.4, 0]]
    data = written(deck, wanted)
    again = read(data, "a.bdf")
    # The system by nodes turned: what is written in it has new numbers and stands where it stood.
    assert b"GRID    4       5       0.      1.      0.$" not in data
    assert np.abs(again.points - wanted).max() < 2e-6


def test_a_default_system_and_systems_in_a_circle():
    circle = NASTRAN.replace(b"CORD1R  5       1 ", b"CORD1R  5       5 ")
    with pytest.raises(FileError, match="coordinate system . is defined by itself"):
        read(circle, "a.bdf")


@pytest.mark.parametrize("line", [b"BEGIN SUPER=3\n", b"BEGIN BULK SUPER = 3\n"])
def test_superelements_are_refused_with_their_line(line: bytes):
    with pytest.raises(FileError, match="a deck of several models is not read") as told:
        read(NASTRAN.replace(b"ENDDATA\n", line + b"ENDDATA\n"), "a.bdf")
    assert told.value.line == 28


def test_keyword_nodes_of_all_widths():
    deck = read(DYNA, "a.k")
    assert deck.ids.tolist() == [1, 2, 3, 4, 5, 6]
    assert point(deck, 2) == [-1234567.8901234, 0, 0]
    assert point(deck, 3) == [1, 1, 0.5] and point(deck, 4) == [0, 1, 2.5]
    assert point(deck, 5) == [1, 2, 3] == point(deck, 6)
    assert deck.raw.locked == {4: "&depth is a parameter"}
    assert deck.raw.thickness == {7: 1.2}
    assert sheet_of(deck).properties.tolist() == [7, 7, 7]
    assert elements(deck, "rigid") == [[1, 2]] and elements(deck, "weld") == [[5, 6]]
    assert {place.card for place in deck.raw.stale} == {
        "*AIRBAG_REFERENCE_GEOMETRY", "*ELEMENT_SHELL_THICKNESS", "*DEFINE_COORDINATE_SYSTEM"
    }  # fmt: skip


def test_a_long_deck_says_so_in_its_first_line():
    text = b"*KEYWORD long=y\n*NODE\n" + b"%20d%20s%20s%20s\n" % (7, b"1.5", b"2", b"3")
    text += b"*NODE -\n" + b"%8d%16s%16s%16s\n" % (8, b"1.5", b"2", b"3")
    assert read(text, "a.k").points.tolist() == [[1.5, 2, 3], [1.5, 2, 3]]


def test_a_long_deck_that_does_not_say_so_is_told_on_the_command_line(tmp_path: Path):
    text = b"*KEYWORD\n*NODE\n" + b"%20d%20s%20s%20s\n" % (7, b"1.5", b"2", b"3") + b"*END\n"
    (tmp_path / "a.k").write_bytes(text)
    with assumed_options("long=y"):
        assert read(text, "a.k").points.tolist() == [[1.5, 2, 3]]
    command = ["copy", str(tmp_path / "a.k"), "-o", str(tmp_path / "out")]
    assert main(command) == 2
    assert main([*command, "--keyword", "long=y"]) == 0
    assert (tmp_path / "out" / "a.k").read_bytes() == text


def test_what_a_solver_shifts_at_its_start_is_told():
    deck = read(b"*KEYWORD\n*PERTURBATION_NODE\n         1\n*END\n", "a.k")
    assert [place.card for place in deck.raw.stale] == ["*PERTURBATION_NODE"]
    ties = b"*NODE\n1, 0, 0, 0\n*TIE, NAME=A\nS, M\n*TIE, NAME=B, ADJUST=NO\nS, M\n"
    assert [place.line for place in read(ties, "a.inp").raw.stale] == [2]


def test_an_instance_is_shifted_before_it_is_turned():
    deck = read(ABAQUS, "a.inp")
    assert np.allclose(point(deck, 2), [0, 20, 0], atol=1e-12)
    assert np.allclose(point(deck, 3), [-10, 20, 1.5], atol=1e-12)
    # (1, 0, 0) along the y axis of the part, at z 100.
    assert np.allclose(point(deck, 5), [-1, 10, 100], atol=1e-12)
    assert elements(deck, "shell") == [[1, 2, 3, 4]]


def test_a_part_in_two_places_is_not_moved():
    twice = b"*Instance, name=two, part=plate\n*End Instance\n*End Assembly"
    deck = read(ABAQUS.replace(b"*End Assembly", twice), "a.inp")
    assert set(deck.raw.locked.values()) == {"its part PLATE has 2 instances"}


def test_the_last_definition_of_a_node_counts():
    deck = read(CALCULIX, "a.inp")
    assert deck.ids.tolist() == [1, 3, 2] and point(deck, 2) == [1.5, 0, 0]
    data = written(deck, deck.points + 0.1234567890123456789)
    assert b"\n2,1,0,0\n" in data and b"\n2,1.5,0,0\n" not in data
    assert max(len(word) for line in data.split(b"\n")[1:5] for word in line.split(b",")) <= 20
    assert "*NGEN generates nodes" in deck.notes[0]
    assert elements(deck, "rigid") == [[3, 1, 2], [1, 2]]
    assert elements(deck, "constraint") == [[1, 2]]


def test_radioss_columns_touch():
    deck = read(RADIOSS, "a.rad")
    assert point(deck, 2) == [10, 0, -1.2345678901234567]
    assert point(deck, 3) == [10, 10, 0]
    assert elements(deck, "rigid") == [[3, 1, 2]] and elements(deck, "line") == [[1, 3]]
    assert deck.raw.thickness == {5: 1.3}


def test_gmsh_points_are_doubles():
    deck = read(GMSH, "a.msh")
    assert point(deck, 7) == [1, 1, 0.1]
    wanted = deck.points + np.pi
    assert np.array_equal(read(written(deck, wanted), "a.msh").points, wanted)


def test_includes_go_where_they_were(tmp_path: Path, capsys):
    folder = tmp_path / "in"
    (folder / "parts").mkdir(parents=True)
    nodes, rest = NASTRAN.split(b"GRID,6", 1)
    include = b"INCLUDE 'parts/no\n  des.inc' \n"
    (folder / "a.bdf").write_bytes(nodes + include + rest.split(b"\n", 1)[1])
    (folder / "parts" / "nodes.inc").write_bytes(b"$ one node\nGRID,6,,2.0,1.0\n")
    assert main(["copy", str(folder / "a.bdf"), "-o", str(tmp_path / "out")]) == 0
    assert "8 nodes" in capsys.readouterr().out
    for name in ("a.bdf", "parts/nodes.inc"):
        assert (tmp_path / "out" / name).read_bytes() == (folder / name).read_bytes()


def test_an_include_outside_of_the_folder_is_refused(tmp_path: Path, capsys):
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "a.k").write_bytes(DYNA.replace(b"*END", b"*INCLUDE\n../b.k\n*END"))
    (tmp_path / "b.k").write_bytes(b"*KEYWORD\n*END\n")
    assert main(["copy", str(tmp_path / "in" / "a.k"), "-o", str(tmp_path / "out")]) == 2
    assert "is outside its folder" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_an_include_of_itself_is_refused(tmp_path: Path):
    path = tmp_path / "a.k"
    path.write_bytes(DYNA.replace(b"*END", b"*INCLUDE\na.k\n*END"))
    with pytest.raises(FileError, match='"a.k" includes itself'):
        read_deck(path)


@pytest.mark.parametrize("width", [8, 10, 16, 20])
def test_the_nearest_number_is_written_and_what_fits_is_exact(width: int):
    rng = np.random.default_rng(width)
    values = rng.uniform(-1, 1, 500) * 10.0 ** rng.integers(-9, 9, 500)
    for value in values.tolist():
        text = format_real(value, width, "E")
        assert len(text) <= width and "." in text
        error = abs(parse_real(text) - value)
        assert error <= 0.5 * abs(value) * 10.0 ** (7 - width)
        assert width < 20 or error <= 1e-17 + 2e-16 * abs(value)


def test_many_fields_are_read_as_single_ones_are():
    texts = ["1.5", "1.5-3", "-.25+2", "1.E+3", "1.d-2", "7", "  2. ", "", "1.5e", "nan", "1 5."]
    codes = np.array([list(text.ljust(9).encode()) for text in texts], dtype=np.uint8)
    single = [parse_real(text) for text in texts]
    expected = [np.nan if value is None else value for value in single]
    assert np.array_equal(parse_reals(codes), expected, equal_nan=True)
    whole = ["12", " -7 ", "", "+3", "1 2", "1-", "-", "1.", "000000012"]
    codes = np.array([list(text.ljust(9).encode()) for text in whole], dtype=np.uint8)
    values, sound = parse_integers(codes)
    assert values[sound].tolist() == [12, -7, 0, 3, 12]
    assert sound.tolist() == [True] * 4 + [False] * 4 + [True]


CARDS = b"PSHELL,1,4,1.5\nMAT1,4,70000.,%s,%s,2.7-9\nENDDATA\n"
ALLOY = b"*Material, name=Steel\n*Density\n2.7e-9,\n*Elastic\n70000., 0.33\n"


@pytest.mark.parametrize(
    ("data", "name", "told"),
    [
        (NASTRAN.replace(b"ENDDATA\n", CARDS % (b"", b".33")), "a.bdf", "MAT1 4"),
        (NASTRAN.replace(b"ENDDATA\n", CARDS % (b"26315.7895", b"")), "a.bdf", "MAT1 4"),
        (ABAQUS + ALLOY, "a.inp", "*MATERIAL STEEL"),
        (ABAQUS + ALLOY.replace(b"2.7e-9", b"2700."), "a.inp", "steel"),
        (ABAQUS + ALLOY.replace(b"0.33", b"9"), "a.inp", "steel"),
        (ABAQUS + ALLOY.replace(b"70000.", b"nonsense"), "a.inp", "steel"),
        (ABAQUS, "a.inp", "steel"),
    ],
    ids=["poisson", "shear", "abaqus", "metres", "no ratio", "no number", "none"],
)
def test_the_material_of_shells(data: bytes, name: str, told: str):
    found = read(data, name).raw.materials.of(1)
    assert found.name == told
    if told != "steel":
        sound = np.sqrt(70e9 / (2700.0 * (1.0 - 0.33**2)))
        assert found.density == 2.7e-9 and found.sound == pytest.approx(sound, rel=1e-6)


NAMED = {
    '$HMNAME PROP         1"a skin"\n$HMNAME COMP         1"another"\n': "a skin",
    "$ Femap Property 1 : a skin\n": "a skin",
    "$ANSA_NAME_COMMENT;1;PSHELL;a skin;;NO;\n": "a skin",
    "$ no name\n": "",
}


@pytest.mark.parametrize("comment", NAMED)
def test_properties_have_the_names_that_pre_processors_write(comment: str):
    found = read(NASTRAN.replace(b"BEGIN BULK\n", b"BEGIN BULK\n" + comment.encode()), "a.bdf")
    assert found.raw.names.get(1, "") == NAMED[comment]


def test_the_shells_of_a_deck_are_listed_by_property():
    found = {
        name: shells_of(deck, sheet, np.arange(len(sheet.triangles)))
        for name in ("deck.k", "deck.inp", "deck_0000.rad", "two.msh")
        for deck in [read(SAMPLES[name], name)]
        for sheet in [sheet_of(deck)]
    }
    titles = {name: [one.title for one in shells] for name, shells in found.items()}
    assert titles == {
        "deck.k": ["a part · PID 7 · 1.2 mm"],
        "deck.inp": ["skin · PID 1 · 1.25 mm"],
        "deck_0000.rad": ["a part · PID 5 · 1.3 mm", "PID 6 · no thickness"],
        "two.msh": ["PID 1 · no thickness", "PID 2 · no thickness"],
    }
    assert [one.elements for one in found["deck.k"]] == [2]


def test_a_med_file_is_refused_in_words_with_a_way_round(tmp_path: Path):
    (tmp_path / "part.med").write_bytes(b"\x89HDF")
    with pytest.raises(FileError, match="a MED file, .*gmsh -0 -format msh22"):
        read_part(tmp_path / "part.med")
