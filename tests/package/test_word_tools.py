# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person at the workbench reads them; needs no FreeCAD."""

import pytest

from freecad.sheetmorph.tools.words import exact_length


@pytest.mark.parametrize(
    ("length", "read"), [(0.0002, "0.0002 mm"), (3e-9, "0.000000003 mm"), (12.0, "12 mm")]
)
def test_a_length_to_be_used_is_read_in_mm_however_small(length: float, read: str):
    assert exact_length(length) == read
