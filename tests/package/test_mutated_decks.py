# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks with anything wrong in them are read or refused in words: no crash, no other bytes."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest

from deck_samples import deck_samples
from sheetmorph import FileError
from sheetmorph.decks import Deck, read_deck, sheet_of

hypothesis = pytest.importorskip("hypothesis")
strategies = hypothesis.strategies

SAMPLES = {name: data for name, data in deck_samples().items() if not name.startswith("crlf")}
TOKENS = (
    *(b"*", b"$", b",", b"+", b"\t", b"\n", b"&p", b"1e999", b"-", b"nan", b"9" * 20),
    *(b"*NODE\n", b"GRID    ", b"*INCLUDE\n", b"/NODE\n", b"BEGIN BULK\n", b"$Nodes\n", b"0"),
    *(b"\0", b"\xff", b"*END\n", b"CORD1R,1,1,1,1\n", b"=,*1,=\n", b" " * 9),
)
EDITS = strategies.lists(
    strategies.tuples(
        strategies.floats(0, 1), strategies.integers(0, 60), strategies.sampled_from((b"", *TOKENS))
    ),
    min_size=1,
    max_size=6,
)


def mutated(data: bytes, edits: list[tuple[float, int, bytes]]) -> bytes:
    """The data with some bytes taken out and others put in."""
    for place, length, new in edits:
        begin = int(place * len(data))
        data = data[:begin] + new + data[begin + length :]
    return data


def read(data: bytes, name: str) -> Deck:
    return read_deck(Path("nowhere") / name, lambda path: data)


def written(deck: Deck, positions: np.ndarray) -> bytes:
    out = io.BytesIO()
    deck.save(positions, 0, out)
    return out.getvalue()


@pytest.mark.parametrize("name", sorted(SAMPLES))
@hypothesis.settings(max_examples=60, derandomize=True)
@hypothesis.given(edits=EDITS)
def test_a_mutated_deck_is_read_or_refused(name: str, edits: list):
    data = mutated(SAMPLES[name], edits)
    try:
        deck = read(data, name)
    except FileError as error:
        assert error.what and error.todo and "Traceback" not in str(error)
        return
    assert written(deck, deck.points) == data
    free = ~np.isin(deck.ids, sorted(deck.raw.locked))
    wanted = deck.points + np.where(free[:, None], 0.25, 0.0)
    try:
        again = read(written(deck, wanted), name)
        sheet_of(deck)
    except FileError as error:
        assert error.what  # a number that does not fit, a shell without its nodes
        return
    assert np.array_equal(again.ids, deck.ids)


def test_an_id_beyond_all_numbers_is_none():
    data = SAMPLES["deck.k"].replace(b"         5         6\n", b"      1e30         6\n")
    welds = [block for block in read(data, "deck.k").elements if block.kind == "weld"]
    assert welds[0].nodes.tolist() == [[0, 6]]
