# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reproducible parameter values of the variants of a study."""

from __future__ import annotations

import csv
import itertools
import math
import warnings
from pathlib import Path


from ..base.arrays import Floats
from ..base.errors import Fault, FileError, RecipeError
from .reading import Parameter, Sampling, Study

MOST_VARIANTS = 1_000_000
Values = dict[str, float]


def samples_of(study: Study) -> list[Values]:
    """Return the parameter values of each variant. Raises RecipeError, FileError."""
    sampling = study.sampling
    if sampling.method == "csv":
        return _from_csv(study)
    if sampling.method == "full grid":
        return _full_grid(study)
    unit = _unit_samples(sampling, len(study.parameters))
    return [
        {entry.name: _at(entry, float(u)) for entry, u in zip(study.parameters, row)}
        for row in unit
    ]


def out_of_range(study: Study, values: Values) -> str:
    """Return which range, list or constraint excludes the values, or an empty text."""
    for entry in study.parameters:
        value = values[entry.name]
        if entry.values and value not in entry.values:
            return f"{entry.name} = {value:.6g} is not one of its values"
        if not entry.values and not entry.low <= value <= entry.high:
            return f"{entry.name} = {value:.6g} is outside {entry.low:.6g} to {entry.high:.6g}"
    for constraint in study.constraints:
        if constraint.value(values) is not True:
            return f"the constraint {constraint.text} does not hold"
    return ""


def _at(entry: Parameter, share: float) -> float:
    """Return the value at a share from 0 to 1 of the range or of the list."""
    if entry.values:
        return entry.values[min(int(share * len(entry.values)), len(entry.values) - 1)]
    return min(max(entry.low + share * (entry.high - entry.low), entry.low), entry.high)


def _unit_samples(sampling: Sampling, parameters: int) -> Floats:
    """Return samples (count, parameters) between 0 and 1."""
    # Imported here, so that only sampling needs scipy.
    try:
        from scipy.stats import qmc
    except ImportError:
        todo = "install python3-scipy, or give the samples as a CSV"
        what = f'the method "{sampling.method}" needs scipy'
        raise RecipeError([Fault("sampling", what, todo)]) from None
    kinds = {"latin hypercube": qmc.LatinHypercube, "sobol": qmc.Sobol, "halton": qmc.Halton}
    sampler = kinds[sampling.method](parameters, seed=sampling.seed)
    with warnings.catch_warnings():
        # Sobol warns if the count is not a power of two; the count is the user's choice.
        warnings.simplefilter("ignore", UserWarning)
        found: Floats = sampler.random(sampling.count)
        return found


def _full_grid(study: Study) -> list[Values]:
    each = _steps_within(study)
    axes = [_axis(entry, each) for entry in study.parameters]
    total = math.prod(map(len, axes))
    if total > MOST_VARIANTS:
        what = f"the full grid has {total} variants"
        todo = f"use fewer steps, at most {MOST_VARIANTS} variants"
        raise RecipeError([Fault(f"{study.path}, sampling", what, todo)])
    return [dict(zip(study.names, row)) for row in itertools.product(*axes)]


def _steps_within(study: Study) -> int:
    """Return the points of each range without a count, so that the grid has at most `count`."""
    asked = [entry for entry in study.parameters if not entry.values and not entry.count]
    given = [len(e.values) or e.count for e in study.parameters if e not in asked]
    room = study.sampling.count / math.prod(given) if study.sampling.count else 1.0
    steps = 1
    while asked and (steps + 1) ** len(asked) <= room:
        steps += 1
    return steps


def _axis(entry: Parameter, each: int) -> list[float]:
    steps = entry.count or each
    if entry.values:
        return list(entry.values)
    if steps == 1:
        return [0.5 * (entry.low + entry.high)]
    return [_at(entry, k / (steps - 1)) for k in range(steps)]


def _from_csv(study: Study) -> list[Values]:
    path = study.sampling.file
    assert path is not None  # the method "csv" has one
    rows = _csv_rows(path)
    header = [name.strip() for name in rows[0][1]] if rows else []
    missing = [name for name in study.names if name not in header]
    if missing:
        what = f"it has no column {', '.join(missing)}"
        raise FileError(path, what, "its first line names the parameters", 1)
    columns = {name: header.index(name) for name in study.names}
    samples = [
        {name: _number(path, line, row, column) for name, column in columns.items()}
        for line, row in rows[1:]
    ]
    if not samples:
        raise FileError(path, "it has no samples", "give a line for each variant")
    return samples[: study.sampling.count or None]


def _csv_rows(path: Path) -> list[tuple[int, list[str]]]:
    """Return line numbers and cells of the non-empty lines."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            reader = csv.reader(file)
            return [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except OSError as error:
        raise FileError.of(path, error) from None
    except (UnicodeDecodeError, csv.Error):
        raise FileError(path, "is not a CSV file in UTF-8", "save it as UTF-8") from None


def _number(path: Path, line: int, row: list[str], column: int) -> float:
    text = row[column].strip() if column < len(row) else ""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise FileError(path, f'"{text}" is not a number', "give a number in every column", line)
    return value
