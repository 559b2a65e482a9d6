# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the kernel, as a person at the workbench reads them; needs no FreeCAD."""

import pytest

from freecad.sheetmorph.tools.words import counted, exact_length


@pytest.mark.parametrize(
    ("said", "read"),
    [
        (
            "'A' and 'B' both move 88 vertices (15771, 15772, 15773 and 85 more); take these out",
            "'A' and 'B' both move 88 vertices; take these out",
        ),
        (
            "feature 'F': it would turn over triangles 408, 409, 410 and 1 more; 3.2 mm",
            "feature 'F': it would turn over 4 triangles; 3.2 mm",
        ),
        ("vertices 3, 4 are not in part P", "2 vertices are not in part P"),
        ("vertices 3, 4 and 5 are not in part P", "3 vertices are not in part P"),
        ("region 'vertices of 3' has no vertices on part 'P 1'", None),
        ("vertex 7 is not in part P", None),
        ("it has 12 vertices, 3 more than its file", None),
    ],
)
def test_lists_of_numbers_become_their_count(said, read):
    assert counted(said) == (said if read is None else read)


@pytest.mark.parametrize(
    ("length", "read"), [(0.0002, "0.0002 mm"), (3e-9, "0.000000003 mm"), (12.0, "12 mm")]
)
def test_a_length_to_be_used_is_read_in_mm_however_small(length: float, read: str):
    assert exact_length(length) == read
