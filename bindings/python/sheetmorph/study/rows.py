# SPDX-License-Identifier: LGPL-2.1-or-later
"""One variant as a row of the table, kept in its folder as `parameters.json`."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..files.reading import read_text

PASSED, FAILED, REFUSED, ERROR = STATUSES = ("passed", "failed", "refused", "error")
FILE = "parameters.json"
CERTIFICATE = "certificate.json"
PICTURE = "picture.png"


@dataclass(frozen=True)
class Row:
    """hash: of what it depends on; status: one of STATUSES; why: empty if it passed; files: the
    other files of its folder and their sizes, none of folders that older versions wrote."""

    hash: str
    parameters: dict[str, float]
    status: str
    why: str = ""
    measures: dict[str, float | None] = field(default_factory=dict)
    files: dict[str, int] = field(default_factory=dict, compare=False)

    def to_json(self) -> dict[str, Any]:
        """What parameters.json holds."""
        return {
            "sheetmorph_variant": 1,
            "hash": self.hash,
            "parameters": self.parameters,
            "measures": self.measures,
            "status": self.status,
            "why": self.why,
        }


def folder_name(run: int) -> str:
    """`000123`"""
    return f"{run:06d}"


def read_row(folder: Path) -> Row | None:
    """The row that a folder of a variant holds; None if it holds none."""
    try:
        found = json.loads(read_text(folder / FILE))
        return Row(
            hash=found["hash"],
            parameters=dict(found["parameters"]),
            status=found["status"],
            why=found["why"],
            measures=dict(found["measures"]),
            files=dict(found.get("files", {})),
        )
    except (OSError, ValueError, KeyError, TypeError):
        return None
