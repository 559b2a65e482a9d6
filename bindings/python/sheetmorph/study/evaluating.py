# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as a function for optimisers: parameter values to measures and derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import Fault, RecipeError
from ..morph.session import Result
from ..reporting.report import make_report
from .figures import Figures
from .measures import Numbers as Measured
from .measures import Scene
from .plan import Plan
from .sampling import Values
from .working import Workshop

# Step of a central difference, as a share of the parameter range. The truncation error grows with
# the square of the step and the rounding error with its inverse. Here both stay below 1e-6 of a
# derivative.
_STEP = 2e-3

Given = Mapping[str, float] | Sequence[float]


class Evaluator:
    """Measures of a study at any parameter values, each from an exact answer.

    The pre-processing phase runs once for all values that share it.

    Parameters
    ----------
    study : str, path or dict
        The study file, or a study with paths relative to the working folder.

    Attributes
    ----------
    names : list of str
        Parameters (k).
    columns : list of str
        Measures (m).
    bounds : array (k, 2)
        Lower and upper limits of the parameters.

    Raises
    ------
    RecipeError, FileError, KernelError
    """

    def __init__(self, study: str | Path | dict[str, Any]):
        self._plan = Plan(study)
        self._shop = Workshop(self._plan)
        self._last: tuple[Values, Result] | None = None
        self.names: list[str] = self._plan.study.names
        self.columns: list[str] = self._plan.columns
        self.bounds = np.array([_bounds(entry) for entry in self._plan.study.parameters])

    @property
    def files_read(self) -> list[Path]:
        """The study, its recipe and the files of its parts."""
        found: list[Path] = self._plan.files_read
        return found

    def __call__(self, values: Given) -> dict[str, float | None]:
        """Return the measures by name.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values, by name or in the order of ``names``.

        Returns
        -------
        dict
            Measure to its value, None if it cannot be measured.

        Raises
        ------
        RecipeError
            If the values cannot be computed.
        """
        return self._measured(self._values(values))

    def array(self, values: Given) -> Floats:
        """Return the measures as an array.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values.

        Returns
        -------
        array (m,)
            Measures in the order of ``columns``; NaN if one cannot be measured.

        Raises
        ------
        RecipeError
            If the values cannot be computed.
        """
        return _array(self(values))

    def gradient(self, values: Given) -> Floats:
        """Return the derivatives of the measures, as central differences of exact answers.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values.

        Returns
        -------
        array (m, k)
            Derivative of each measure by each parameter.

        Raises
        ------
        RecipeError
            If the values cannot be computed.
        """
        told = self._values(values)
        slopes = [self._slopes(told, name, self._array) for name in self.names]
        return np.stack([slope[""] for slope in slopes], axis=-1)

    def positions(self, values: Given) -> dict[str, Floats]:
        """Return the positions of all parts.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values.

        Returns
        -------
        dict
            Part name to positions (n, 3), mm.

        Raises
        ------
        RecipeError
            If the values cannot be computed.
        """
        return dict(self._result(self._values(values)).positions)

    def position_gradients(self, values: Given) -> dict[str, Floats]:
        """Return the derivatives of the positions by the parameters.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values.

        Returns
        -------
        dict
            Part name to derivatives (n, 3, k), mm per unit of the parameter.

        Raises
        ------
        RecipeError
            If the values cannot be computed.
        """
        told = self._values(values)
        slopes = [self._slopes(told, name, self.positions) for name in self.names]
        return {part: np.stack([slope[part] for slope in slopes], axis=-1) for part in slopes[0]}

    def failures(self, values: Given) -> str:
        """Return the reasons why a variant fails.

        Parameters
        ----------
        values : mapping or sequence of float
            Parameter values.

        Returns
        -------
        str
            The reasons, empty if the variant passes.
        """
        return self._shop.verdict(self._values(values), True)

    def _slopes(
        self, values: Values, name: str, function: Callable[[Values], Mapping[str, Floats]]
    ) -> dict[str, Floats]:
        """Differentiate a function of the parameters by one of them."""
        low, high = self.bounds[self.names.index(name)]
        step = _STEP * ((high - low) or max(1.0, abs(low)))
        beyond, before = (function({**values, name: values[name] + s}) for s in (step, -step))
        return {key: (value - before[key]) / (2.0 * step) for key, value in beyond.items()}

    def _array(self, values: Values) -> dict[str, Floats]:
        return {"": self.array(values)}

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
            what = f"there is no value for {', '.join(missing)}"
            raise RecipeError([Fault("values", what, "give one for every parameter")])
        return {name: _finite(name, values[name]) for name in self.names}


def _array(measures: Mapping[str, float | None]) -> Floats:
    return np.array([np.nan if value is None else value for value in measures.values()], float)


def _bounds(entry: Any) -> tuple[float, float]:
    if entry.values:
        return float(min(entry.values)), float(max(entry.values))
    return entry.low, entry.high


def _finite(name: str, value: Any) -> float:
    number = float(value)
    if not np.isfinite(number):
        what = f"{name} is {number}, which is not a finite number"
        raise RecipeError([Fault("values", what, "give a finite number")])
    return number
