# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `schema`: print a JSON Schema."""

from __future__ import annotations

import argparse
import json

from ..base.packaged import packaged_text
from ..files.atomic import FileSet
from .output import Outcome

_ROOMS = {
    "certificate": "certifying",
    "doctor": "starting",
    "find": "finding",
    "recipe": "recipe",
    "report": "reporting",
    "study": "study",
}


def execute(wanted: argparse.Namespace, _files: FileSet) -> Outcome:
    """Return the schema."""
    package = f"sheetmorph.{_ROOMS[wanted.of]}"
    text = packaged_text(package, f"{wanted.of}.schema.json")
    return Outcome(text.splitlines(), json.loads(text))
