# SPDX-License-Identifier: LGPL-2.1-or-later
"""A byte order mark in front of a line of an OBJ file."""
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph


def test_a_mark_at_the_beginning_of_a_file_changes_nothing(case: Callable[[str], Path]) -> None:
    folder = case("31")
    marked = sheetmorph("doctor", "bom_unused.obj", folder=folder)
    plain = sheetmorph("doctor", "plain.obj", folder=folder)
    assert marked.out.replace("bom_unused", "plain") == plain.out


def test_a_mark_further_on_is_refused_with_its_line(case: Callable[[str], Path]) -> None:
    done = sheetmorph("doctor", "midbom.obj", folder=case("31"))
    assert done.status == 2 and "line 16: a byte order mark" in done.err
