# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `check`: do what `run` does, and write nothing."""

from __future__ import annotations

import argparse
import sys

from ..files.atomic import FileSet
from ..morph.running import NOT_TRIED, check
from .certify import judged_run, require_criteria
from .output import Outcome, json_target
from .progress import progress_on


def execute(wanted: argparse.Namespace, _files: FileSet) -> Outcome:
    """Check the recipe and return its warnings."""
    require_criteria(wanted)
    judge = (lambda folder: judged_run(wanted, folder)) if wanted.certify else None
    with progress_on(sys.stderr, wanted.quiet) as progress:
        remarks = check(
            wanted.recipe, out_dir=wanted.output, pose=wanted.pose, report=json_target(wanted),
            strict=wanted.strict, pictures=wanted.pictures, step=wanted.step, wide=wanted.wide,
            repair=wanted.repair, judge=judge, progress=progress, force=wanted.force,
        )  # fmt: skip
    untried = [one for one in remarks if one.code == NOT_TRIED]
    warnings = [one for one in remarks if one.code != NOT_TRIED]
    faults = [one.fault.to_json() for one in warnings]
    verdict = "; ".join([f"{wanted.recipe}: valid", *untried])
    lines = [*(f"warning: {text}" for text in warnings), verdict]
    found = {"valid": True, "warnings": warnings, "cautions": faults, "notes": untried}
    return Outcome(lines, found)
