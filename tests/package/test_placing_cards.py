# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks whose nodes move after they are read: copied to the byte, refused by all that morphs."""

from __future__ import annotations

from pathlib import Path

import pytest

from deck_samples import ABAQUS, DYNA, NASTRAN, RADIOSS
from sheetmorph import FileError, read_part
from sheetmorph.cli import main

TRANSFORM = b"*INCLUDE_TRANSFORM\nsub.k\n%10d\n\n%10s%10s%10s\n%10d\n"
SHELL = b"*NODE\n%8d%16s%16s%16s\n" % (41, b"0.", b"0.", b"0.")


def dyna(card: bytes) -> bytes:
    return DYNA.replace(b"*END\n", card + b"*END\n")


def included(offset: int, factors: tuple[bytes, bytes, bytes], transformation: int) -> bytes:
    return dyna(TRANSFORM % (offset, *factors, transformation))


def radioss(card: bytes) -> bytes:
    return RADIOSS.replace(b"/END\n", card + b"/END\n")


ONE = (b"1.0", b"1.0", b"1.0")
PLACED = {
    "tra.rad": (radioss(b"/TRANSFORM/TRA/1\nshift\n         4                   5\n"),
                "/TRANSFORM/TRA/1"),
    "sub.rad": (radioss(b"//SUBMODEL/3/7\nsub\n         0\n//ENDSUB\n"), "/SUBMODEL/3/7"),
    "node.k": (dyna(b"*NODE_TRANSFORM\n         1         4\n"), r"\*NODE_TRANSFORM"),
    "merge.k": (dyna(b"*NODE_MERGE_SET\n         4\n"), r"\*NODE_MERGE_SET"),
    "first.k": (included(0, ONE, 1), r"\*INCLUDE_TRANSFORM"),
    "shift.k": (included(1, ONE, 0), r"\*INCLUDE_TRANSFORM"),
    "inch.k": (included(0, (b"1.0", b"1.0", b"25.4"), 0), r"\*INCLUDE_TRANSFORM"),
    "named.k": (dyna(b"*INCLUDE_TRANSFORM\nsub.k\n\n\n\n&anywhere\n"), r"\*INCLUDE_TRANSFORM"),
    "map.inp": (ABAQUS + b"*NMAP, NSET=all\n1.,\n", r"\*NMAP"),
    "copy.inp": (ABAQUS + b"*ncopy, oldset=all, change number=10, shift\n1.,\n\n", r"\*NCOPY"),
    "loc.bdf": (NASTRAN.replace(b"ENDDATA", b"SELOC,1,1,2,3,4,5,6\nENDDATA"), "SELOC"),
}  # fmt: skip


@pytest.mark.parametrize("name", sorted(PLACED))
def test_it_is_copied_and_not_morphed(name: str, tmp_path: Path, capsys):
    data, card = PLACED[name]
    (tmp_path / name).write_bytes(data)
    (tmp_path / "sub.k").write_bytes(b"*KEYWORD\n" + SHELL + b"*END\n")
    assert main(["copy", str(tmp_path / name), "-o", str(tmp_path / "out")]) == 0
    assert "the deck cannot be deformed" in capsys.readouterr().out
    assert (tmp_path / "out" / name).read_bytes() == data
    with pytest.raises(FileError, match=f"{card} .*: the deck can be copied") as told:
        read_part(tmp_path / name)
    line = data.splitlines()[told.value.line - 1].upper()
    assert line.split(b",")[0].split(b"/")[-1].strip(b"*") in told.value.what.encode()
    assert "without the card" in told.value.todo
    assert main(["init", str(tmp_path / name), "-o", str(tmp_path / "recipe.json")]) == 2
    assert "the deck can be copied" in capsys.readouterr().err
    assert not (tmp_path / "recipe.json").exists()


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("sub.rad", radioss(b"//SUBMODEL/3\nsub\n         0         0\n//ENDSUB\n")),
        ("plain.k", included(0, ONE, 0)),
        ("kelvin.k", included(0, (b"1.0", b"1.0", b"       1.0      FtoC"), 0)),
        ("ngen.inp", ABAQUS.replace(b"*System", b"*NGEN\n1,2,1\n*System")),
    ],
    ids=["no offset", "no transformation", "temperatures", "between two nodes"],
)
def test_what_moves_nothing_is_read(name: str, data: bytes, tmp_path: Path):
    (tmp_path / name).write_bytes(data)
    (tmp_path / "sub.k").write_bytes(b"*KEYWORD\n" + SHELL + b"*END\n")
    assert len(read_part(tmp_path / name).mesh.triangles)


def test_a_submodel_ends_the_cards_before_it(tmp_path: Path):
    """Its title and offsets are no nodes."""
    data = RADIOSS.replace(b"/SHELL/5\n", b"//SUBMODEL/3\n77\n         0\n/SHELL/5\n")
    (tmp_path / "a.rad").write_bytes(data)
    assert read_part(tmp_path / "a.rad").mesh.ids.tolist() == [1, 2, 3, 4]
