# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a recipe file to a folder of deformed parts: everything is checked before a file appears."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any


from .arrays import Floats
from .cautions import unsettled
from .certifying.repair import criteria_of, repaired
from .errors import Caution, KernelError
from .files import FileSet
from .files.cad_file import CadFile
from .files.cad_writing import write_shapes
from .joint_files.following import JointSource, joint_sources
from .pictures import Scene, before_and_after, draw
from .places import Places
from .progress import Progress
from .recipe import named_in, prepare, read_json, with_ids
from .recipe.parts import Source
from .recipe.steps import with_step
from .report import FilesTold, WrittenPart, make_report, shape_faults
from .session import Result, Session
from .shape_report import WrittenShapes


# Before why a check could not deform anything.
NOT_TRIED = "not tried out"


class CertificateError(RuntimeError):
    """A form feature lost its form, a part is not solved to its end, a shape cannot follow its
    mesh, or the warnings of a strict run; ``report`` tells more."""

    def __init__(self, report: dict[str, Any]):
        failed = [*unsettled(report["parts"]), *shape_faults(report["parts"])]
        beside = [*report["decks"], *report["joint_files"]]
        failed += [text for file in beside for text in file["failures"]]
        rigid = [text for text in report["certificate"]["failures"] if text not in failed]
        if rigid:
            tol = report["tolerance"]
            failed.append(f"form features are not rigid to {tol:.3g} mm: {'; '.join(rigid)}")
        warned = [] if failed else report["warnings"]
        super().__init__("; ".join([*failed, *warned]))
        self.report = report


def check(
    recipe_path: str | Path,
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
) -> list[str]:
    """Do what run() does with a recipe, and with each of its poses, into a folder thrown away.

    Its options are those of run(); out_dir, report: nothing is written there; pose: this one alone;
    judge(folder): called for each folder that was written. Returns the warnings of run(), and what
    could not be checked, one sentence each. Raises what run() raises.
    """
    path, found = Path(recipe_path), list[str]()
    ways = Ways(strict, progress or _keep_going, pictures, step, repair)
    try:
        with tempfile.TemporaryDirectory(prefix="sheetmorph-check-") as scratch:
            folder, morph = Path(scratch) / "parts", _Morph(path, ways)
            morph.widen(wide)
            read, wanted = morph.pose(pose)
            place = Path(report) if report else None
            morph.places(read, Path(out_dir or folder), place).require_ours(FileSet(force=force))
            morph.factorise()
            named = {"": wanted, **({} if pose is not None else morph.recipe.get("poses", {}))}
            for name, one in named.items():
                with named_in(read[0] if read else path):
                    found += _tried(morph, one, folder, f'pose "{name}": ' if name else "")
                if judge is not None:
                    judge(folder)
    except KernelError as error:
        found.append(Caution(f"not tried out: {error}", code=NOT_TRIED))
    return found


def _tried(morph: _Morph, pose: dict[str, Any] | None, folder: Path, lead: str) -> list[str]:
    """Write a pose into a folder thrown away; returns its warnings, each after a lead."""
    report = morph.write(pose, morph.places([], folder, None), FileSet())
    return [warning.after(lead) for warning in report["warnings"]]


def resolve(
    recipe_path: str | Path, progress: Progress | None = None, remarks: list[str] | None = None
) -> dict[str, Any]:
    """A recipe file with vertex ids in place of its selectors, and what was found for "auto".

    The paths of the parts stay as the file has them. remarks: gets a sentence for each selector
    that took all of a part, or something far away. Raises RecipeError, KernelError.
    """
    path = Path(recipe_path)
    recipe = read_json(path)
    with named_in(path):
        parts = prepare(recipe, path.parent, progress)
    if remarks is not None:
        for place, told in parts.resolved.told.items():
            remarks += [f"{place}: {remark}" for remark in told["remarks"]]
    return with_ids(parts)


def run(
    recipe_path: str | Path,
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
    """Deform the parts of a recipe file and write them under out_dir; returns the report.

    pose: instead of the recipe's a pose, the name of one of its `poses`, or the path of a JSON file
    with one; report: path to write
    the report to; files: a new FileSet for the parts, whose ``committed`` tells, also after an
    interrupt, whether they were written; strict: the report's warnings are failures of the
    certificate; pictures: before.png and after.png beside the parts; step: parts of CAD files are
    written as STEP, too; wide: moved nodes of decks get long fields; repair: criteria until which
    nodes of decks slide in their sheet; progress(fraction, task)
    returns whether to go on; force: files that SheetMorph did not write are written over. Raises
    RecipeError, FileError, KernelError, CertificateError, PictureError, OSError; then no part is
    written.
    """
    path, out = Path(recipe_path), Path(out_dir)
    morph = _Morph(path, Ways(strict, progress or _keep_going, pictures, step, repair))
    morph.widen(wide)
    read, wanted = morph.pose(pose)
    places = morph.places(read, out, None if report is None else Path(report))
    files = files or FileSet(force=force)
    places.require_ours(files)
    morph.factorise()
    with named_in(read[0] if read else path):
        return morph.write(wanted, places, files)


@dataclass(frozen=True)
class Ways:
    """strict: warnings are failures of the certificate; progress: of the long steps; pictures: are
    drawn beside the parts; step: parts of CAD files are written as STEP, too; repair: criteria,
    instead of the recipe's."""

    strict: bool
    progress: Progress
    pictures: bool = False
    step: bool = False
    repair: str | None = None


class _Morph:
    """A recipe file on its way to files; all that run() and check() have in common."""

    def __init__(self, path: Path, ways: Ways):
        self.recipe = read_json(path)
        self._path, self._ways = path, ways
        begin = time.perf_counter()
        with named_in(path):
            self.recipe = with_step(self.recipe) if ways.step else self.recipe
            self._parts = prepare(self.recipe, path.parent, ways.progress)
            self._joints = joint_sources(self._parts, path.parent)
        self._timings = {"read": time.perf_counter() - begin}

    def widen(self, is_wide: bool) -> None:
        """Whether numbers in decks get the longest fields there are."""
        for source in self._parts.sources:
            source.file.is_wide = is_wide

    def pose(self, pose: Any) -> tuple[list[Path], dict[str, Any] | None]:
        """The file of a pose if it has one, and the pose: given as such, by its name in the recipe
        or by its file; None is the recipe's own. Raises RecipeError."""
        found = _named_pose(self.recipe, pose)
        if found is None or isinstance(found, dict):
            return [], found
        with named_in(self._path):
            return [Path(found)], read_json(found)

    def places(self, read: list[Path], out: Path, report: Path | None) -> Places:
        """Where its files go. Raises RecipeError."""
        sources = self._parts.sources
        targets = [place for source in sources for place in source.file.targets(out)]
        targets += [out / s.writing.name_for(s.file) for s in sources if s.writing is not None]
        targets += [place for joints in self._joints for place in joints.targets(out)]
        read = [*read, *(joints.file.path for joints in self._joints)]
        sourced = [path for source in sources for path in source.file.files_read]
        places = Places([self._path, *read, *sourced], out, targets, report)
        with named_in(self._path):
            places.check()
        return places

    def factorise(self) -> None:
        """The pre-processing phase."""
        with named_in(self._path):
            ids = self._parts.resolved
            self._session = Session(
                ids.recipe, self._parts.meshes, self._ways.progress, found=self._parts.found,
                told=ids.told,
            )  # fmt: skip

    def write(self, pose: dict[str, Any] | None, places: Places, files: FileSet) -> dict[str, Any]:
        """Deform, certify and write; returns the report."""
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
        """The same with elements of decks repaired, if that is wanted."""
        asked = self._ways.repair or self.recipe.get("repair")
        criteria = criteria_of(asked, self._path.parent)
        if criteria is None:
            return result
        self._ways.progress(0.96, "repairing elements")
        return repaired(result, self._parts.sources, criteria)

    def _deforming(self, fraction: float, task: str) -> bool:
        return self._ways.progress(0.95 + 0.04 * fraction, task)


def _named_pose(recipe: Any, pose: Any) -> Any:
    """The pose of the recipe that a name stands for; anything else as it is."""
    named = recipe.get("poses") if isinstance(recipe, dict) else None
    if isinstance(pose, str) and isinstance(named, dict) and pose in named:
        return named[pose]
    return pose


def _keep_going(_fraction: float, _task: str) -> bool:
    """Being called is enough: Python handles Ctrl-C here."""
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
    """Write the report alone, by the rules of `files`. Raises CertificateError."""
    if report is not None:
        with FileSet(force=files.force) as out:
            out.reads = files.reads
            _put_report(out, report, found)
            out.commit()
    raise CertificateError(found)


@dataclass(frozen=True)
class Writer:
    """Writes the parts of a certified result and the report, all or none."""

    result: Result
    sources: list[Source]
    places: Places
    timings: dict[str, float]
    pictures: list[tuple[Scene, Path]]
    progress: Progress = _keep_going
    joint_files: Sequence[JointSource] = ()

    def write(self, files: FileSet) -> dict[str, Any]:
        """Returns the report."""
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
        """The same into a folder that is new; its owner flushes it, or removes it. Returns a brief
        report, and the parts as their files hold them, by name."""
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
        """Write the file of some parts; what it holds of each, by part name."""
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
        """Write the shapes of a file besides its mesh; None if that is not wanted."""
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
    """What the report tells of every deck, and of every file of welds and bolts."""
    told = (source.file.told(source.positions(result.positions)) for source in sources)
    joints = [one.told(result.positions) for one in joint_files]
    missing = [
        f"{source.file.origin}: {text}" for source in sources for text in source.file.missing
    ]
    return FilesTold([one for one in told if one is not None], joints, missing)


def _remove_empty(folders: list[Path]) -> None:
    """Remove folders that a failed run made, the innermost first."""
    for folder in folders:
        if not folder.is_dir() or any(folder.iterdir()):
            return
        folder.rmdir()


def _put_report(files: FileSet, path: Path, report: dict[str, Any]) -> None:
    text = json.dumps(report, indent=2, ensure_ascii=False, allow_nan=False)
    temporary = files.temporary_for(path, "report")
    with files.named(temporary):
        temporary.write_text(text + "\n", "utf-8")
