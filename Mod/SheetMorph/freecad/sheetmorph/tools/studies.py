# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters and criteria of a study as text."""

from __future__ import annotations

import json
import re
from dataclasses import asdict, dataclass, replace

LENGTH, ANGLE, NUMBER = "mm", "deg", ""
METHODS = ["latin hypercube", "sobol", "halton", "full grid"]
"""The sampling methods, as named in a study file."""
MEASURED = ("stretch", "angle")
"""The results that every study measures."""
_LIMIT = re.compile(r"\s*([\w .]*?\w)\s*(<=|>=)\s*([-+.\deE]+)\s*")


@dataclass(frozen=True)
class Parameter:
    """A number of a document that a study varies between two others.

    `owner` is the name of the document object. `number` is its property, or the cell of a
    spreadsheet.
    """

    name: str
    owner: str
    number: str
    low: float
    high: float


def to_text(parameters: list[Parameter]) -> str:
    """Return the parameters as JSON, from which every number is read back exactly."""
    return json.dumps([asdict(parameter) for parameter in parameters])


def from_text(text: str) -> list[Parameter]:
    """Return the parameters from the text of `to_text`."""
    return [Parameter(**entry) for entry in json.loads(text or "[]")]


def owners(parameters: list[Parameter]) -> list[str]:
    """Return the sorted names of the document objects, without repetition."""
    return sorted({parameter.owner for parameter in parameters})


def renamed(parameters: list[Parameter], names: dict[str, str]) -> list[Parameter]:
    """Return the parameters with the owners renamed."""
    return [replace(one, owner=names.get(one.owner, one.owner)) for one in parameters]


def criteria_in(text: str) -> dict[str, dict[str, float]]:
    """Return criteria such as `stretch <= 0.2, angle >= 12` as a study file has them.

    Raises ValueError for text that is not a criterion.
    """
    found: dict[str, dict[str, float]] = {}
    for piece in filter(str.strip, text.split(",")):
        limit = _LIMIT.fullmatch(piece)
        if limit is None:
            raise ValueError(
                f"'{piece.strip()}' is not a criterion; write it like stretch <= 0.2, "
                "with commas between several."
            )
        name, sign, value = limit.groups()
        try:
            found.setdefault(name, {})["max" if sign == "<=" else "min"] = float(value)
        except ValueError:
            raise ValueError(f"'{value}' in '{piece.strip()}' is not a number.") from None
    return found


def unused(name: str, taken) -> str:
    """Return a name that is not taken yet."""
    found, number = name, 2
    while found in taken:
        found, number = f"{name} {number}", number + 1
    return found
