# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Nastran deck whose name ends with .inp."""
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_a_nastran_deck_called_inp_is_refused_with_its_own_ending(
    case: Callable[[str], Path],
) -> None:
    ended = sheetmorph("copy", "strip.inp", "-o", "out", folder=case("17"))
    assert ended.status == 2
    assert "this is Nastran bulk data" in ended.err and 'give it the ending ".bdf"' in ended.err
