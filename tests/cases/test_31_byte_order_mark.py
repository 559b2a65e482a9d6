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
