# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks whose includes have names in UTF-8."""
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


@pytest.mark.parametrize("name", ["deck.bdf", "deck.k"])
def test_an_include_named_in_utf_8_is_read(case: Callable[[str], Path], name: str) -> None:
    folder = case("36")
    ended = sheetmorph("doctor", name, folder=folder)
    assert ended.status == 0 and "is not there" not in ended.said
    copied = sheetmorph("copy", name, "-o", "out", folder=folder)
    assert copied.status == 0 and "2 files" in copied.out
    include = f"blech ü{Path(name).suffix}"
    assert (folder / "out" / include).read_bytes() == (folder / include).read_bytes()
