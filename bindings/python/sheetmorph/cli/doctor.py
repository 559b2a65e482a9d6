# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `doctor`: what meshes are and what is wrong with them."""

from __future__ import annotations

import argparse

from ..files.atomic import FileSet
from ..starting.doctor import diagnose_files
from .output import as_json


def execute(wanted: argparse.Namespace, _files: FileSet) -> list[str]:
    """Diagnose the files and return the lines to print."""
    found = diagnose_files(wanted.files, wanted.tolerance, wanted.unit)
    return as_json(found)
