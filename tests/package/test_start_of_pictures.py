# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is loaded before a picture appears: `show` answers in about a second, most of it imports."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from sheetmorph.pictures import drawing

PAINTER = Path(drawing.__file__).with_name("painter.py")


def loaded_by(lines: str, *arguments: str) -> set[str]:
    """The modules of a new interpreter after it ran some lines."""
    told = f"{lines}\nimport sys\nprint(*sys.modules, file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-c", told, *arguments], capture_output=True, text=True, check=True
    )
    return set(done.stderr.split())


def test_the_painter_loads_numpy_and_the_modules_of_vtk_that_it_draws_with():
    modules = loaded_by("import runpy, sys; runpy.run_path(sys.argv[1])", str(PAINTER))
    assert {"numpy", "vtkmodules.vtkRenderingCore"} <= modules
    assert not {"vtk", "vtkmodules.all", "sheetmorph", "scipy", "matplotlib"} & modules
    assert len([name for name in modules if name.startswith("vtkmodules.vtk")]) < 30


def test_show_loads_neither_vtk_nor_what_other_commands_and_files_need(folder: Path):
    lines = "import sys; from sheetmorph.cli import main; assert main(sys.argv[1:]) == 0"
    modules = loaded_by(lines, "show", "recipe.json", "-o", "rest.png", "--quiet")
    assert Path("rest.png").exists() and "sheetmorph.morph.showing" in modules
    others = {"vtkmodules", "scipy", "meshio", "matplotlib", "FreeCAD", "Part", "lxml", "dask"}
    assert not others & modules
    assert not [
        name for name in modules if name.startswith(("sheetmorph.study", "sheetmorph.flat"))
    ]
