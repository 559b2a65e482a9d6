# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a recipe file to a folder of deformed parts; all checks run before a file appears."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any


from ..base.arrays import Floats
from ..base.errors import Caution, Fault, KernelError, RecipeError, SheetMorphError
from ..base.old_keyword import old_keyword
from ..base.progress import Progress
from ..certifying.repair import criteria_of, repaired
from ..checking import prepare, with_ids
from ..files import FileSet
from ..files.cad_file import CadFile
from ..files.cad_writing import write_shapes
from ..files.places import Places
from ..joint_files.following import JointSource, joint_sources
from ..pictures import Scene, before_and_after, draw
from ..recipe.parts import Source
from ..recipe.reading import given, named_in, read_json
from ..recipe.steps import with_step
from ..reporting.report import NOT_RIGID, FilesTold, WrittenPart, make_report
from ..reporting.shapes import WrittenShapes
from .session import Result, Session


# Code of a warning that check() could not deform the parts.
NOT_TRIED = "not tried out"


class CertificateError(SheetMorphError, RuntimeError):
    """The result of a run fails its certificate; ``report`` has the details.

    A form feature lost its shape, a solve did not converge, a CAD shape cannot follow its mesh, or
    a strict run has warnings.

    Parameters
    ----------
    report : dict
        The report of the run.
    """

    def __init__(self, report: dict[str, Any]):
        failures = report["certificate"]["failures"]
        failed = [one for one in failures if one.code != NOT_RIGID]
        if rigid := [one for one in failures if one.code == NOT_RIGID]:
            what = f"form features are not rigid to {report['tolerance']:.3g} mm"
            subjects = (subject for one in rigid for subject in one.objects)
            failed.append(Caution(what, *subjects, code=NOT_RIGID, todo="; ".join(rigid)))
        told = failed or report["warnings"]
        super().__init__([one.fault for one in told], "; ".join(told))
        self.report = report


@old_keyword("recipe_path", "recipe")
def check(
    recipe: str | Path | dict[str, Any],
    *,
    out_dir: str | Path | None = None,
    pose: str | Path | dict[str, Any] | None = None,
    report: str | Path | None = None,
    strict: bool = False,
    pictures: bool = False,
    step: bool = False,
    wide: bool = False,
    repair: str | None = None,
    judge: Callable[[Path], object] | None = None,
    progress: Progress | None = None,
    force: bool = False,
) -> list[Caution]:
    """Run a recipe with each of its poses into a temporary folder, to check it.

    Parameters
    ----------
    recipe : str, path or dict
        The recipe file, or a recipe with paths relative to the working folder.
    out_dir, report : str or path, optional
        Intended outputs of a run; their paths are checked, nothing is written there.
    pose : dict, str or path, optional
        Check only this pose.
    strict, pictures, step, wide, repair, progress, force
        Options of run().
    judge : callable, optional
        judge(folder) is called for each folder with written parts.

    Returns
    -------
    list of Caution
        Warnings of the run, and a sentence for everything that could not be checked.

    Raises
    ------
    RecipeError, FileError, CertificateError, PictureError, OSError
        As run() raises them.
    """
    found: list[Caution] = []
    ways = Ways(strict, progress or _keep_going, pictures, step, repair)
    try:
        with tempfile.TemporaryDirectory(prefix="sheetmorph-check-") as scratch:
            folder, morph = Path(scratch) / "parts", _Morph(recipe, ways)
            morph.widen(wide)
            read, wanted = morph.pose(pose)
            place = Path(report) if report else None
            morph.places(read, Path(out_dir or folder), place).require_ours(FileSet(force=force))
            morph.factorise()
            named = {"": wanted, **({} if pose is not None else morph.recipe.get("poses", {}))}
            for name, one in named.items():
                with named_in(read[0] if read else morph.path):
                    found += _tried(morph, one, folder, f'pose "{name}"' if name else "")
                if judge is not None:
                    judge(folder)
    except KernelError as error:
        found.append(Caution(error.what, code=NOT_TRIED, todo=error.todo, where="not tried out"))
    return found


def _tried(morph: _Morph, pose: dict[str, Any] | None, folder: Path, place: str) -> list[Caution]:
    """Write a pose to a temporary folder and return its warnings, each with a place in front."""
    report = morph.write(pose, morph.places([], folder, None), FileSet())
    return [warning.within(place) for warning in report["warnings"]]


@old_keyword("recipe_path", "recipe")
def resolve(
    recipe: str | Path | dict[str, Any],
    progress: Progress | None = None,
    remarks: list[str] | None = None,
) -> dict[str, Any]:
    """Return a recipe with vertex ids in place of its selectors and "auto" entries.

    Parameters
    ----------
    recipe : str, path or dict
        The recipe file, or a recipe with paths relative to the working folder.
    progress : callable, optional
        progress(fraction, task) returns whether to continue.
    remarks : list of str, optional
        Receives a sentence for each selector that selected a whole part or something far away.

    Returns
    -------
    dict
        The recipe; the paths of its parts are unchanged.

    Raises
    ------
    RecipeError
        If the recipe has faults.
    KernelError
        If the compiled kernel cannot be loaded.
    """
    data, path = given(recipe)
    with named_in(path):
        parts = prepare(data, path.parent, progress)
    if remarks is not None:
        for place, told in parts.resolved.told.items():
            remarks += [f"{place}: {remark}" for remark in told["remarks"]]
    return with_ids(parts)


@old_keyword("recipe_path", "recipe")
def run(
    recipe: str | Path | dict[str, Any],
    out_dir: str | Path,
    pose: str | Path | dict[str, Any] | None = None,
    report: str | Path | None = None,
    *,
    files: FileSet | None = None,
    strict: bool = False,
    pictures: bool = False,
    step: bool = False,
    wide: bool = False,
    repair: str | None = None,
    progress: Progress | None = None,
    force: bool = False,
) -> dict[str, Any]:
    """Deform the parts of a recipe and write them to a folder.

    Parameters
    ----------
    recipe : str, path or dict
        The recipe file, or a recipe with paths relative to the working folder.
    out_dir : str or path
        Folder for the parts.
    pose : dict, str or path, optional
        A pose, the name of one of the recipe's `poses`, or a JSON file with a pose; by default the
        recipe's own pose.
    report : str or path, optional
        File for the report.
    files : FileSet, optional
        A new file set for the parts; its ``committed`` is true once they are written, also after an
        interrupt.
    strict : bool
        Treat warnings as failures of the certificate.
    pictures : bool
        Write before.png and after.png beside the parts.
    step : bool
        Write the parts of CAD files also as STEP.
    wide : bool
        Write moved nodes of decks in long fields.
    repair : str, optional
        Element criteria; nodes of decks slide in the sheet until the elements meet them.
    progress : callable, optional
        progress(fraction, task) returns whether to continue.
    force : bool
        Overwrite files that SheetMorph did not write.

    Returns
    -------
    dict
        The report; see ``report.schema.json``.

    Raises
    ------
    RecipeError, FileError, KernelError, CertificateError, PictureError, OSError
        No part is written then.
    """
    out = Path(out_dir)
    morph = _Morph(recipe, Ways(strict, progress or _keep_going, pictures, step, repair))
    morph.widen(wide)
    read, wanted = morph.pose(pose)
    places = morph.places(read, out, None if report is None else Path(report))
    files = files or FileSet(force=force)
    places.require_ours(files)
    morph.factorise()
    with named_in(read[0] if read else morph.path):
        return morph.write(wanted, places, files)


@dataclass(frozen=True)
class Ways:
    """Options of a run, as for run(); repair overrides the criteria of the recipe."""

    strict: bool
    progress: Progress
    pictures: bool = False
    step: bool = False
    repair: str | None = None


class _Morph:
    """A recipe on its way to written parts; the common work of run() and check()."""

    def __init__(self, recipe: str | Path | dict[str, Any], ways: Ways):
        self.recipe, self.path = given(recipe)
        self._ways = ways
        begin = time.perf_counter()
        with named_in(self.path):
            self.recipe = with_step(self.recipe) if ways.step else self.recipe
            self._parts = prepare(self.recipe, self.path.parent, ways.progress)
            self._joints = joint_sources(self._parts, self.path.parent)
        self._timings = {"read": time.perf_counter() - begin}

    def widen(self, is_wide: bool) -> None:
        """Set whether decks get the widest possible number fields."""
        for source in self._parts.sources:
            source.file.is_wide = is_wide

    def pose(self, pose: Any) -> tuple[list[Path], dict[str, Any] | None]:
        """Return the files read for a pose, and the pose. Raises RecipeError.

        A pose is given as a dict, by its name in the recipe, or by its file; None stands for the
        recipe's own.
        """
        found = _named_pose(self.recipe, pose)
        if found is None or isinstance(found, dict):
            return [], found
        with named_in(self.path):
            _require_pose(self.recipe, found)
            return [Path(found)], read_json(found)

    def places(self, read: list[Path], out: Path, report: Path | None) -> Places:
        """Return the checked output paths. Raises RecipeError."""
        sources = self._parts.sources
        targets = [place for source in sources for place in source.file.targets(out)]
        targets += [out / s.writing.name_for(s.file) for s in sources if s.writing is not None]
        targets += [place for joints in self._joints for place in joints.targets(out)]
        read = [*read, *(joints.file.path for joints in self._joints)]
        sourced = [path for source in sources for path in source.file.files_read]
        places = Places([self.path, *read, *sourced], out, targets, report)
        with named_in(self.path):
            places.check()
        return places

    def factorise(self) -> None:
        """Run the pre-processing phase."""
        with named_in(self.path):
            ids = self._parts.resolved
            self._session = Session(
                ids.recipe, self._parts.meshes, self._ways.progress, found=self._parts.found,
                told=ids.told,
            )  # fmt: skip

    def write(self, pose: dict[str, Any] | None, places: Places, files: FileSet) -> dict[str, Any]:
        """Deform, certify and write the parts; return the report."""
        begin = time.perf_counter()
        self._ways.progress(0.95, "deforming")
        result = self._session.deform(pose, progress=self._deforming)
        result = self._repaired(result)
        timings = {**self._timings, "deform": time.perf_counter() - begin}
        told = told_of_files(result, self._parts.sources, self._joints)
        _certify(result, told, (timings, places.report, self._ways.strict), files)
        self._ways.progress(0.97, "writing")
        scenes = before_and_after(result) if self._ways.pictures else ()
        pictures = [
            (scene, places.out / name) for scene, name in zip(scenes, ("before.png", "after.png"))
        ]
        writer = Writer(
            result,
            self._parts.sources,
            places,
            timings,
            pictures,
            self._ways.progress,
            self._joints,
        )
        return writer.write(files)

    def _repaired(self, result: Result) -> Result:
        """Return the result with repaired deck elements, if options or recipe request it."""
        asked = self._ways.repair or self.recipe.get("repair")
        criteria = criteria_of(asked, self.path.parent)
        if criteria is None:
            return result
        self._ways.progress(0.96, "repairing elements")
        return repaired(result, self._parts.sources, criteria)

    def _deforming(self, fraction: float, task: str) -> bool:
        return self._ways.progress(0.95 + 0.04 * fraction, task)


def _named_pose(recipe: Any, pose: Any) -> Any:
    """Return the pose with this name in the recipe; return other values unchanged."""
    named = recipe.get("poses") if isinstance(recipe, dict) else None
    if isinstance(pose, str) and isinstance(named, dict) and pose in named:
        return named[pose]
    return pose


def _require_pose(recipe: Any, pose: Any) -> None:
    """Raise RecipeError unless a pose that the recipe does not have is a file."""
    if Path(pose).suffix or Path(pose).exists():
        return
    names = ", ".join(f'"{name}"' for name in recipe.get("poses") or {})
    todo = f"it has {names}" if names else "it has no poses; give a file with a pose"
    raise RecipeError([Fault("poses", f'the recipe has no pose "{pose}"', todo)])


def _keep_going(_fraction: float, _task: str) -> bool:
    """Return True: during a call Python handles Ctrl-C."""
    return True


def _certify(
    result: Result,
    beside: FilesTold,
    ways: tuple[dict[str, float], Path | None, bool],
    files: FileSet,
) -> None:
    timings, report, strict = ways
    found = make_report(result, None, timings, beside=beside)
    if found["certificate"]["passed"] and not (strict and found["warnings"]):
        return
    _fail(found, report, files)


def _fail(found: dict[str, Any], report: Path | None, files: FileSet) -> None:
    """Write only the report, by the rules of `files`. Raises CertificateError."""
    if report is not None:
        with FileSet(force=files.force) as out:
            out.reads = files.reads
            _put_report(out, report, found)
            out.commit()
    raise CertificateError(found)


@dataclass(frozen=True)
class Writer:
    """The output of a certified result: its parts and the report, all files or none."""

    result: Result
    sources: list[Source]
    places: Places
    timings: dict[str, float]
    pictures: list[tuple[Scene, Path]]
    progress: Progress = _keep_going
    joint_files: Sequence[JointSource] = ()

    def write(self, files: FileSet) -> dict[str, Any]:
        """Write all files and return the report."""
        out = self.places.out
        new_folders = [folder for folder in (out, *out.parents) if not folder.exists()]
        try:
            with files:
                out.mkdir(parents=True, exist_ok=True)
                report, _ = self._fill(files)
                if report["certificate"]["passed"]:
                    files.commit()
        finally:
            if not files.committed:
                _remove_empty(new_folders)
        if not files.committed:
            _fail(report, self.places.report, files)
        return report

    def write_parts(self) -> tuple[dict[str, Any], dict[str, WrittenPart]]:
        """Write into a new folder; return a brief report and the parts as read back, by name.

        The caller flushes the folder or removes it.
        """
        with FileSet(flushed=False) as files:
            report, parts = self._fill(files, True)
            files.commit()
        return report, parts

    def _fill(
        self, files: FileSet, is_brief: bool = False
    ) -> tuple[dict[str, Any], dict[str, WrittenPart]]:
        begin = time.perf_counter()
        parts: dict[str, WrittenPart] = {}
        for source in self.sources:
            parts |= self._written_parts(files, source)
        for joints in self.joint_files:
            joints.write_into(files, joints.targets(self.places.out)[0], self.result.positions)
        if self.pictures:
            draw(self.pictures, files)
        taken = {**self.timings, "write": time.perf_counter() - begin}
        beside = told_of_files(self.result, self.sources, self.joint_files)
        report = make_report(self.result, parts, taken, beside=beside, is_brief=is_brief)
        if self.places.report is not None:
            _put_report(files, self.places.report, report)
        return report, parts

    def _written_parts(self, files: FileSet, source: Source) -> dict[str, WrittenPart]:
        """Write the file of some parts, and return its content by part name."""
        file = source.file
        positions = source.positions(self.result.positions)
        temporary = file.write_into(files, self.places.out / file.output_name, positions)
        with files.named(temporary):
            stored = source.placement.placed(file.stored_positions(temporary))
        shapes = self._written_shapes(files, source, positions)
        return {
            name: WrittenPart(
                file.output_name,
                stored[vertices],
                file.precision,
                file.notes,
                None if shapes is None else shapes.of_part(name),
            )  # fmt: skip
            for name, vertices in source.members.items()
        }

    def _written_shapes(
        self, files: FileSet, source: Source, positions: Floats
    ) -> WrittenShapes | None:
        """Write the CAD shapes of a file beside its mesh, or return None if not wanted."""
        file, writing = source.file, source.writing
        if writing is None or not isinstance(file, CadFile):
            return None
        name = writing.name_for(file)
        temporary = files.temporary_for(self.places.out / name)

        def progress(fraction: float, task: str) -> bool:
            return self.progress(0.97 + 0.03 * fraction, task)

        with files.named(temporary):
            bodies = write_shapes(file, temporary, positions, writing, progress=progress)
        sizes = file.path.stat().st_size, temporary.stat().st_size
        return WrittenShapes(name, bodies, *sizes)


def told_of_files(
    result: Result, sources: Sequence[Source], joint_files: Sequence[JointSource]
) -> FilesTold:
    """Return the report entries of all decks and joint files."""
    told = (source.file.told(source.positions(result.positions)) for source in sources)
    joints = [one.told(result.positions) for one in joint_files]
    missing = [
        f"{source.file.origin}: {text}" for source in sources for text in source.file.missing
    ]
    return FilesTold([one for one in told if one is not None], joints, missing)


def _remove_empty(folders: list[Path]) -> None:
    """Remove the empty folders of a failed run, the innermost first."""
    for folder in folders:
        if not folder.is_dir() or any(folder.iterdir()):
            return
        folder.rmdir()


def _put_report(files: FileSet, path: Path, report: dict[str, Any]) -> None:
    text = json.dumps(report, indent=2, ensure_ascii=False, allow_nan=False)
    temporary = files.temporary_for(path, "report")
    with files.named(temporary):
        temporary.write_text(text + "\n", "utf-8")
