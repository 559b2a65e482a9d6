# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stages the add-on: the workbench, the Python package, its compiled modules and the resources.

Copies what changed and removes what vanished, so that a staged folder is always what a fresh one
would be. The manual joins them if `./sheetmorph docs` has built it.
Called by the build: stage.py SOURCE STAGED [MODULE or TRANSLATION ...]
"""
import filecmp
import os
import shutil
import sys
import tempfile
from pathlib import Path

# Source folder or file below the repository -> its place in the add-on.
PLACES = {
    "Mod/SheetMorph": "",
    "bindings/python/sheetmorph": "sheetmorph",
    "resources": "resources",
    "package.xml": "package.xml",
    "README.md": "README.md",
    "CONTRIBUTING.md": "CONTRIBUTING.md",
    "CHANGELOG.md": "CHANGELOG.md",
    "LICENSE": "LICENSE",
}
LEFT_OUT_FOLDERS = {"__pycache__", ".pytest_cache", "packaging"}
LEFT_OUT_ENDINGS = (".pyc", "~", ".swp", ".orig")


def files_below(folder: Path) -> list[Path]:
    """The files that belong to an add-on below a folder, relative to it."""
    found = []
    for where, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name not in LEFT_OUT_FOLDERS]
        kept = [name for name in names if not name.endswith(LEFT_OUT_ENDINGS)]
        found += [(Path(where) / name).relative_to(folder) for name in kept]
    return found


def wanted_files(source: Path, modules: list[Path]) -> dict[Path, Path]:
    """Path in the add-on -> file it is a copy of."""
    wanted = {}
    for origin, place in PLACES.items():
        if (source / origin).is_file():
            wanted[Path(place)] = source / origin
        else:
            for name in files_below(source / origin):
                wanted[Path(place) / name] = source / origin / name
    for module in modules:
        wanted[place_of_built(module)] = module
    return wanted


def built_manual(staged: Path) -> dict[Path, Path]:
    """Path in the add-on -> page of the manual, of the build that the staged folder is in."""
    pages = staged.resolve().parents[1] / "docs" / "html"
    if not (pages / "index.html").is_file():
        return {}
    return {Path("manual") / name: pages / name for name in files_below(pages)}


def place_of_built(file: Path) -> Path:
    """The place in the add-on of a file that the build made: a module or compiled translation."""
    folder = "resources/translations" if file.suffix == ".qm" else "sheetmorph"
    return Path(folder) / file.name


def copy_if_changed(origin: Path, target: Path) -> None:
    """Copies beside the target and renames: a running FreeCAD keeps the module it has mapped."""
    if target.is_file() and filecmp.cmp(origin, target, shallow=False):
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, fresh = tempfile.mkstemp(dir=target.parent, prefix=".fresh-")
    os.close(handle)
    shutil.copy2(origin, fresh)
    os.replace(fresh, target)


def remove_vanished(staged: Path, wanted: dict[Path, Path]) -> None:
    """Removes files no longer wanted, compiled Python of vanished sources, and empty folders."""
    for where, _, names in os.walk(staged, topdown=False):
        folder = Path(where)
        for name in names:
            path = folder / name
            if path.suffix == ".pyc":
                source = folder.parent / (name.split(".")[0] + ".py")
                keep = source.relative_to(staged) in wanted
            else:
                keep = path.relative_to(staged) in wanted
            if not keep:
                path.unlink()
        if folder != staged and not any(folder.iterdir()):
            folder.rmdir()


def stage(source: Path, staged: Path, modules: list[Path]) -> None:
    """Makes the staged folder equal to what the sources say."""
    wanted = wanted_files(source, modules) | built_manual(staged)
    staged.mkdir(parents=True, exist_ok=True)
    for target, origin in wanted.items():
        copy_if_changed(origin, staged / target)
    remove_vanished(staged, wanted)


if __name__ == "__main__":
    stage(Path(sys.argv[1]), Path(sys.argv[2]), [Path(name) for name in sys.argv[3:]])
