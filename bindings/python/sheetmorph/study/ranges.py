# SPDX-License-Identifier: LGPL-2.1-or-later
"""Admissible ranges of parameters until the first criterion fails, singly and in pairs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from ..base.errors import Fault, RecipeError
from ..base.progress import Progress
from .paths import value_at
from .plan import Plan
from .reading import Parameter
from .sampling import Values
from .working import Workshop

FILE = "range.json"
# Steps along a range before the bisection.
_STEPS = 12
# Accuracy of a limit, as a share of the range.
_FINE = 1e-4

Verdict = Callable[[float, bool], str]


@dataclass(frozen=True)
class Limit:
    """The largest admissible share of a way, from 0 to 1.

    why names the criterion that fails beyond it, or is empty.
    """

    share: float
    why: str = ""


def possible_ranges(plan: Plan, progress: Progress | None = None) -> dict[str, Any]:
    """Return the content of range.json.

    Raises RecipeError if the start itself is not admissible.
    """
    shop = Workshop(plan)
    moving = [
        entry for entry in plan.study.parameters if not entry.values and entry.low < entry.high
    ]
    start = {entry.name: _start(entry, plan) for entry in plan.study.parameters}
    why = shop.verdict(start, True)
    if why:
        told = ", ".join(f"{name} = {value:.6g}" for name, value in start.items())
        todo = "start from another pose of the recipe, or loosen the criteria"
        raise RecipeError([Fault(f"{plan.study.path}", f"at {told}: {why}", todo)])
    ways = _ways(moving)
    found = []
    for k, way in enumerate(ways):
        if progress is not None and not progress(k / len(ways), " and ".join(way)):
            raise KeyboardInterrupt
        ends = {name: _end(plan.study.parameter(name), sign) for name, sign in way.items()}
        found.append((way, ends, _along(shop, start, ends)))
    return {"sheetmorph_study_range": 1, "hash": plan.range_hash, **_told(start, moving, found)}


def _along(shop: Workshop, start: Values, ends: Mapping[str, float]) -> Limit:
    def verdict(share: float, exact: bool) -> str:
        return shop.verdict(_between(start, ends, share), exact)

    return limit_of(verdict)


def limit_of(verdict: Verdict) -> Limit:
    """Return the limit of a way, found with live answers and confirmed with exact ones."""
    near = searched(lambda share: verdict(share, False), 0.0, 1.0)
    low = max(0.0, near.share - _FINE)
    high = min(1.0, near.share + 2.0 * _FINE)
    confirmed = not verdict(low, True) and (bool(verdict(high, True)) if near.why else True)
    if confirmed and not near.why:
        return Limit(1.0) if not verdict(1.0, True) else _exactly(verdict, low, 1.0)
    return _exactly(verdict, low, high) if confirmed else _exactly(verdict, 0.0, 1.0)


def _exactly(verdict: Verdict, low: float, high: float) -> Limit:
    return searched(lambda share: verdict(share, True), low, high)


def searched(verdict: Callable[[float], str], low: float = 0.0, high: float = 1.0) -> Limit:
    """Search in steps for the first failing share, then bisect; low is admissible."""
    steps = max(1, math.ceil(_STEPS * (high - low)))
    possible, why = low, ""
    for k in range(1, steps + 1):
        place = high if k == steps else low + k * (high - low) / steps
        why = verdict(place)
        if why:
            break
        possible = place
    if not why:
        return Limit(high)
    beyond = place
    while beyond - possible > _FINE:
        middle = 0.5 * (possible + beyond)
        told = verdict(middle)
        if told:
            beyond, why = middle, told
        else:
            possible = middle
    return Limit(possible, why)


def _ways(moving: list[Parameter]) -> list[dict[str, int]]:
    """Return each parameter alone, down and up, then each pair in the four diagonal directions."""
    alone = [{entry.name: sign} for entry in moving for sign in (-1, 1)]
    between = [
        {one.name: a, other.name: b}
        for one, other in itertools.combinations(moving, 2)
        for a in (-1, 1)
        for b in (-1, 1)
    ]
    return alone + between


def _start(entry: Parameter, plan: Plan) -> float:
    """Return the recipe's own value if the study admits it, else the central value."""
    own = 0.0 if entry.direction or entry.blend else value_at(plan.recipe, entry.steps or ("",))
    own = own if isinstance(own, (int, float)) and not isinstance(own, bool) else None
    if own is None and entry.steps[:1] == ("pose",) and entry.distance_from is None:
        own = 0.0
    if entry.values:
        found: float = own if own in entry.values else entry.values[len(entry.values) // 2]
        return found
    if own is not None and entry.low <= own <= entry.high:
        return float(own)
    return 0.5 * (entry.low + entry.high)


def _end(entry: Parameter, sign: int) -> float:
    return entry.high if sign > 0 else entry.low


def _between(start: Values, ends: Mapping[str, float], share: float) -> Values:
    """Return the values at a share of the way; at share 1 exactly those of its end."""
    if share >= 1.0:
        return {**start, **ends}
    moved = {name: start[name] + share * (end - start[name]) for name, end in ends.items()}
    return {**start, **moved}


def _told(
    start: Values, moving: list[Parameter], found: list[tuple[dict[str, int], Any, Limit]]
) -> dict[str, Any]:
    alone: dict[str, Any] = {
        entry.name: {"range": [entry.low, entry.high], "start": start[entry.name]}
        for entry in moving
    }
    between = []
    for way, ends, limit in found:
        at = _between(start, ends, limit.share)
        if len(way) == 1:
            ((name, sign),) = way.items()
            side = "high" if sign > 0 else "low"
            alone[name] |= {side: at[name], f"{side}_why": limit.why}
        else:
            place = {name: at[name] for name in way}
            between.append({"towards": dict(ends), "limit": place, "why": limit.why})
    return {"start": start, "parameters": alone, "directions": between}
