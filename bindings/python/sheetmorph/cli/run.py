# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `run`: deform the parts of a recipe and write them."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..base.errors import Fault, RecipeError
from ..certifying import NotCertified
from ..files.atomic import FileSet
from ..morph.running import run
from .certify import certified_run, require_criteria
from .output import as_json, json_file, say
from .parsing import STDOUT
from .progress import progress_on
from .summary import ending_of


def execute(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Run the recipe and return the lines to print."""
    require_criteria(wanted)
    with progress_on(sys.stderr, wanted.quiet) as progress:
        report = run(
            wanted.recipe, wanted.output, wanted.pose, report_of(wanted),
            files=files, strict=wanted.strict, pictures=wanted.pictures, step=wanted.step,
            wide=wanted.wide, repair=wanted.repair, progress=progress,
        )  # fmt: skip
    lines = ending_of(report, wanted.output, is_quiet=wanted.quiet)
    try:
        certified = certified_run(wanted) if wanted.certify else []
    except NotCertified:
        seen = f"{wanted.output}: certificate.html shows what fails"
        say(as_json(report) if wanted.json == STDOUT else [*lines, seen])
        raise
    return as_json(report) if wanted.json == STDOUT else [*lines, *certified]


def report_of(wanted: argparse.Namespace) -> Path | str | None:
    """Return the file for the report, that of `--json` or of its older name `--report`."""
    named: str | None = wanted.report
    file = json_file(wanted)
    if named is not None and file is not None:
        what = f"--report names {named} already"
        raise RecipeError([Fault("--json", what, "leave out one of the two files")])
    return named if file is None else file
