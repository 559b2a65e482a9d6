# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only importer of the `sheetmorph` package and of its compiled kernel `sheetmorph._core`.

The workbench loads and documents open without them; who needs them calls `load()` and gets one
sentence that says what is wrong and what to do.
"""

from __future__ import annotations

import importlib
import importlib.util
import platform
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from types import ModuleType

KERNEL_API = 1
"""The version of the kernel's interface that this workbench speaks."""

REPAIR = "Build and install SheetMorph again with `./sheetmorph install`, then restart FreeCAD."


class KernelError(RuntimeError):
    """The kernel cannot be used; the message says why and what to do."""


def load() -> ModuleType:
    """Return the module `sheetmorph` with a kernel that this workbench can use.

    Raises KernelError: the package is absent, the compiled kernel is absent, was built for
    another Python, cannot be loaded, or speaks another version of the interface.
    """
    if importlib.util.find_spec("sheetmorph") is None:
        raise KernelError(
            f"The Python package 'sheetmorph' is not installed beside the workbench. {REPAIR}"
        )
    try:
        package = importlib.import_module("sheetmorph")
        core = importlib.import_module("sheetmorph._core")
    except (ImportError, OSError, SyntaxError) as error:
        raise KernelError(explain_failure(package_folder(), error)) from error
    found = getattr(core, "KERNEL_API", None)
    if found != KERNEL_API:
        raise KernelError(
            f"The kernel has interface version {found}, but this workbench needs "
            f"version {KERNEL_API}: they come from different versions of "
            f"SheetMorph. {REPAIR}"
        )
    return package


def core() -> ModuleType:
    """Return the compiled module `sheetmorph._core`; raises KernelError as `load` does."""
    load()
    return importlib.import_module("sheetmorph._core")


def labels_module() -> ModuleType:
    """Return the module of the package that knows what files call parts of a mesh."""
    load()
    return importlib.import_module("sheetmorph.base.labels")


def selecting_module() -> ModuleType:
    """Return the module of the package that resolves selectors."""
    load()
    return importlib.import_module("sheetmorph.selecting")


def splitting() -> ModuleType:
    """Return the module of the package that splits files into parts."""
    load()
    return importlib.import_module("sheetmorph.recipe.splitting")


def cad_module() -> ModuleType:
    """Return the module of the package that reads and writes CAD shapes."""
    load()
    return importlib.import_module("sheetmorph.cad")


def certifying() -> ModuleType:
    """Return the module of the package that certifies what was written."""
    load()
    return importlib.import_module("sheetmorph.certifying")


def element_measures() -> ModuleType:
    """Return the module of the package that measures shell elements."""
    load()
    return importlib.import_module("sheetmorph.measuring.quality")


def flat() -> ModuleType:
    """Return the module of the package that lays sheets flat."""
    load()
    return importlib.import_module("sheetmorph.flat")


def stretches() -> type:
    """Return the class of the package that measures stretch, a mesh at a time."""
    load()
    return importlib.import_module("sheetmorph.measuring.strain").PrincipalStretches


def studies() -> ModuleType:
    """Return the module of the package that computes studies."""
    load()
    return importlib.import_module("sheetmorph.study")


def is_available() -> bool:
    """Whether `load` would succeed."""
    try:
        load()
    except KernelError:
        return False
    return True


def package_folder() -> Path | None:
    """Return the folder of the `sheetmorph` package, None if there is none."""
    spec = importlib.util.find_spec("sheetmorph")
    places = list(spec.submodule_search_locations or []) if spec else []
    return Path(places[0]).resolve() if places else None


def explain_failure(folder: Path | None, error: Exception) -> str:
    """Return one sentence on why the kernel in `folder` failed with `error`, and what to do."""
    missing, reason = getattr(error, "name", None) or "", " ".join(str(error).split())
    if isinstance(error, ModuleNotFoundError) and missing.split(".")[0] != "sheetmorph":
        return (
            f"SheetMorph needs the Python module '{missing}', which is not installed for Python "
            f"{sys.version.split()[0]}. Install it (Debian: python3-{missing.split('.')[0]}), "
            "then restart FreeCAD."
        )
    if not isinstance(error, ImportError):
        return f"The package in {folder} cannot be loaded ({reason}). {REPAIR}"
    found = compiled_kernels(folder)
    if not found:
        return f"The compiled kernel sheetmorph._core is not in {folder}. {REPAIR}"
    if not any(is_loadable_here(name) for name in found):
        return (
            f"The kernel was built for another Python: found {', '.join(found)}, this FreeCAD "
            f"needs _core{EXTENSION_SUFFIXES[0]}. {REPAIR}"
        )
    return f"The kernel in {folder} cannot be loaded ({reason}). {REPAIR}"


def compiled_kernels(folder: Path | None) -> list[str]:
    """Return the names of the compiled kernels in `folder`, whatever Python they are for."""
    if folder is None:
        return []
    return sorted(
        path.name
        for pattern in ("_core*.so", "_core*.pyd", "_core*.dylib")
        for path in folder.glob(pattern)
    )


def cad_workers(folder: Path | None) -> list[str]:
    """Return the names of the programs in `folder` that read and write CAD files."""
    return [] if folder is None else sorted(path.name for path in folder.glob("sheetmorph-cad*"))


def is_loadable_here(name: str) -> bool:
    """Whether the running interpreter would consider a file of this name as `_core`."""
    return any(name == f"_core{suffix}" for suffix in EXTENSION_SUFFIXES)


def report() -> str:
    """Return the text of *Check Installation*: versions, places and the state, ready to copy."""
    folder = package_folder()
    lines = [
        f"Python: {sys.version.split()[0]} ({sys.implementation.cache_tag})",
        f"Platform: {platform.platform()}",
        f"FreeCAD: {freecad_version()}",
        f"Workbench: {Path(__file__).resolve().parent.parent}",
        f"Workbench needs kernel interface: {KERNEL_API}",
        f"Package: {folder if folder else 'not found'}",
        f"Compiled kernels found: {', '.join(compiled_kernels(folder)) or 'none'}",
        f"Compiled kernel needed: _core{EXTENSION_SUFFIXES[0]}",
        f"CAD worker found: {', '.join(cad_workers(folder)) or 'none'}",
    ]
    try:
        load()
    except KernelError as error:
        return "\n".join([*lines, f"State: not usable. {error}"])
    for key, value in sorted(core().abi_info().items()):
        lines.append(f"Kernel {key}: {value}")
    return "\n".join([*lines, "State: ready."])


def freecad_version() -> str:
    """Return FreeCAD's version as text, `not running` outside FreeCAD."""
    freecad = sys.modules.get("FreeCAD")
    return ".".join(freecad.Version()[:3]) if freecad else "not running"
