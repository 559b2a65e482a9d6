# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is installed, and which Debian package brings what is missing."""

from __future__ import annotations

import importlib
import os
import platform
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from ..base.errors import KernelError
from ..base.kernel import load_kernel
from ..base.version import __version__
from ..cad.worker import PROGRAM

# Name, module, Debian package and use; nothing works without the first three.
_MODULES = (
    ("numpy", "numpy", "python3-numpy", "everything"),
    ("jsonschema", "jsonschema", "python3-jsonschema", "recipes"),
    ("meshio", "meshio", "python3-meshio", "files such as VTK and VTU"),
    ("scipy", "scipy", "python3-scipy", "samples of studies"),
    ("Jinja2", "jinja2", "python3-jinja2", "pages of certificates and studies"),
    ("VTK", "vtkmodules.vtkCommonCore", "python3-vtk9", "pictures"),
)
_NEEDED = tuple(name for name, *_ in _MODULES[:3])
_BUILD = "run ./sheetmorph build"
_SECONDS = 20.0


@dataclass(frozen=True)
class Check:
    """One thing that was checked: todo names a remedy, and is_error means that nothing works."""

    name: str
    found: str
    todo: str = ""
    is_error: bool = False

    def __str__(self) -> str:
        return f"{self.name}: {'; '.join(filter(None, (self.found, self.todo)))}"


def checks() -> Iterator[Check]:
    """Check the installation, one thing after the other."""
    yield Check("SheetMorph", f"{__version__} in {Path(__file__).resolve().parents[1]}")
    yield Check("Python", f"{platform.python_version()} ({sys.executable})")
    yield _kernel()
    yield _cad_worker()
    yield from (_module(*entry) for entry in _MODULES)
    xvfb = shutil.which("Xvfb")
    yield Check("Xvfb", xvfb or "missing, needed for pictures", "" if xvfb else "install xvfb")
    freecad = shutil.which("freecad") or shutil.which("FreeCAD")
    missing = "missing, needed for the workbench"
    yield Check("FreeCAD", freecad or missing, "" if freecad else "install freecad")
    if freecad:
        yield _addon()


def _kernel() -> Check:
    try:
        core = load_kernel()
    except KernelError as error:
        return Check("kernel", str(error), is_error=True)
    told = ", ".join(f"{key} {value}" for key, value in sorted(core.abi_info().items()))
    return Check("kernel", f"{core.__version__} ({told})")


def _cad_worker() -> Check:
    """Start the worker without a request; it ends with 0."""
    try:
        done = subprocess.run(
            [str(PROGRAM)], stdin=subprocess.DEVNULL, capture_output=True, timeout=_SECONDS
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        reason = getattr(error, "strerror", None) or "does not end"
        return Check("CAD worker", f"{PROGRAM}: {reason}; no CAD file can be read", _BUILD)
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        todo = f"install libocct-data-exchange-dev and {_BUILD}"
        return Check("CAD worker", lines[-1] if lines else f"ends with {done.returncode}", todo)
    return Check("CAD worker", str(PROGRAM))


def _module(name: str, module: str, package: str, use: str) -> Check:
    try:
        found = importlib.import_module(module)
        return Check(name, getattr(found, "VTK_VERSION", None) or metadata.version(name))
    except ImportError as error:
        reason = "missing" if isinstance(error, ModuleNotFoundError) else f"broken ({error})"
        return Check(name, f"{reason}, needed for {use}", f"install {package}", name in _NEEDED)


def _addon() -> Check:
    """Find the add-on in the folders where FreeCAD looks."""
    data = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local/share") / "FreeCAD"
    homes = [Path(os.environ.get("FREECAD_USER_HOME") or data), data, *sorted(data.glob("v*"))]
    homes += [Path.home() / ".FreeCAD", Path("/usr/share/freecad"), Path("/usr/lib/freecad")]
    places = [home / "Mod" / "SheetMorph" for home in homes]
    place = next((place for place in places if os.path.lexists(place)), None)
    if place is None:
        return Check("FreeCAD add-on", "not installed", "run ./sheetmorph install")
    try:
        text = (place / "package.xml").read_text("utf-8")
    except OSError as error:
        return Check("FreeCAD add-on", f"{place}: {error.strerror}", "run ./sheetmorph install")
    found = re.search("<version>(.*)</version>", text)
    version = found[1] if found else "of unknown version"
    todo = "" if version == __version__ else "run ./sheetmorph install for this version"
    return Check("FreeCAD add-on", f"{version} in {place}", todo)
