# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a recipe file to a folder of deformed parts: everything is checked before a file appears."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from .errors import KernelError, RecipeError
from .files import FileSet
from .places import Places
from .recipe import prepare, read_json
from .recipe.parts import Source
from .report import WrittenPart, make_report, unsettled_failures
from .session import Result, Session


class CertificateError(RuntimeError):
    """A form feature lost its form, or a part is not solved to its end; ``report`` tells more."""

    def __init__(self, report: dict[str, Any]):
        unsettled = unsettled_failures(report)
        rigid = [text for text in report["certificate"]["failures"] if text not in unsettled]
        if rigid:
            tol = report["tolerance"]
            unsettled.append(f"form features are not rigid to {tol:.3g} mm: {'; '.join(rigid)}")
        super().__init__("; ".join(unsettled))
        self.report = report


# Beyond it, in vertices, trying out a recipe takes too long for a check.
_TOO_MANY_TO_TRY = 300_000


def check(recipe_path: str | Path) -> list[str]:
    """Validate a recipe file and the parts it names, and try it out; nothing is written.

    Returns what could not be checked, one sentence each. Raises RecipeError, SolverError of the
    kernel (a RuntimeError).
    """
    path = Path(recipe_path)
    recipe = read_json(path)
    with _named(path):
        parts = prepare(recipe, path.parent)
        if sum(len(mesh.points) for mesh in parts.meshes.values()) > _TOO_MANY_TO_TRY:
            return ["not tried out, the meshes are too large for it"]
        try:
            Session(recipe, parts.meshes, _keep_going, found=parts.found).deform(exact=False)
        except KernelError as error:
            return [f"not tried out: {error}"]
    return []


def run(
    recipe_path: str | Path,
    out_dir: str | Path,
    pose: str | Path | dict[str, Any] | None = None,
    report: str | Path | None = None,
    *,
    files: FileSet | None = None,
) -> dict[str, Any]:
    """Deform the parts of a recipe file and write them under out_dir; returns the report.

    pose: instead of the recipe's a pose, the name of one of its `poses`, or the path of a JSON file
    with one; report: path to write
    the report to; files: a new FileSet for the parts, whose ``committed`` tells, also after an
    interrupt, whether they were written. Raises RecipeError, FileError, KernelError,
    CertificateError, OSError; then no part is written.
    """
    path, out = Path(recipe_path), Path(out_dir)
    recipe = read_json(path)
    pose = _named_pose(recipe, pose)
    pose_path = None if pose is None or isinstance(pose, dict) else Path(pose)
    begin = time.perf_counter()
    with _named(path):
        parts = prepare(recipe, path.parent)
        read = [path, *([pose_path] if pose_path else []), *(s.file.path for s in parts.sources)]
        targets = [out / source.file.output_name for source in parts.sources]
        places = Places(read, out, targets, None if report is None else Path(report))
        places.check()
        wanted = pose if pose_path is None else read_json(pose_path)
        reading = time.perf_counter() - begin
        session = Session(recipe, parts.meshes, _keep_going, found=parts.found)
    begin = time.perf_counter()
    with _named(pose_path or path):
        result = session.deform(wanted)
    timings = {"read": reading, "deform": time.perf_counter() - begin}
    _certify(result, timings, report)
    return _Writer(result, parts.sources, places, timings).write(files or FileSet())


def _named_pose(recipe: Any, pose: Any) -> Any:
    """The pose of the recipe that a name stands for; anything else as it is."""
    named = recipe.get("poses") if isinstance(recipe, dict) else None
    is_name = isinstance(pose, str) and isinstance(named, dict) and pose in named
    return named[pose] if is_name else pose


def _keep_going(_fraction: float, _task: str) -> bool:
    """Being called is enough: Python handles Ctrl-C here."""
    return True


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Faults inside say which recipe they are in."""
    try:
        yield
    except RecipeError as error:
        faults = [replace(fault, where=f"{path}, {fault.where}") for fault in error.faults]
        raise RecipeError(faults) from error


def _certify(result: Result, timings: dict[str, float], report: str | Path | None) -> None:
    found = make_report(result, None, timings)
    if found["certificate"]["passed"]:
        return
    if report is not None:
        with FileSet() as out:
            _put_report(out, Path(report), found)
            out.commit()
    raise CertificateError(found)


@dataclass(frozen=True)
class _Writer:
    """Writes the parts of a certified result and the report, all or none."""

    result: Result
    sources: list[Source]
    places: Places
    timings: dict[str, float]

    def write(self, files: FileSet) -> dict[str, Any]:
        """Returns the report."""
        out = self.places.out
        new_folders = [folder for folder in (out, *out.parents) if not folder.exists()]
        try:
            with files:
                out.mkdir(parents=True, exist_ok=True)
                report = self._fill(files)
                files.commit()
        finally:
            if not files.committed:
                _remove_empty(new_folders)
        return report

    def _fill(self, files: FileSet) -> dict[str, Any]:
        begin = time.perf_counter()
        parts: dict[str, WrittenPart] = {}
        for source in self.sources:
            parts |= self._written_parts(files, source)
        taken = {**self.timings, "write": time.perf_counter() - begin}
        report = make_report(self.result, parts, taken)
        if self.places.report is not None:
            _put_report(files, self.places.report, report)
        return report

    def _written_parts(self, files: FileSet, source: Source) -> dict[str, WrittenPart]:
        """Write the file of some parts; what it holds of each, by part name."""
        file = source.file
        positions = source.positions(self.result.positions)
        temporary = file.write_into(files, self.places.out / file.output_name, positions)
        with files.named(temporary):
            stored = file.stored_positions(temporary)
        return {
            name: WrittenPart(file.output_name, stored[vertices], file.precision, list(file.notes))
            for name, vertices in source.members.items()
        }


def _remove_empty(folders: list[Path]) -> None:
    """Remove folders that a failed run made, the innermost first."""
    for folder in folders:
        if not folder.is_dir() or any(folder.iterdir()):
            return
        folder.rmdir()


def _put_report(files: FileSet, path: Path, report: dict[str, Any]) -> None:
    text = json.dumps(report, indent=2, ensure_ascii=False, allow_nan=False)
    temporary = files.temporary_for(path)
    with files.named(temporary):
        temporary.write_text(text + "\n", "utf-8")
