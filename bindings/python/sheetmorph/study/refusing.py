# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusal of samples beyond the admissible range, before any computation."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..files.reading import read_text
from .plan import Plan
from .ranges import FILE
from .sampling import Values


class Refusals:
    """The limits of range.json in a folder, if they belong to the same study.

    A sample is refused if it exceeds the limit of a parameter, or both limits of a pair.
    """

    def __init__(self, plan: Plan, out: Path):
        found = _read(out / FILE)
        is_mine = found.get("hash") == plan.range_hash
        self._start: Values = found["start"] if is_mine else {}
        self._limits = _limits(found) if is_mine else []

    def why(self, values: Values) -> str:
        """Return why a sample is not computed, or an empty text."""
        for limit, towards, why in self._limits:
            if all(self._is_beyond(name, values[name], limit, towards) for name in limit):
                told = ", ".join(f"{name} = {values[name]:.6g}" for name in limit)
                ends = ", ".join(f"{end:.6g}" for end in limit.values())
                return f"{told} is outside {ends} of {FILE}: {why}"
        return ""

    def _is_beyond(self, name: str, value: float, limit: Values, towards: Values) -> bool:
        sign = 1.0 if towards[name] > self._start[name] else -1.0
        return sign * value > sign * limit[name]


def _limits(found: dict[str, Any]) -> list[tuple[Values, Values, str]]:
    """Return every limit beyond which a criterion fails, with its direction and reason."""
    alone = [
        ({name: entry[side]}, {name: entry["range"][end]}, entry[f"{side}_why"])
        for name, entry in found["parameters"].items()
        for end, side in enumerate(("low", "high"))
    ]
    together = [(entry["limit"], entry["towards"], entry["why"]) for entry in found["directions"]]
    return [entry for entry in alone + together if entry[2]]


def _read(path: Path) -> dict[str, Any]:
    """Return the content of a range.json; an empty dict if it is missing or invalid."""
    try:
        found = json.loads(read_text(path))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}
