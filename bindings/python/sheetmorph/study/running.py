# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study from its file to a folder of certified variants and their table."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base.errors import Fault, FileError, RecipeError
from ..base.pages import require_pages
from ..base.progress import Progress
from ..base.words import counted
from ..pictures import missing_tools
from . import ranges
from .engines.dask import dask_driver
from .engines.driving import Hopes
from .engines.processes import processes_driver
from .engines.scripts import Call
from .engines.slurm import ARRAY, END, submit
from .engines.snakemake import FILE as SNAKEFILE
from .engines.snakemake import write_snakefile
from .leases import alone, among_others
from .plan import Plan
from .refusing import Refusals
from .rows import ERROR, FILE, REFUSED, Row
from .storing import Store, write_json
from .summary import CSV, JSON, PAGE, counts_of, write_summary
from .working import Cost, Task, Workshop, adopt, work

ENGINES = ("local", "processes", "dask", "slurm", "snakemake")
COSTS = "costs.json"
# Default number of array jobs in a batch system.
_JOBS = 16


@dataclass(frozen=True)
class Ways:
    """The way a study is computed.

    Parameters
    ----------
    engine : str
        One of ENGINES.
    workers : int
        Number of workers; 0 lets the engine choose.
    scheduler : str, optional
        Address of a Dask scheduler.
    runs : tuple of int, optional
        First and last run; all by default.
    progress : callable, optional
        progress(fraction, task) returns whether to continue.
    """

    engine: str = "local"
    workers: int = 0
    scheduler: str | None = None
    runs: tuple[int, int] | None = None
    progress: Progress | None = None


class StudyRows(list[Row]):
    """The rows of a study in the order of their runs, as in its table.

    Attributes
    ----------
    computed : int
        Number of variants that this call computed; the others were finished before.
    sentences : list of str
        Lines to print, such as how to start the jobs of a cluster.
    """

    def __init__(self, rows: Iterable[Row], sentences: list[str], computed: int = 0):
        super().__init__(rows)
        self.sentences, self.computed = sentences, computed

    def __repr__(self) -> str:
        counts = ", ".join(f"{n} {status}" for status, n in counts_of(self).items() if n)
        return f"<StudyRows: {counts or 'nothing computed'}>"

    def __str__(self) -> str:
        return "\n".join(self.sentences)


def run_study(path: str | Path, out: str | Path, ways: Ways | None = None) -> StudyRows:
    """Compute the variants of a study into a folder.

    Finished variants with unchanged inputs stay.

    Parameters
    ----------
    path : str or path
        The study file.
    out : str or path
        Folder for the variants and their table.
    ways : Ways, optional
        Engine, workers and runs; by default all runs in this process.

    Returns
    -------
    StudyRows
        A row for each finished variant: parameters, measures, status and reason. It is empty if
        the engine only writes or submits jobs.

    Raises
    ------
    RecipeError, FileError, FailedError, OSError
    """
    ways = ways or Ways()
    require_pages()
    plan = Plan(path, ways.progress)
    _require_apart(plan, Path(out))
    store = Store(Path(out))
    store.open(CSV, JSON, PAGE, COSTS, ARRAY, END, SNAKEFILE)
    if ways.runs is not None:
        with among_others(store.out):
            return _Run(plan, store, ways).some(*ways.runs)
    with alone(store.out):
        run = _Run(plan, store, ways)
        store.tidy(run.hashes)
        if ways.engine in ("slurm", "snakemake"):
            call = Call(plan.study.path, store.out, len(plan.samples))
            hand_over = submit if ways.engine == "slurm" else write_snakefile
            return StudyRows([], hand_over(call, ways.workers or _JOBS))
        return run.whole()


def study_range(path: str | Path, out: str | Path, progress: Progress | None = None) -> list[str]:
    """Find and write the admissible ranges of the parameters.

    Parameters
    ----------
    path : str or path
        The study file.
    out : str or path
        Folder for ranges.json.
    progress : callable, optional
        progress(fraction, task) returns whether to continue.

    Returns
    -------
    list of str
        A sentence for each parameter.

    Raises
    ------
    RecipeError, FileError, KernelError, OSError
    """
    plan = Plan(path, progress)
    _require_apart(plan, Path(out))
    found = ranges.possible_ranges(plan, progress)
    store = Store(Path(out))
    store.open(ranges.FILE)
    with alone(store.out):
        store.sweep()
        write_json(store.out, {ranges.FILE: found})
    return [_range_sentence(name, entry) for name, entry in found["parameters"].items()]


def _range_sentence(name: str, entry: dict[str, Any]) -> str:
    text = f"{name}: {entry['low']:.6g} to {entry['high']:.6g}"
    whys = [
        f"{'below' if side == 'low' else 'above'}: {entry[f'{side}_why']}"
        for side in ("low", "high")
        if entry[f"{side}_why"]
    ]
    return "; ".join([text if whys else f"{text}, its full range", *whys])


class _Run:
    """One call for one study; hashes has those of its variants, by run."""

    def __init__(self, plan: Plan, store: Store, ways: Ways):
        self._plan, self._store, self._ways = plan, store, ways
        refusals = Refusals(plan, store.out)
        whys = [plan.refusal(values) or refusals.why(values) for values in plan.samples]
        self._whys = {run: why for run, why in enumerate(whys) if why}
        self.hashes = [plan.hash_of(values, why) for values, why in zip(plan.samples, whys)]
        self._costs: list[Cost] = []
        self._preprocessed = 0
        self._rows: dict[int, Row] = {}
        self._total = 0

    def some(self, first: int, last: int) -> StudyRows:
        """Compute some of the runs without a table, because other processes compute the others."""
        runs = range(first, min(last, len(self.hashes) - 1) + 1)
        self._compute(runs)
        done = f"{len(runs)} run(s) done, pre-processed {self._preprocessed} time(s)"
        return self._table([f"{self._store.out}: {done}"])

    def whole(self) -> StudyRows:
        """Compute the missing runs and write the table."""
        begin = time.perf_counter()
        try:
            self._compute(range(len(self.hashes)))
        except KeyboardInterrupt:
            self._tell()
            done = f"{len(self._rows)} of {self._total} variants are finished"
            raise KeyboardInterrupt(f"{done}. Run the same command to continue.") from None
        self._store.sweep()
        summary = self._tell()
        costs = self._costs_of(time.perf_counter() - begin)
        write_json(self._store.out, {COSTS: costs})
        told = [_sentence(self._store.out, summary, costs)]
        without = [row.no_picture for row in self._rows.values() if row.no_picture]
        if without:
            told.append(f"{len(without)} variant(s) without a picture: {without[0]}")
        if aside := self._store.aside():
            what = counted(aside, "finished variant", "finished variants")
            told.append(f"{what} with other settings stay in it, under hidden names (.*.kept)")
        return self._table(told)

    def _table(self, sentences: list[str]) -> StudyRows:
        rows = (row for _, row in sorted(self._rows.items()))
        return StudyRows(rows, sentences, len(self._costs))

    def _tell(self) -> dict[str, Any]:
        return write_summary(self._plan, self._rows, self._store.out)

    def _compute(self, runs: Sequence[int]) -> None:
        self._total = len(runs)
        missing = [run for run in runs if not self._take(run)]
        for run in filter(self._whys.get, missing):
            self._put(run, REFUSED, self._whys[run])
        computed = [run for run in missing if run not in self._whys]
        study, out = str(self._plan.study.path.resolve()), str(self._store.out.resolve())
        tasks = [Task(study, out, run, self.hashes[run]) for run in computed]
        if tasks:
            self._hand_out(tasks)

    def _hand_out(self, tasks: list[Task]) -> None:
        ways = self._ways
        hopes = Hopes(self._finished, self._lost, lambda task: self._take(task.run))
        workers = ways.workers or os.cpu_count() or 1
        if ways.engine == "dask":
            dask_driver(ways.scheduler, workers, hopes).drive(tasks)
            return
        shop = Workshop(self._plan)
        adopt(shop, tasks[0].study)
        if ways.engine == "processes":
            shop.begin(tasks[0].run)
            self._preprocessed = shop.preprocessed
            processes_driver(workers, hopes).drive(tasks)
        else:
            with closing(shop):
                for task in tasks:
                    self._finished(task, work(task))

    def _take(self, run: int) -> bool:
        """Return whether a variant is finished, and store its row if so."""
        row = self._store.row(run, self.hashes[run])
        if row is None or row.status == ERROR or (row.no_picture and not missing_tools()):
            return False
        self._rows[run] = row
        return True

    def _finished(self, task: Task, cost: Cost) -> None:
        row = self._store.row(task.run, task.key)
        if row is None:
            what = f"the folder of run {task.run} is not where its worker put it"
            raise FileError(self._store.out, what, "workers and this process must share the folder")
        self._rows[task.run] = row
        self._costs.append(cost)
        self._preprocessed += cost.preprocessed
        self._progress()

    def _lost(self, task: Task, why: str) -> None:
        self._put(task.run, ERROR, why)

    def _put(self, run: int, status: str, why: str) -> None:
        row = Row(self.hashes[run], self._plan.samples[run], status, why)
        with self._store.folder(run) as folder:
            write_json(folder, {FILE: row.to_json()})
        self._rows[run] = row
        self._progress()

    def _progress(self) -> None:
        progress = self._ways.progress
        done = len(self._rows)
        if progress is not None and not progress(
            done / max(1, self._total), f"{done} of {self._total} variants"
        ):
            raise KeyboardInterrupt

    def _costs_of(self, seconds: float) -> dict[str, Any]:
        """Return the costs of this call, the only result of a study that varies between calls."""
        spent = sum(cost.seconds for cost in self._costs)
        kernel = sum(cost.kernel for cost in self._costs)
        return {
            "sheetmorph_study_costs": 1,
            "engine": self._ways.engine,
            "workers": self._ways.workers,
            "computed": len(self._costs),
            "preprocessed": self._preprocessed,
            "seconds": seconds,
            "variants_a_second": len(self._costs) / seconds if seconds else 0.0,
            "seconds_of_workers": spent,
            "seconds_of_kernel": kernel,
            "share_not_of_kernel": 1.0 - kernel / spent if spent else 0.0,
            "cpu_seconds_of_workers": sum(cost.cpu for cost in self._costs),
            "cpu_seconds_of_kernel": sum(cost.kernel_cpu for cost in self._costs),
        }


def _sentence(out: Path, summary: dict[str, Any], costs: dict[str, Any]) -> str:
    counts = ", ".join(f"{count} {status}" for status, count in summary["counts"].items())
    return (
        f"{out}: {len(summary['runs'])} variant(s): {counts}; {costs['computed']} computed in "
        f"{costs['seconds']:.3g} s"
    )


def _require_apart(plan: Plan, out: Path) -> None:
    """Check that results are not written beside the inputs. Raises RecipeError."""
    read = [plan.study.path, plan.study.recipe, *(s.file.origin for s in plan.parts.sources)]
    if out.resolve() in [path.parent.resolve() for path in read]:
        what = f"{out} is the folder of the study, its recipe or a part"
        raise RecipeError([Fault("-o", what, "choose a separate folder")])
