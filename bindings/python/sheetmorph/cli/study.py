# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `study`: compute, certify and tabulate variants of a recipe."""

from __future__ import annotations

import argparse
import sys

from ..base.errors import Fault, RecipeError
from ..files.atomic import FileSet
from ..study.coupling import evaluate_files
from ..study.running import Ways, run_study, study_range
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Run the study and return the lines to print. Raises RecipeError, FileError, KernelError."""
    if wanted.scheduler is not None and wanted.engine != "dask":
        what = "only the engine dask has a scheduler"
        raise RecipeError([Fault("--scheduler", what, "add --engine dask, or leave it out")])
    if wanted.evaluate is not None:
        return evaluate_files(wanted.recipe, *wanted.evaluate, files=files)
    if wanted.output is None:
        raise RecipeError([Fault("-o", "no folder is given", "add -o DIR, for the variants")])
    with progress_on(sys.stderr, wanted.quiet) as progress:
        if wanted.range:
            return study_range(wanted.recipe, wanted.output, progress)
        ways = Ways(wanted.engine, wanted.workers, wanted.scheduler, wanted.runs, progress)
        return run_study(wanted.recipe, wanted.output, ways).sentences
