# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `doctor`: what is wrong with meshes, or with the installation."""

from __future__ import annotations

import argparse

from ..files.atomic import FileSet
from ..starting.doctor import diagnose_files
from ..starting.installation import checks
from .output import BAD_INPUT, DONE, Outcome, as_json


def execute(wanted: argparse.Namespace, _files: FileSet) -> Outcome:
    """Diagnose the files, or check the installation if there is none."""
    if wanted.files:
        found = diagnose_files(wanted.files, wanted.tolerance, wanted.unit)
        return Outcome(as_json(found), found)
    made = list(checks())
    is_broken = any(check.is_error for check in made)
    data = {"installation": [vars(check) for check in made]}
    return Outcome([str(check) for check in made], data, BAD_INPUT if is_broken else DONE)
