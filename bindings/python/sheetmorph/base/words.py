# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and lists as text for the user."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice

_NOISE = 1e-9  # mm


def counted(number: int, one: str, many: str) -> str:
    """Return a count with its noun, such as `1 vertex stands` or `2 vertices stand`."""
    return f"{number} {one if number == 1 else many}"


def several(names: Iterable[str]) -> str:
    """Return the first three names, such as `a, b, c, ...`."""
    first = list(islice(names, 4))
    return ", ".join([*first[:3], *(["..."] if len(first) > 3 else [])])


def either(words: Sequence[str]) -> str:
    """Join alternatives: `mm`, `mm or cm`, `mm, cm or inch`."""
    *others, last = words
    return f"{', '.join(others)} or {last}" if others else last


def folds(number: int, where: str = "") -> str:
    """Return `1 triangle folds over`, `2 triangles of "lid" fold over`."""
    thing, does = ("triangle", "folds") if number == 1 else ("triangles", "fold")
    return f"{number} {thing}{where} {does} over"


def energy(millijoules: float) -> str:
    """Return an energy with the unit that fits it: mJ, J or kJ."""
    for unit, size in (("kJ", 1e6), ("J", 1e3)):
        if abs(millijoules) >= size:
            return f"{millijoules / size:.3g} {unit}"
    return f"{millijoules:.3g} mJ"


def tidy(number: float) -> str:
    """Return a length in mm as text; rounding noise becomes 0."""
    return f"{0.0 if abs(number) < _NOISE else number:.6g}"


def at_place(place: Iterable[float]) -> str:
    """Return a position in mm as `(1.5, 20, -3)`."""
    return "({})".format(", ".join(map(tidy, place)))


def preparation(done: Mapping[str, int]) -> str:
    """Summarise the mesh preparation from the counts of the report."""
    welded = counted(done["welded"], "vertex", "vertices")
    removed = counted(done["removed"], "triangle", "triangles")
    return f"{welded} merged, {removed} removed, {done['split']} cut, {done['turned']} reoriented"
