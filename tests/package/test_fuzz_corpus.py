# SPDX-License-Identifier: LGPL-2.1-or-later
"""What once was trouble for a reader is read or refused, and a short run of the fuzzing itself."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[1] / "decks"))

from fuzzing import CORPUS, READERS, mutated, seeds, check_case  # noqa: E402

KEPT = sorted(CORPUS.glob("*"))


def test_there_is_a_corpus():
    assert KEPT


@pytest.mark.parametrize("path", KEPT, ids=lambda path: path.name)
def test_what_once_was_trouble_is_read_or_refused(path: Path):
    check_case(path.name, path.read_bytes())


@pytest.mark.parametrize("reader", sorted(READERS))
def test_mutated_files_are_read_or_refused(reader: str):
    dice = random.Random(reader)
    given = seeds(reader)
    for _ in range(60):
        name, data = dice.choice(given)
        check_case(name, mutated(data, dice))
