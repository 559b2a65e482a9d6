# SPDX-License-Identifier: LGPL-2.1-or-later
"""One variant as a row of the table, stored in its folder as `parameters.json`."""

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
    """A row of the table: one variant.

    Attributes
    ----------
    hash : str
        Identifies its inputs.
    parameters : dict
        Parameter name to value, in the unit of the parameter.
    status : str
        "passed", "failed", "refused" or "error".
    why : str
        Reason; empty if it passed.
    measures : dict
        Measure name to value, or None if it could not be measured.
    files : dict
        The other files of its folder to their sizes; empty in folders of older versions.
    no_picture : str
        Why a picture is missing; empty if it is there or not wanted.
    """

    hash: str
    parameters: dict[str, float]
    status: str
    why: str = ""
    measures: dict[str, float | None] = field(default_factory=dict)
    files: dict[str, int] = field(default_factory=dict, compare=False)
    no_picture: str = ""

    @property
    def is_final(self) -> bool:
        """Whether it needs no second try, as after an error or without its picture."""
        return self.status != ERROR and not self.no_picture

    def __str__(self) -> str:
        named = ", ".join(f"{name} = {value:.6g}" for name, value in self.parameters.items())
        return f"{named}: {self.status}{f', {self.why}' if self.why else ''}"

    def to_json(self) -> dict[str, Any]:
        """Return the content of parameters.json."""
        return {
            "sheetmorph_variant": 1,
            "hash": self.hash,
            "parameters": self.parameters,
            "measures": self.measures,
            "status": self.status,
            "why": self.why,
            **({"no_picture": self.no_picture} if self.no_picture else {}),
        }


def folder_name(run: int) -> str:
    """Return the folder name of a run, such as `000123`."""
    return f"{run:06d}"


def read_row(folder: Path) -> Row | None:
    """Return the row in the folder of a variant, or None."""
    try:
        found = json.loads(read_text(folder / FILE))
        return Row(
            hash=found["hash"],
            parameters=dict(found["parameters"]),
            status=found["status"],
            why=found["why"],
            measures=dict(found["measures"]),
            files=dict(found.get("files", {})),
            no_picture=found.get("no_picture", ""),
        )
    except (OSError, ValueError, KeyError, TypeError):
        return None
