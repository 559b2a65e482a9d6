# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `schema`: print a JSON Schema."""

from __future__ import annotations

import argparse

from ..base.packaged import packaged_text
from ..files.atomic import FileSet

_ROOMS = {
    "certificate": "certifying",
    "doctor": "starting",
    "find": "finding",
    "recipe": "recipe",
    "report": "reporting",
    "study": "study",
}


def execute(wanted: argparse.Namespace, _files: FileSet) -> list[str]:
    """Return the lines of the schema."""
    package = f"sheetmorph.{_ROOMS[wanted.of]}"
    return packaged_text(package, f"{wanted.of}.schema.json").splitlines()
