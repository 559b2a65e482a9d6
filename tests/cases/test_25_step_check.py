# SPDX-License-Identifier: LGPL-2.1-or-later
"""The STEP that comes back passes FreeCAD's Check Geometry with its Boolean check."""
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

CHECK = """
import Part
shape = Part.Shape()
shape.read({!r})
try:
    shape.check(True)
    print("faults: 0", shape.isValid(), shape.isClosed())
except ValueError as error:
    print("faults:", str(error).count(chr(10)) + 1, error)
"""


def test_the_boolean_check_finds_nothing(case: Callable[[str], Path]) -> None:
    folder = case("25")
    done = sheetmorph("run", "y5.json", "-o", "out", "--quiet", folder=folder)
    assert done.status == 0, done.said
    (written,) = (folder / "out").glob("*.st*p")
    script = folder / "check.py"
    script.write_text(CHECK.format(str(written)))
    try:
        checked = subprocess.run(
            ["freecadcmd", str(script)], capture_output=True, text=True, timeout=300, check=False
        )
    except FileNotFoundError:
        pytest.skip("freecadcmd is not on the path")
    assert "faults: 0 True True" in checked.stdout, checked.stdout[-2000:]
