# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study file: read, checked against its schema, and converted to typed entries."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from ..base.errors import Fault, RecipeError
from ..base.packaged import packaged_json
from ..certifying import Criteria, read_criteria, shipped
from ..recipe.reading import given, named_in
from ..recipe.structure import faults_against
from ..recipe.values import depth_faults
from .expressions import Expression
from .paths import Step, steps_of

METHODS = ("full grid", "latin hypercube", "sobol", "halton", "csv")
_RANDOM = METHODS[1:4]


@dataclass(frozen=True)
class Parameter:
    """A number that the study varies.

    Attributes
    ----------
    steps : tuple
        Path in the recipe; empty if only formulas and measures use the parameter.
    low, high : float
        Range.
    values : tuple of float
        Values in place of a range.
    count : int
        Points of a full grid; 0 if not given.
    direction, distance_from, blend
        Meaning of the number, if it is not the value at the path.
    """

    name: str
    steps: tuple[Step, ...] = ()
    low: float = 0.0
    high: float = 0.0
    values: tuple[float, ...] = ()
    count: int = 0
    direction: tuple[float, ...] | None = None
    distance_from: Any = None
    blend: str | None = None

    @property
    def where(self) -> str:
        """Place in the study, for messages."""
        return f"parameters.{self.name}"

    def meaning(self) -> list[Any]:
        """Return the effect of a value as JSON; a variant depends on it besides the value."""
        moved = [self.direction, self.distance_from, self.blend]
        return [self.name, list(self.steps), *moved]


@dataclass(frozen=True)
class Sampling:
    """The sampling: method, count of variants or 0, seed, and a file with given samples."""

    method: str = "full grid"
    count: int = 0
    seed: int = 0
    file: Path | None = None


@dataclass(frozen=True)
class Study:
    """A study file of checked form; path and recipe are file paths."""

    path: Path
    recipe: Path
    parameters: tuple[Parameter, ...]
    sampling: Sampling
    constraints: tuple[Expression, ...] = ()
    measure: dict[str, dict[str, Any]] = field(default_factory=dict)
    criteria: dict[str, dict[str, float]] = field(default_factory=dict)
    write: tuple[str, ...] = ("parts", "certificate")
    certify: Criteria = Criteria("study")

    @property
    def names(self) -> list[str]:
        """Names of the parameters."""
        return [parameter.name for parameter in self.parameters]

    def parameter(self, name: str) -> Parameter:
        """Return the parameter with a name."""
        return next(entry for entry in self.parameters if entry.name == name)


@cache
def study_schema() -> dict[str, Any]:
    """Return the published JSON Schema of the study."""
    return packaged_json(__package__, "study.schema.json")


def read_study(study: str | Path | dict[str, Any]) -> Study:
    """Read a study, from its file or in memory. Raises RecipeError with all faults of its form."""
    data, place = given(study, "study")
    with named_in(place):
        return _study(place, data)


def _study(path: Path, data: Any) -> Study:
    faults = depth_faults(data) or faults_against(study_schema(), data)
    faults = [replace(f, where="study" if f.where == "recipe" else f.where) for f in faults]
    if faults:
        raise RecipeError(faults)
    parameters = tuple(_parameter(name, entry) for name, entry in data["parameters"].items())
    names = [entry.name for entry in parameters]
    measure = data.get("measure", {})
    _require(_name_faults(names, measure))
    sampling = _sampling(path.parent, data.get("sampling", {}), parameters)
    return Study(
        path=path,
        recipe=path.parent / data["recipe"],
        parameters=parameters,
        sampling=sampling,
        constraints=_constraints(data.get("constraints", []), names),
        measure=measure,
        criteria=data.get("criteria", {}),
        write=tuple(data.get("write", Study.write)),
        certify=_certify(path.parent, data.get("certify")),
    )


def _certify(folder: Path, told: str | None) -> Criteria:
    """Return the criteria for elements and contacts; the study itself judges flipped triangles."""
    if told is None:
        return replace(Study.certify, flipped=False)
    found = read_criteria(told if told in shipped() else folder / told)
    return replace(found, flipped=False)


def _parameter(name: str, entry: dict[str, Any]) -> Parameter:
    where = f"parameters.{name}"
    steps = tuple(steps_of(entry["path"], where)) if "path" in entry else ()
    _require(_parameter_faults(where, entry, steps))
    low, high = entry.get("range", (0.0, 0.0))
    direction = entry.get("direction")
    return Parameter(
        name=name,
        steps=steps,
        low=float(low),
        high=float(high),
        values=tuple(entry.get("values", ())),
        count=int(entry.get("steps", 0)),
        direction=None if direction is None else tuple(map(float, direction)),
        distance_from=entry.get("distance_from"),
        blend=entry.get("blend"),
    )


def _parameter_faults(where: str, entry: dict[str, Any], steps: tuple[Step, ...]) -> list[Fault]:
    faults = []
    if ("range" in entry) == ("values" in entry):
        what = "it has both a range and values" if "range" in entry else "it has no range"
        faults.append(Fault(where, what, 'give either "range" or "values"'))
    elif "range" in entry and not entry["range"][0] <= entry["range"][1]:
        faults.append(Fault(f"{where}.range", "the first number is larger", "swap the two numbers"))
    moved = [key for key in ("direction", "distance_from", "blend") if key in entry]
    if len(moved) > 1:
        faults.append(
            Fault(where, f"only one of {' and '.join(moved)} can be given", "keep one of them")
        )
    elif moved == ["blend"] and steps:
        faults.append(Fault(where, "a blend of poses has no path", 'leave out "path"'))
    elif moved and moved != ["blend"] and not _is_translation(steps):
        todo = 'give it a path such as "pose.tip.translation"'
        faults.append(Fault(where, f'"{moved[0]}" is for the translation of a handle', todo))
    if moved == ["direction"] and not any(entry["direction"]):
        faults.append(Fault(f"{where}.direction", "its length is 0", "give a direction"))
    return faults


def _is_translation(steps: tuple[Step, ...]) -> bool:
    return len(steps) == 3 and steps[0] == "pose" and steps[2] == "translation"


def _name_faults(names: list[str], measure: dict[str, Any]) -> list[Fault]:
    taken = {"run", "status", "why"}
    faults = [
        Fault(f"parameters.{name}", "a column of the table has that name", "use another name")
        for name in names
        if name in taken
    ]
    return faults + [
        Fault(f"measure.{name}", "a parameter or a column has that name", "use another name")
        for name in measure
        if name in taken or name in names
    ]


def _sampling(folder: Path, entry: dict[str, Any], parameters: tuple[Parameter, ...]) -> Sampling:
    file = entry.get("file")
    method = entry.get("method", "full grid" if file is None else "csv")
    sampling = Sampling(
        method,
        int(entry.get("count", 0)),
        int(entry.get("seed", 0)),
        None if file is None else folder / file,
    )
    _require(_sampling_faults(sampling, parameters))
    return sampling


def _sampling_faults(sampling: Sampling, parameters: tuple[Parameter, ...]) -> list[Fault]:
    faults = []
    if (sampling.method == "csv") != (sampling.file is not None):
        todo = 'name it with "file"' if sampling.file is None else 'use the method "csv"'
        faults.append(Fault("sampling", "a CSV file needs the method csv", todo))
    if sampling.method in _RANDOM and not sampling.count:
        faults.append(Fault("sampling", "the count is missing", 'add "count"'))
    unstepped = [p.name for p in parameters if not p.values and not p.count and p.low < p.high]
    if sampling.method == "full grid" and unstepped and not sampling.count:
        what = f'the full grid has no number of steps for {", ".join(unstepped)}'
        faults.append(Fault("sampling", what, 'give "steps" to the parameter, or a "count" here'))
    return faults


def _constraints(texts: list[str], names: list[str]) -> tuple[Expression, ...]:
    found = []
    for k, text in enumerate(texts):
        where = f"constraints[{k}]"
        expression = Expression(text, names, where)
        if not expression.is_comparison:
            what = f'"{text}" compares nothing'
            _require([Fault(where, what, "write it such as lift <= 2 * reach")])
        found.append(expression)
    return tuple(found)


def _require(faults: list[Fault]) -> None:
    if faults:
        raise RecipeError(faults)
