# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents whose files were damaged open with words, not with a traceback."""
import os
import subprocess
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

import sheetmorph

OPENED = """
import FreeCAD as App
document = App.openDocument({!r})
for obj in document.Objects:
    obj.touch()
document.recompute()
print("went on", len(document.Objects))
# FreeCAD 1.1 crashes at its end if a script read a mesh and the document is still open.
App.closeDocument(document.Name)
"""


def said_of(document: Path) -> str:
    """What freecadcmd prints when it opens and recomputes a document."""
    script = document.with_suffix(".py")
    script.write_text(OPENED.format(str(document)))
    (document.parent / "Mod").mkdir()
    (document.parent / "Mod" / "SheetMorph").symlink_to(Path(sheetmorph.__file__).parents[1])
    try:
        done = subprocess.run(
            ["freecadcmd", str(script)],
            capture_output=True, text=True, timeout=120, check=False, stdin=subprocess.DEVNULL,
            env={**os.environ, "FREECAD_USER_HOME": str(document.parent)},
        )  # fmt: skip
    except FileNotFoundError:
        pytest.skip("freecadcmd is not on the path")
    said = done.stdout + done.stderr
    assert "went on" in said and done.returncode == 0, said
    return said


def test_vertices_that_are_no_numbers_are_told(case: Callable[[str], Path]) -> None:
    said = said_of(case("40") / "vertices.FCStd")
    assert "IndexError" not in said and "RuntimeWarning" not in said, said
    assert "are damaged; pick them again" in said, said


@pytest.mark.parametrize("kept", [0.0, 0.5, 0.99])
def test_a_mesh_that_is_cut_short_is_told(kept: float, case: Callable[[str], Path]) -> None:
    sound = case("40") / "vertices.FCStd"
    damaged = sound.with_name("cut.FCStd")
    with zipfile.ZipFile(sound) as archive, zipfile.ZipFile(damaged, "w") as made:
        names = [name for name in archive.namelist() if name.endswith(".npz")]
        for name in archive.namelist():
            data = archive.read(name)
            made.writestr(name, data[: int(kept * len(data))] if name in names else data)
    assert names
    said = said_of(damaged)
    assert "BadZipFile" not in said and "EOFError" not in said, said
    assert "in this document is damaged" in said, said
