# SPDX-License-Identifier: LGPL-2.1-or-later
"""One variant from its values to its folder; every engine calls this module."""

from __future__ import annotations

import shutil
import threading
import time
from collections import OrderedDict
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ..base.errors import (
    Fault,
    FileError,
    KernelError,
    RecipeError,
    SheetMorphError,
    fault_of,
    reason_of,
)
from ..certifying import Certifier, Inputs
from ..checking import prepare
from ..files.deck_file import DeckFile
from ..files.places import Places
from ..joint_files.following import JointSource, joint_sources
from ..morph.running import Writer, told_of_files
from ..morph.session import Result, Session
from ..recipe.parts import Parts, Source
from ..reporting.report import as_written, make_report
from .certifying import certificate, failures_of, judged
from .figures import Figures, live_report
from .measures import Measures, Scene
from .pictures import Thumbnails
from .plan import Plan
from .rows import CERTIFICATE, ERROR, FAILED, FILE, PASSED, PICTURE, REFUSED, Row
from .sampling import Values
from .storing import Store, write_json
from .variants import Variant

# Number of cached sessions; variants that share one often follow each other.
_KEPT = 2
_OWN_PARTS = ("parts", "features", "contacts")


@dataclass(frozen=True)
class Task:
    """A variant to compute: study file, output folder, run, and its hash at the start."""

    study: str
    out: str
    run: int
    key: str


@dataclass(frozen=True)
class Cost:
    """Durations of one variant, s: total and kernel, as wall time and as CPU time.

    preprocessed counts its pre-processing phases.
    """

    seconds: float = 0.0
    kernel: float = 0.0
    cpu: float = 0.0
    kernel_cpu: float = 0.0
    preprocessed: int = 0


class _Watch:
    """A stopwatch for the kernel."""

    def __init__(self) -> None:
        self.kernel = self.cpu = 0.0

    @contextmanager
    def kernel_works(self) -> Iterator[None]:
        begin, cpu = time.perf_counter(), time.process_time()
        yield
        self.kernel += time.perf_counter() - begin
        self.cpu += time.process_time() - cpu


@dataclass(frozen=True, eq=False)
class _Base:
    """A pre-processed recipe, with the rest state for certificates of its variants."""

    session: Session
    parts: Parts
    measures: Measures
    joint_files: list[JointSource]
    plan: Plan

    @cached_property
    def certifier(self) -> Certifier:
        """The certifier, which measures the rest state once."""
        study = self.plan.study
        inputs = Inputs(study.recipe, self.joint_files)
        return Certifier(self.parts, self.session.model, study.certify, inputs)


class Workshop:
    """The computation of variants of one study with a shared pre-processing phase.

    preprocessed counts the pre-processing phases.
    """

    def __init__(self, plan: Plan):
        self.plan = plan
        self.preprocessed = 0
        self._bases: OrderedDict[str, _Base] = OrderedDict()
        self._watch = _Watch()
        self._thumbnails = Thumbnails()

    def close(self) -> None:
        """End the process that draws pictures, if there is one."""
        self._thumbnails.close()

    def begin(self, run: int) -> None:
        """Prepare for all variants: pre-process, write and certify the undeformed parts once.

        Errors are ignored here, because the variants report them.
        """
        with suppress(RecipeError, FileError, RuntimeError), TemporaryDirectory() as folder:
            variant = replace(self.plan.variant(self.plan.samples[run]), pose={})
            base = self._base(variant)
            self._written(base, variant, base.session.deform({}), Path(folder))

    def work(self, run: int, store: Store) -> Cost:
        """Compute a variant into its folder; its row has the errors."""
        begin, cpu = time.perf_counter(), time.process_time()
        self._watch, before = _Watch(), self.preprocessed
        values = self.plan.samples[run]
        row = Row(self.plan.hash_of(values), values, ERROR)
        with store.folder(run) as folder:
            row = self._row(row, folder)
            write_json(folder, {FILE: row.to_json()})
        seconds, used = time.perf_counter() - begin, time.process_time() - cpu
        preprocessed = self.preprocessed - before
        return Cost(seconds, self._watch.kernel, used, self._watch.cpu, preprocessed)

    def result(self, values: Values) -> Result:
        """Return the exact answer for parameter values, without files. Raises RecipeError."""
        variant = self.plan.variant(values)
        return self._base(variant).session.deform(variant.pose)

    def verdict(self, values: Values, exact: bool) -> str:
        """Return why a variant fails, or an empty text; nothing is written.

        exact=False uses a live answer, which measures no contacts.
        """
        why = self.plan.refusal(values)
        if why:
            return why
        try:
            variant = self.plan.variant(values)
            base = self._base(variant)
            result = base.session.deform(variant.pose, exact)
        except (RecipeError, RuntimeError) as error:
            return reason_of(error)
        report = report_of(result, base.parts, base.joint_files) if exact else live_report(result)
        figures = Figures(result, report)
        measures = base.measures.taken(Scene(result.positions, values, figures.figure))
        criteria = judged(self.plan.study.criteria, {**values, **measures}, figures.figure)
        if not exact:
            criteria = [entry for entry in criteria if entry["value"] is not None]
        return "; ".join([*report["certificate"]["failures"], *failures_of(criteria)])

    def session(self, variant: Variant) -> Session:
        """Return the session of a variant. Raises RecipeError."""
        return self._base(variant).session

    def measures(self, values: Values) -> Measures:
        """Return the measures for parameter values. Raises RecipeError."""
        return self._base(self.plan.variant(values)).measures

    def _row(self, row: Row, folder: Path) -> Row:
        why = self.plan.refusal(row.parameters)
        if why:
            return replace(row, status=REFUSED, why=why)
        try:
            return self._computed(row, folder)
        except RecipeError as error:
            return self._without(row, folder, REFUSED, reason_of(error))
        except (OSError, FileError):
            raise  # a full disk or a lost folder concerns the whole study
        except MemoryError:
            return self._without(row, folder, ERROR, "not enough memory")
        except Exception as error:  # whatever it is, the other variants continue
            what = reason_of(error)
            if not isinstance(error, SheetMorphError):
                what = f"a bug of SheetMorph ({type(error).__name__}: {what})"
            return self._without(row, folder, ERROR, what)

    def _without(self, row: Row, folder: Path, status: str, why: str) -> Row:
        _clear(folder)
        return replace(row, status=status, why=why)

    def _computed(self, row: Row, folder: Path) -> Row:
        variant = self.plan.variant(row.parameters)
        base = self._base(variant)
        with self._watch.kernel_works():
            result = base.session.deform(variant.pose)
        report, proof, result = self._written(base, variant, result, folder)
        figures = Figures(result, report)
        scene = Scene(result.positions, row.parameters, figures.figure)
        measures = base.measures.taken(scene)
        known: dict[str, float | None] = {**row.parameters, **measures}
        criteria = judged(self.plan.study.criteria, known, figures.figure)
        proof = certificate(proof, report, criteria, measures)
        failures = proof["failures"]
        if failures:
            _clear(folder)
        wanted, no_picture = self.plan.study.write, ""
        if "certificate" in wanted:
            write_json(folder, {CERTIFICATE: proof})
        if "pictures" in wanted:
            no_picture = self._thumbnails.write(result, folder / PICTURE)
        status, why = FAILED if failures else PASSED, "; ".join(failures)
        return replace(row, status=status, why=why, measures=measures, no_picture=no_picture)

    def _written(
        self, base: _Base, variant: Variant, result: Result, folder: Path
    ) -> tuple[dict[str, Any], dict[str, Any], Result]:
        """Write the parts, read them back, certify them and remove unwanted files.

        Return the report, the certificate, and the answer with the positions in the files.
        """
        sources, wanted = base.parts.sources, self.plan.study.write
        places, joints = Places([], folder, [], None), base.joint_files
        writer = Writer(result, sources, places, {}, [], joint_files=joints)
        report, parts = writer.write_parts()
        written = base.certifier.written({name: part.positions for name, part in parts.items()})
        sizes = {name: move["size"] for name, move in variant.pose.items() if "size" in move}
        proof = base.certifier.certificate(folder, written, sizes)
        for source in sources:
            is_deck = isinstance(source.file, DeckFile)
            if "parts" not in wanted and not ("decks" in wanted and is_deck):
                _remove(source, folder)
        for place in (p for one in joints for p in one.targets(folder)):
            if "parts" not in wanted and "decks" not in wanted:
                place.unlink(missing_ok=True)
        return report, proof, as_written(result, parts)

    def _base(self, variant: Variant) -> _Base:
        if variant.key in self._bases:
            self._bases.move_to_end(variant.key)
            return self._bases[variant.key]
        while len(self._bases) >= _KEPT:
            self._bases.popitem(last=False)
        made = self._bases[variant.key] = self._preprocessed(variant)
        return made

    def _preprocessed(self, variant: Variant) -> _Base:
        plan = self.plan
        touched = {str(entry.steps[0]) for entry in plan.study.parameters if entry.steps}
        shared = not touched.intersection(_OWN_PARTS)
        parts = plan.parts if shared else prepare(variant.recipe, plan.folder)
        self.preprocessed += 1
        with self._watch.kernel_works():
            session = Session(variant.recipe, parts.meshes, found=parts.found)
        measures = Measures(plan.study, session.model, parts.meshes)
        return _Base(session, parts, measures, joint_sources(parts, plan.folder), plan)


def report_of(
    result: Result, parts: Parts, joint_files: Sequence[JointSource] = ()
) -> dict[str, Any]:
    """Return the report of an exact answer that is not written."""
    beside = told_of_files(result, parts.sources, joint_files)
    return make_report(result, beside=beside, is_brief=True)


def _remove(source: Source, folder: Path) -> None:
    """Remove the written files of a source."""
    names = [] if source.writing is None else [source.writing.name_for(source.file)]
    for path in (*source.file.targets(folder), *(folder / name for name in names)):
        path.unlink(missing_ok=True)
        while path.parent != folder and not any(path.parent.iterdir()):
            path = path.parent
            path.rmdir()


def _clear(folder: Path) -> None:
    for path in folder.iterdir():
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink()


def work(task: Task) -> Cost:
    """Compute a variant in this process, for workers of all engines; the study is read once.

    Threads of one process, as in Dask workers, take turns because they share what was read.
    """
    with _turn:
        shop = _workshop(task.study)
        if task.run >= len(shop.plan.samples):
            raise FileError(task.study, "it has changed meanwhile", "start the study again")
        if shop.plan.hash_of(shop.plan.samples[task.run]) != task.key:
            raise FileError(task.study, "it or its recipe has changed meanwhile", "start it again")
        return shop.work(task.run, Store(Path(task.out)))


_turn = threading.Lock()
# The workshop of this process, by file and time of the study; forked processes inherit it.
_shops: dict[tuple[str, int], Workshop] = {}


def adopt(shop: Workshop, study: str) -> None:
    """Let work() use a workshop for the current version of a study file."""
    _shops.clear()
    _shops[_key(study)] = shop


def _workshop(study: str) -> Workshop:
    if _key(study) not in _shops:
        adopt(Workshop(Plan(study)), study)
    return _shops[_key(study)]


def _key(study: str) -> tuple[str, int]:
    return study, Path(study).stat().st_mtime_ns


def attempt(task: Task) -> tuple[Cost, Fault | None]:
    """Call work() for another process; errors that stop the whole study return as a fault."""
    try:
        return work(task), None
    except (RecipeError, FileError, KernelError, OSError) as error:
        return Cost(), fault_of(error, "correct it and start the study again", "study")
