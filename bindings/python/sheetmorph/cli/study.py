# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `study`: compute, certify and tabulate variants of a recipe."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from ..base.errors import Fault, RecipeError
from ..files.atomic import FileSet
from ..study.coupling import evaluate_files
from ..study.ranges import FILE as RANGE
from ..study.running import Ways, run_study, study_range
from ..study.summary import JSON as SUMMARY
from .output import Outcome
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Run the study and return its table. Raises RecipeError, FileError, KernelError."""
    if wanted.scheduler is not None and wanted.engine != "dask":
        what = "only the engine dask has a scheduler"
        raise RecipeError([Fault("--scheduler", what, "add --engine dask, or leave it out")])
    if wanted.evaluate is not None:
        sentences = evaluate_files(wanted.recipe, *wanted.evaluate, files=files)
        return Outcome(sentences, {"messages": sentences})
    if wanted.output is None:
        raise RecipeError([Fault("-o", "no folder is given", "add -o DIR, for the variants")])
    with progress_on(sys.stderr, wanted.quiet) as progress:
        if wanted.range:
            sentences = study_range(wanted.recipe, wanted.output, progress)
            return Outcome(sentences, _written(wanted.output, RANGE))
        ways = Ways(wanted.engine, wanted.workers, wanted.scheduler, wanted.runs, progress)
        sentences = run_study(wanted.recipe, wanted.output, ways).sentences
    is_table = wanted.runs is None and wanted.engine not in ("slurm", "snakemake")
    return Outcome(
        sentences, _written(wanted.output, SUMMARY) if is_table else {"messages": sentences}
    )


def _written(folder: str, name: str) -> Any:
    """Return the content of a file that the study wrote."""
    return json.loads((Path(folder) / name).read_text("utf-8"))
