# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as a function for optimisers: from values of the parameters to measures and slopes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import Fault, RecipeError
from ..report import make_report
from ..session import Result
from .figures import Figures
from .measures import Numbers, Scene
from .plan import Plan
from .sampling import Values
from .working import Workshop

# Central differences of the sixth order: places in steps, and weights.
_STENCIL = ((1, 45.0 / 60.0), (2, -9.0 / 60.0), (3, 1.0 / 60.0))
# A step, of the range: rounding and the order's own error are both far below 1e-6 there.
_STEP = 5e-3

Given = Mapping[str, float] | Sequence[float]


class Evaluator:
    """Measures of a study's recipe at any values of its parameters, each by an exact answer.

    names, columns: of parameters and measures; bounds: (k, 2) of the parameters. Pre-processing is
    done once for all values that share it. Raises RecipeError, FileError, KernelError.
    """

    def __init__(self, study: str | Path):
        self._plan = Plan(study)
        self._shop = Workshop(self._plan)
        self._last: tuple[Values, Result] | None = None
        self.names: list[str] = self._plan.study.names
        self.columns: list[str] = self._plan.columns
        self.bounds = np.array([_bounds(entry) for entry in self._plan.study.parameters])

    def __call__(self, values: Given) -> dict[str, float | None]:
        """The measures, by column. Raises RecipeError for values that cannot be computed."""
        return self._measured(self._values(values))

    def array(self, values: Given) -> np.ndarray:
        """The measures (m,) in the order of `columns`; NaN where there is nothing to measure."""
        return _array(self(values))

    def gradient(self, values: Given) -> np.ndarray:
        """Slopes (m, k) of the measures over the parameters."""
        told = self._values(values)
        return self._slopes(told, lambda at: _array(self._measured(at)))

    def positions(self, values: Given) -> dict[str, np.ndarray]:
        """Positions (n, 3) by part, mm."""
        return dict(self._result(self._values(values)).positions)

    def position_gradients(self, values: Given) -> dict[str, np.ndarray]:
        """Slopes (n, 3, k) of the positions over the parameters, by part."""
        told = self._values(values)
        parts = list(self.positions(told))
        ends = np.cumsum([len(self._plan.parts.meshes[name].points) for name in parts])

        def all_positions(at: Values) -> np.ndarray:
            return np.concatenate([self.positions(at)[name] for name in parts])

        slopes = self._slopes(told, all_positions)
        return dict(zip(parts, np.split(slopes, ends[:-1])))

    def failures(self, values: Given) -> str:
        """Why a variant would not pass; empty if it would."""
        return self._shop.verdict(self._values(values), True)

    def _slopes(self, values: Values, function: Callable[[Values], np.ndarray]) -> np.ndarray:
        """Differences of exact answers on both sides of the values, one parameter after another."""
        return np.stack([self._slope(values, k, function) for k in range(len(self.names))], axis=-1)

    def _slope(
        self, values: Values, k: int, function: Callable[[Values], np.ndarray]
    ) -> np.ndarray:
        name, (low, high) = self.names[k], self.bounds[k]
        step = _STEP * ((high - low) or max(1.0, abs(low)))
        total: Any = 0.0
        for places, weight in _STENCIL:
            beyond = function({**values, name: values[name] + places * step})
            before = function({**values, name: values[name] - places * step})
            total = total + weight * (beyond - before)
        return total / step

    def _measured(self, values: Values) -> Numbers:
        result = self._result(values)

        @cache
        def figures() -> Figures:
            return Figures(result, make_report(result))

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


def _array(measures: Mapping[str, float | None]) -> np.ndarray:
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
