# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study changes and asks for: parameters as text, criteria as a person writes them."""

from __future__ import annotations

import json
import re
from dataclasses import asdict, dataclass, replace

LENGTH, ANGLE, NUMBER = "mm", "deg", ""
METHODS = ["latin hypercube", "sobol", "halton", "full grid"]
"""How a study is sampled, as a study file says it."""
MEASURED = ("stretch", "angle")
"""Figures that every study measures."""
_LIMIT = re.compile(r"\s*([\w .]*?\w)\s*(<=|>=)\s*([-+.\deE]+)\s*")


@dataclass(frozen=True)
class Parameter:
    """A number of a document that a study changes between two others.

    owner: name of the document object; number: its property, or the cell of a spreadsheet.
    """

    name: str
    owner: str
    number: str
    low: float
    high: float


def to_text(parameters: list[Parameter]) -> str:
    """The parameters as JSON; every number is read back to the bit."""
    return json.dumps([asdict(parameter) for parameter in parameters])


def from_text(text: str) -> list[Parameter]:
    """What ``to_text`` wrote."""
    return [Parameter(**entry) for entry in json.loads(text or "[]")]


def owners(parameters: list[Parameter]) -> list[str]:
    """The names of the document objects, each once, in an order that stays."""
    return sorted({parameter.owner for parameter in parameters})


def renamed(parameters: list[Parameter], names: dict[str, str]) -> list[Parameter]:
    """The same numbers of objects with other names."""
    return [replace(one, owner=names.get(one.owner, one.owner)) for one in parameters]


def criteria_in(text: str) -> dict[str, dict[str, float]]:
    """What ``stretch <= 0.2, angle >= 12`` asks for, as a study file has it; raises ValueError."""
    found: dict[str, dict[str, float]] = {}
    for piece in filter(str.strip, text.split(",")):
        limit = _LIMIT.fullmatch(piece)
        if limit is None:
            raise ValueError(
                f"'{piece.strip()}' is no criterion; write it such as stretch <= 0.2, and commas "
                "between several."
            )
        name, sign, value = limit.groups()
        try:
            found.setdefault(name, {})["max" if sign == "<=" else "min"] = float(value)
        except ValueError:
            raise ValueError(f"'{value}' in '{piece.strip()}' is no number.") from None
    return found


def unused(name: str, taken) -> str:
    """A name that is not taken yet."""
    found, number = name, 2
    while found in taken:
        found, number = f"{name} {number}", number + 1
    return found
