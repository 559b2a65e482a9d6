# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output paths of a run: they must not overwrite its inputs and must be valid file paths."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ..base.errors import Fault, FileError, RecipeError
from .atomic import FileSet, require_file_place
from .identity import identity, is_one_of


@dataclass(frozen=True)
class Places:
    """The files of a run: read has recipe, pose and sources, parts has the targets in out."""

    read: Sequence[Path]
    out: Path
    parts: Sequence[Path]
    report: Path | None

    def check(self) -> None:
        """Check that no target is an input and that each can be a file. Raises RecipeError."""
        faults = _folder_faults(self.out)
        read = {identity(path) for path in self.read}
        for part in self.parts if not faults else ():
            if identity(part) in read:
                what = f"a part would overwrite the source file {part}"
                faults.append(Fault("-o", what, "choose another folder"))
            faults += _file_faults("-o", part)
        if self.report is not None and not faults:
            faults += self._report_faults(self.report)
        if faults:
            raise RecipeError(faults)

    def require_ours(self, files: FileSet) -> None:
        """Check before any work that files may overwrite the targets. Raises FileError."""
        files.reads += self.read
        for target in self.parts:
            files.require_ours(target)
        if self.report is not None:
            files.require_ours(self.report, "report")

    def _report_faults(self, report: Path) -> list[Fault]:
        if is_one_of(report, [self.out]):
            return [Fault("--report", f"{report} is the folder of the parts", "give a file name")]
        if is_one_of(report, self.parts):
            return [Fault("--report", f"{report} is the file of a part", "choose another file")]
        if is_one_of(report, self.read):
            return [Fault("--report", f"{report} is read by this run", "choose another file")]
        made = {folder.resolve() for folder in (self.out, *self.out.parents)}
        if not report.parent.is_dir() and report.parent.resolve() not in made:
            return [Fault(str(report), "its folder does not exist", "create the folder first")]
        return _file_faults("--report", report)


def _file_faults(where: str, path: Path) -> list[Fault]:
    try:
        require_file_place(path)
    except FileError as error:
        return [error.fault(where)]
    return []


def _folder_faults(out: Path) -> list[Fault]:
    existing = next(folder for folder in (out, *out.absolute().parents) if folder.exists())
    if not existing.is_dir():
        return [Fault("-o", f"{existing} is not a folder", "choose another folder")]
    if not os.access(existing, os.W_OK | os.X_OK):
        todo = "change its rights, or choose another folder"
        return [Fault("-o", f"{existing} cannot be written", todo)]
    return []
