# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as a function for optimisers: from values of the parameters to measures and slopes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ..arrays import Floats
from ..errors import Fault, RecipeError
from ..report import make_report
from ..session import Result
from ..translation import Numbers
from .figures import OF_POSITIONS, Figures, live_report
from .measures import Numbers as Measured
from .measures import Scene
from .plan import Plan
from .sampling import Values
from .working import Workshop

# Central differences of the sixth order: places in steps, and weights.
_STENCIL = ((1, 45.0 / 60.0), (2, -9.0 / 60.0), (3, 1.0 / 60.0))
# A step, of the range: rounding and the order's own error are both far below 1e-6 there.
_STEP = 5e-3

Given = Mapping[str, float] | Sequence[float]


class _NewPreprocessing(Exception):
    """A parameter does not only change the pose."""


class Evaluator:
    """Measures of a study's recipe at any values of its parameters, each by an exact answer.

    names, columns: of parameters and measures; bounds: (k, 2) of the parameters. Pre-processing is
    done once for all values that share it. Slopes of positions come from the solves themselves,
    differentiated with the factors that are there; differenced: the parameters of the last slopes
    for which they came from differences of exact answers, with why. Raises RecipeError, FileError,
    KernelError.
    """

    def __init__(self, study: str | Path):
        self._plan = Plan(study)
        self._shop = Workshop(self._plan)
        self._last: tuple[Values, Result] | None = None
        worst = [told["worst"] for told in self._plan.study.measure.values() if "worst" in told]
        self._needs_answers = [name for name in worst if name not in OF_POSITIONS]
        self.differenced: dict[str, str] = {}
        self.names: list[str] = self._plan.study.names
        self.columns: list[str] = self._plan.columns
        self.bounds = np.array([_bounds(entry) for entry in self._plan.study.parameters])

    @property
    def files_read(self) -> list[Path]:
        """The study, its recipe and the files of its parts."""
        found: list[Path] = self._plan.files_read
        return found

    def __call__(self, values: Given) -> dict[str, float | None]:
        """The measures, by column. Raises RecipeError for values that cannot be computed."""
        return self._measured(self._values(values))

    def array(self, values: Given) -> Floats:
        """The measures (m,) in the order of `columns`; NaN where there is nothing to measure."""
        return _array(self(values))

    def gradient(self, values: Given) -> Floats:
        """Slopes (m, k) of the measures over the parameters."""
        told = self._values(values)
        if self._needs_answers:
            why = f'"{self._needs_answers[0]}" is measured of an exact answer'
            rates, self.differenced = {}, dict.fromkeys(self.names, why)
        else:
            rates = self._rates(told)
        return np.stack([self._measure_slope(told, name, rates) for name in self.names], axis=-1)

    def positions(self, values: Given) -> dict[str, Floats]:
        """Positions (n, 3) by part, mm."""
        return dict(self._result(self._values(values)).positions)

    def position_gradients(self, values: Given) -> dict[str, Floats]:
        """Slopes (n, 3, k) of the positions over the parameters, by part."""
        told = self._values(values)
        rates = self._rates(told)
        found = [rates.get(name) or self._position_slope(told, name) for name in self.names]
        return {part: np.stack([rate[part] for rate in found], axis=-1) for part in found[0]}

    def failures(self, values: Given) -> str:
        """Why a variant would not pass; empty if it would."""
        return self._shop.verdict(self._values(values), True)

    def _rates(self, values: Values) -> dict[str, dict[str, Floats]]:
        """Slopes (n, 3) of the positions by parameter and part, by differentiating the solves; of
        the parameters for which they can be. `differenced` tells why of the others."""
        self.differenced = {}
        variant = self._plan.variant(values)
        session = self._shop.session(variant)
        directions = {}
        for name in self.names:
            try:
                directions[name] = self._direction(values, name, variant.key)
            except _NewPreprocessing:
                self.differenced[name] = "it needs another pre-processing phase"
        moving = {
            name: numbers
            for name, numbers in directions.items()
            if any(rate.any() for rate in numbers.values())
        }
        still = {part: np.zeros_like(mesh.points) for part, mesh in session.meshes.items()}
        try:
            rates = session.position_rates(variant.pose, list(moving.values())) if moving else []
        except session.core.NoDerivative as error:
            self.differenced |= dict.fromkeys(moving, str(error))
            return {name: still for name in directions if name not in moving}
        return {name: still for name in directions} | dict(zip(moving, rates))

    def _direction(self, values: Values, name: str, key: str) -> Numbers:
        """How the numbers of the pose, closed forms of a parameter, change with it."""

        def numbers(at: Values) -> dict[Any, Floats]:
            variant = self._plan.variant(at)
            if variant.key != key:
                raise _NewPreprocessing
            return self._shop.session(variant).pose_numbers(variant.pose)

        found = self._stencil(name, lambda step: numbers({**values, name: values[name] + step}))
        return {entry: np.asarray(rate) for entry, rate in found.items()}

    def _position_slope(self, values: Values, name: str) -> dict[str, Floats]:
        """Differences of exact answers on both sides."""
        return self._stencil(
            name, lambda step: self.positions({**values, name: values[name] + step})
        )

    def _measure_slope(
        self, values: Values, name: str, rates: Mapping[str, dict[str, Floats]]
    ) -> Floats:
        """Along the positions' own slopes where they are known, else of exact answers."""
        here = self._result(values)

        def measured(step: float) -> dict[str, Floats]:
            at = {**values, name: values[name] + step}
            if name not in rates:
                return {"": _array(self._measured(at))}
            moved = {p: here.positions[p] + step * rate for p, rate in rates[name].items()}
            there = replace(here, positions=moved)
            scene = Scene(moved, at, lambda *asked: _figures(there).figure(*asked))
            return {"": _array(self._shop.measures(values).taken(scene))}

        return self._stencil(name, measured)[""]

    def _stencil(
        self, name: str, function: Callable[[float], Mapping[Any, Floats]]
    ) -> dict[Any, Floats]:
        """The slope of what depends on a step of a parameter."""
        low, high = self.bounds[self.names.index(name)]
        step = _STEP * ((high - low) or max(1.0, abs(low)))
        total: dict[Any, Any] = {}
        for places, weight in _STENCIL:
            beyond, before = function(places * step), function(-places * step)
            for key, value in beyond.items():
                total[key] = total.get(key, 0.0) + weight * (value - before[key])
        return {key: value / step for key, value in total.items()}

    def _measured(self, values: Values) -> Measured:
        result = self._result(values)

        @cache
        def figures() -> Figures:
            return Figures(result, make_report(result, is_brief=True))

        def figure(name: str, part: str) -> float | None:
            return figures().figure(name, part)

        return self._shop.measures(values).taken(Scene(result.positions, values, figure))

    def _result(self, values: Values) -> Result:
        if self._last is None or self._last[0] != values:
            self._last = (dict(values), self._shop.result(values))
        return self._last[1]

    def _values(self, values: Given) -> Values:
        if not isinstance(values, Mapping):
            if len(values) != len(self.names):
                what = f"{len(values)} values are given for {len(self.names)} parameters"
                raise RecipeError([Fault("values", what, f"give {', '.join(self.names)}")])
            values = dict(zip(self.names, values))
        missing = [name for name in self.names if name not in values]
        if missing:
            what = f"no value is given for {', '.join(missing)}"
            raise RecipeError([Fault("values", what, "give one for every parameter")])
        return {name: _finite(name, values[name]) for name in self.names}


@lru_cache(maxsize=1)
def _figures(moved: Result) -> Figures:
    """Those that positions alone decide."""
    return Figures(moved, live_report(moved))


def _array(measures: Mapping[str, float | None]) -> Floats:
    return np.array([np.nan if value is None else value for value in measures.values()], float)


def _bounds(entry: Any) -> tuple[float, float]:
    if entry.values:
        return float(min(entry.values)), float(max(entry.values))
    return entry.low, entry.high


def _finite(name: str, value: Any) -> float:
    number = float(value)
    if not np.isfinite(number):
        what = f"{name} is {number}, no finite number"
        raise RecipeError([Fault("values", what, "give a finite number")])
    return number
