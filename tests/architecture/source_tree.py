# SPDX-License-Identifier: LGPL-2.1-or-later
"""What belongs to the repository, and where the layers lie in it."""
import os
from collections.abc import Callable, Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
KERNEL = ROOT / "core" / "sheetmorph"
BINDINGS = ROOT / "bindings"
PACKAGE = ROOT / "bindings" / "python" / "sheetmorph"
WORKBENCH = ROOT / "Mod" / "SheetMorph" / "freecad" / "sheetmorph"

# Left out: what a build or a checkout may leave in the repository's folder.
IGNORED = {".git", "__pycache__", ".pytest_cache"}


def is_ignored(name: str) -> bool:
    """True for folders that `.gitignore` keeps out."""
    return name in IGNORED or name.startswith("build")


def files(*endings: str, below: Path = ROOT) -> list[Path]:
    """The files of the repository with these endings (all without any), in order."""
    found = []
    for where, folders, names in os.walk(below):
        folders[:] = sorted(name for name in folders if not is_ignored(name))
        found += [Path(where) / name for name in sorted(names)]
    return [path for path in found if not endings or path.suffix in endings]


def label(path: Path) -> str:
    """A path as people say it: relative to the repository."""
    return path.relative_to(ROOT).as_posix()


def faults_in(paths: Iterable[Path], find: Callable[[Path], list[str]]) -> dict[str, list[str]]:
    """The faults of every file that has some: empty if all is well."""
    found = {label(path): find(path) for path in paths}
    return {name: faults for name, faults in found.items() if faults}
