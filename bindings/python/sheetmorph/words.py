# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence


def counted(number: int, one: str, many: str) -> str:
    """`1 vertex stands`, `2 vertices stand`."""
    return f"{number} {one if number == 1 else many}"


def either(words: Sequence[str]) -> str:
    """`mm`, `mm or cm`, `mm, cm or inch`."""
    *others, last = words
    return f"{', '.join(others)} or {last}" if others else last


def folds(number: int, where: str = "") -> str:
    """`1 triangle folds over`, `2 triangles of "lid" fold over`."""
    thing, does = ("triangle", "folds") if number == 1 else ("triangles", "fold")
    return f"{number} {thing}{where} {does} over"


def at_place(place: Iterable[float]) -> str:
    """`(1.5, 20, -3)`: a place in mm."""
    return "({})".format(", ".join(f"{x + 0.0:.6g}" for x in place))


def preparation(done: Mapping[str, int]) -> str:
    """What the cures of a mesh did, by the counts of their report."""
    welded = counted(done["welded"], "vertex", "vertices")
    removed = counted(done["removed"], "triangle", "triangles")
    return f"{welded} welded, {removed} removed, {done['split']} cut, {done['turned']} turned"
