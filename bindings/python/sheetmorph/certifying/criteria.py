# SPDX-License-Identifier: LGPL-2.1-or-later
"""Criteria of a certificate: supplied sets with names, or a file of the user."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..base.errors import FileError
from ..base.packaged import packaged_json
from ..files.comments import is_toml, parsed
from ..files.reading import read_text
from ..measuring.quality import MEASURES

_OTHERS = ("set", "comment", "elements", "time_step", "features", "contacts")


@dataclass(frozen=True)
class Criteria:
    """The criteria of a certificate.

    elements maps a measure to its limits "min" and "max". target is the time step for mass scaling,
    ms, or None. allowed is the number of elements that may newly fail. gap_change is the limit for
    contacts, mm, or None. flipped states whether flipped triangles fail.
    """

    name: str
    elements: dict[str, dict[str, float]] = field(default_factory=dict)
    target: float | None = None
    allowed: int = 0
    gap_change: float | None = None
    flipped: bool = True


def shipped() -> dict[str, Any]:
    """Return the supplied sets by name."""
    return packaged_json(__package__, "criteria.json")


def read_criteria(name: str | Path | None) -> Criteria:
    """Return a set by its name, or the criteria of a JSON or TOML file. Raises FileError."""
    sets = shipped()
    if name is None or str(name) in sets:
        key = "standard" if name is None else str(name)
        return _criteria(Path(key), key, sets[key])
    path = Path(name)
    try:
        found = parsed(read_text(path), path)
    except OSError as error:
        todo = f"name a file, or one of the sets {', '.join(sets)}"
        raise FileError.of(path, error, todo) from None
    except ValueError as error:
        form = "TOML" if is_toml(path) else "JSON"
        raise FileError(path, f"it is not {form} ({error})", "correct it") from None
    if not isinstance(found, dict):
        raise FileError(path, "criteria must be an object", 'write {"elements": {...}}')
    base = found.get("set", "")
    if base and base not in sets:
        raise FileError(path, f'there is no set "{base}"', f"use one of {', '.join(sets)}")
    merged = {**sets.get(base, {}), **found}
    merged["elements"] = {**sets.get(base, {}).get("elements", {}), **found.get("elements", {})}
    return _criteria(path, path.name, merged)


def _criteria(path: Path, name: str, found: dict[str, Any]) -> Criteria:
    unknown = [key for key in found if key not in _OTHERS]
    if unknown:
        raise FileError(path, f'unknown key "{unknown[0]}"', f"use {', '.join(_OTHERS)}")
    elements = dict(found.get("elements", {}))
    allowed = elements.pop("newly_failing", 0)
    for measure, limits in elements.items():
        if measure not in MEASURES:
            todo = f"use {', '.join(MEASURES)} or newly_failing"
            raise FileError(path, f'there is no measure "{measure}"', todo)
        is_sound = isinstance(limits, dict) and set(limits) <= {"min", "max"}
        if not is_sound or not all(_is_number(value) for value in limits.values()):
            what = f'"{measure}" needs numbers under "min" or "max"'
            raise FileError(path, what, 'write {"max": 10}')
    target = found.get("time_step", {}).get("target_ms")
    gap = found.get("contacts", {}).get("gap_change")
    for value in (target, gap, allowed):
        if value is not None and not (_is_number(value) and value >= 0):
            raise FileError(path, f"{value!r} is not a number of 0 or more", "write a number")
    return Criteria(name, elements, target, int(allowed), gap)


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
