# SPDX-License-Identifier: LGPL-2.1-or-later
"""A byte order mark in front of a line of an OBJ file."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


def test_a_mark_at_the_beginning_of_a_file_changes_nothing(case: Callable[[str], Path]) -> None:
    folder = case("31")
    marked = sheetmorph("doctor", "bom_unused.obj", folder=folder)
    plain = sheetmorph("doctor", "plain.obj", folder=folder)
    (one,), (other,) = (json.loads(done.out)["files"] for done in (marked, plain))
    # The first vertex, which the mark stands before, has no face; it is there now, as a finding.
    assert one["vertices"] == other["vertices"] + 1 and one["counts"]["unused_vertices"] == 1
    assert one["components"] == other["components"] and one["triangles"] == other["triangles"]
    assert sum(piece["area"] for piece in one["components"]) == pytest.approx(800.0)


def test_a_mark_further_on_is_refused_with_its_line(case: Callable[[str], Path]) -> None:
    done = sheetmorph("doctor", "midbom.obj", folder=case("31"))
    assert done.status == 2 and "line 16: there is a byte order mark" in done.err
