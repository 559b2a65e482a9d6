# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names that a STEP file breaks over lines."""
import json
from collections.abc import Callable
from pathlib import Path

from conftest import sheetmorph

NAME = "Kühlblech Größe für Träger_1"


def test_a_name_over_two_lines_is_the_same(case: Callable[[str], Path]) -> None:
    folder = case("13")
    for file in ("name_on_one_line.step", "name_over_two_lines.step"):
        found = json.loads(sheetmorph("find", file, folder=folder).out)
        (part,) = found["parts"]
        assert [name.split("/")[-1] for name in part["parts"]] == [NAME]
