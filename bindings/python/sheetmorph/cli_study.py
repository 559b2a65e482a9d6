# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `study`: its arguments and its output."""

from __future__ import annotations

import argparse
import re
import sys
from typing import Any

from .cli_progress import progress_on
from .errors import Fault, RecipeError
from .files.atomic import FileSet

_ENGINES = ("local", "processes", "dask", "slurm", "snakemake")


def add_study_arguments(commands: Any) -> None:
    """Add `study` to the commands of a parser."""
    study = commands.add_parser("study", help="compute, certify and tabulate variants of a recipe")
    study.add_argument("recipe", metavar="STUDY", help="JSON file; its recipe is relative to it")
    study.add_argument("-o", "--output", metavar="DIR", help="folder for the variants")
    text = "where to compute the variants (default: local, in this process)"
    study.add_argument("--engine", choices=_ENGINES, default="local", help=text)
    text = "number of processes, Dask workers or array jobs (default: number of cores; 16 jobs)"
    study.add_argument("--workers", type=_count, default=0, metavar="N", help=text)
    text = (
        "address of a Dask scheduler, such as tcp://host:8786 (default: a "
        "local cluster for this study)"
    )
    study.add_argument("--scheduler", metavar="ADDRESS", help=text)
    text = "compute only these runs and no table, for jobs of a batch system"
    study.add_argument("--runs", type=_runs, metavar="FIRST-LAST", help=text)
    text = "find the admissible range of every parameter instead of computing variants"
    study.add_argument("--range", action="store_true", help=text)
    text = (
        "compute one evaluation instead of variants; parameters and results "
        "are Dakota files or JSON"
    )
    study.add_argument("--evaluate", nargs=2, metavar=("IN", "OUT"), help=text)
    study.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 10_000:
        raise argparse.ArgumentTypeError(f"{text} is not a number of workers; give 1 to 10000")
    return int(text)


def _runs(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,7})-(\d{1,7})", text)
    if found is None or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text} is not a range of runs; give one such as 0-99")
    return int(found[1]), int(found[2])


def run_study_command(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Run the study and return the lines to print. Raises RecipeError, FileError, KernelError."""
    # Imported here, so that --help answers at once.
    from .study.running import Ways, run_study, study_range

    if wanted.scheduler is not None and wanted.engine != "dask":
        what = "only the engine dask has a scheduler"
        raise RecipeError([Fault("--scheduler", what, "add --engine dask, or leave it out")])
    if wanted.evaluate is not None:
        from .study.coupling import evaluate_files

        return evaluate_files(wanted.recipe, *wanted.evaluate, files=files)
    if wanted.output is None:
        raise RecipeError([Fault("-o", "no folder is given", "add -o DIR, for the variants")])
    with progress_on(sys.stderr, wanted.quiet) as progress:
        if wanted.range:
            return study_range(wanted.recipe, wanted.output, progress)
        ways = Ways(wanted.engine, wanted.workers, wanted.scheduler, wanted.runs, progress)
        return run_study(wanted.recipe, wanted.output, ways)
