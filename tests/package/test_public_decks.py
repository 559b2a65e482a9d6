# SPDX-License-Identifier: LGPL-2.1-or-later
"""Public decks of Nastran, LS-DYNA, Radioss and CalculiX: the same bytes, or refused in words."""

from __future__ import annotations

import gzip
import io
import re
from collections import Counter
from pathlib import Path

import pytest

from sheetmorph import FileError
from sheetmorph.decks import read_deck

SHARED = Path(__file__).parents[3] / "shared" / "data" / "09-decks"
CALCULIX = Path("/usr/share/doc/calculix-ccx-test/examples/test")
# What is refused, as people read it, and of which format.
REASONS = {
    r'the include "[^"]*" does not exist': "an include is not there",
    r"a deck of several models is not read": "several models in one deck",
    r"is defined twice, differently": "defined twice, differently",
    r"is not a whole number": "a field that is no number",
}


def outcome(path: Path, stand_ins: bool = False) -> str:
    """ "same", or why it is refused; stand_ins: includes that are not there are empty."""
    try:
        deck = read_deck(path)
    except FileError as error:
        assert error.line is not None and error.todo
        found = [name for rule, name in REASONS.items() if re.search(rule, error.what)]
        assert found, str(error)
        missing = re.search(r'the include "([^"]*)" does not exist', error.what)
        if stand_ins and missing:
            (path.parent / missing.group(1)).write_bytes(b"")
            return outcome(path, stand_ins)
        return found[0]
    for number, text in enumerate(deck.texts):
        out = io.BytesIO()
        deck.save(deck.points, number, out)
        assert out.getvalue() == text.data, path.name
    return "same"


def needed(folder: Path, what: str) -> list[Path]:
    if not folder.is_dir():
        pytest.skip(f"{what} is not here")
    return sorted(path for path in folder.iterdir() if path.is_file())


COUNTS = {
    "nastran": {
        "same": 114, "an include is not there": 12, "several models in one deck": 4,
        "defined twice, differently": 1, "a field that is no number": 1,
    },
    "ls-dyna": {"same": 18},
    "radioss": {"same": 3, "an include is not there": 25},
}  # fmt: skip


@pytest.mark.parametrize("form", sorted(COUNTS))
def test_every_deck_comes_back_or_is_refused_in_words(form: str):
    paths = needed(SHARED / form, "shared/data/09-decks")
    assert Counter(map(outcome, paths)) == COUNTS[form]


def test_decks_whose_include_is_missing_come_back_with_an_empty_one(tmp_path: Path):
    for path in needed(SHARED / "radioss", "shared/data/09-decks"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
        assert outcome(tmp_path / path.name, stand_ins=True) == "same"


def test_the_decks_of_calculix_come_back(tmp_path: Path):
    names = []
    for path in needed(CALCULIX, "calculix-ccx-test"):
        if path.name.endswith((".inp", ".inp.gz")):
            data = path.read_bytes()
            target = tmp_path / path.name.removesuffix(".gz")
            target.write_bytes(gzip.decompress(data) if path.suffix == ".gz" else data)
            names.append(target)
    assert Counter(map(outcome, names)) == {"same": len(names)}
