# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `run`: deform the parts of a recipe and write them."""

from __future__ import annotations

import argparse
import sys

from ..certifying import NotCertified
from ..files.atomic import FileSet
from ..morph.running import run
from .certify import certified_run, require_criteria
from .output import Outcome, as_json, json_target, say
from .parsing import STDOUT
from .progress import progress_on
from .summary import ending_of


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Run the recipe and return its report."""
    require_criteria(wanted)
    with progress_on(sys.stderr, wanted.quiet) as progress:
        report = run(
            wanted.recipe, wanted.output, wanted.pose, json_target(wanted),
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
    return Outcome([*lines, *certified], report)
