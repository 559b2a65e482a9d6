# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: many variants of an assembly, computed in separate processes, as a table."""

from __future__ import annotations

import csv
import json
import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from freecad.sheetmorph import reporting
from freecad.sheetmorph.api.checks import number, require_assembly, require_kind
from freecad.sheetmorph.api.features import shape_of
from freecad.sheetmorph.api.files import export_recipe
from freecad.sheetmorph.bridge import kernel, recipes
from freecad.sheetmorph.bridge import variables as numbers
from freecad.sheetmorph.bridge.study_run import StudyRun
from freecad.sheetmorph.bridge.variables import Variable
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.objects.study import (
    StudyProxy,
    keep_parameters,
    kept_parameters,
    kept_results,
)
from freecad.sheetmorph.tools import studies as tools
from freecad.sheetmorph.tools.studies import METHODS, Parameter

RECIPE, STUDY, SAMPLES = "recipe.json", "study.json", "samples.csv"
PAUSE = 0.05  # seconds between two checks of a process
SETTINGS = {"sampling": "Sampling", "count": "Count", "seed": "Seed", "criteria": "Criteria"}
SETTINGS["folder"] = "Folder"


def add_study(assembly, label: str = "Study", **settings: Any):
    """Add a study to an assembly and return it; see `set_study` for `settings`."""
    require_assembly(assembly)
    check(assembly, settings)
    study = assembly.Document.addObject("App::FeaturePython", "Study")
    StudyProxy(study)
    study.Label = label
    assembly.addObject(study)
    put(study, settings)
    return study


def set_study(study, **settings: Any) -> None:
    """Set the parameters and options of a study; omitted settings stay unchanged.

    Parameters
    ----------
    study : object
        The study.
    parameters : sequence of tuple
        (name, object, property or cell, low, high) of numbers from `variables`; mm or degrees.
    sampling : str
        "latin hypercube", "sobol", "halton" or "full grid".
    count, seed : int
        Number of variants, and seed.
    criteria : str
        Such as "stretch <= 0.2, angle >= 12".
    folder : str
        Folder for the files; "" for the table only.

    Raises
    ------
    ValueError
        For invalid settings.
    """
    check(owner_of(study), settings)
    put(study, settings)


def variables(assembly) -> list[Variable]:
    """Return the numbers that a study can vary, each with `owner`, `number`, `label`, `unit`.

    They are motions of handles, sizes and prescribed rotations of form features, and spreadsheet
    cells that drive any of those.
    """
    require_assembly(assembly)
    return numbers.variables_of(assembly)


def write_study(study, folder: str | os.PathLike) -> Path:
    """Write recipe, parts at rest and study file into a folder; return the path of the study.

    `python3 -m sheetmorph study` computes it, here or on another machine. Raises MorphError,
    ValueError, OSError.
    """
    assembly, place = owner_of(study), Path(folder)
    parameters = kept_parameters(study)
    if not parameters:
        raise ValueError(f"The study '{study.Label}' has no parameter yet; add one.")
    place.mkdir(parents=True, exist_ok=True)
    names = recipes.names_of(assembly)
    path = export_recipe(assembly, place / RECIPE)
    recipe = json.loads(path.read_text("utf-8"))
    own = [Variable(owner_in(study, one), one.number, one.name, "") for one in parameters]
    driven = driven_numbers(assembly)
    for one in own + driven:
        if one.owner.Name in names:
            numbers.say_number(recipe, names[one.owner.Name], one, value_of(one))
    write(path, recipe)
    entries = study_entries(study, names)
    write(place / STUDY, entries)
    if driven:
        follow_expressions(study, entries, place, driven)
        write(place / STUDY, entries)
    return place / STUDY


def run_study(study) -> dict[str, int]:
    """Compute a study in separate processes, store its table and return the counts by status.

    Raises MorphError, ValueError with the faults of the study, OSError.
    """
    with begun(study) as run:
        while not run.is_over:
            told = reporting.progress()
            if told is not None and not told(run.done / max(1, study.Count), study.Label):
                run.cancel()
            time.sleep(PAUSE)
        keep_results(study, run)
    return kept_results(study)["counts"]


def results(study) -> list[dict[str, Any]]:
    """Return the table: `run`, `parameters`, `measures`, `status` and `why` of each variant."""
    owner_of(study)
    return kept_results(study).get("runs", [])


def apply_variant(study, run: int) -> None:
    """Set the document to the numbers of a variant: its pose, sizes and cells.

    Raises ValueError if the variant does not exist, or if the study has other parameters now.
    """
    row = next((row for row in results(study) if row["run"] == run), None)
    if row is None:
        raise ValueError(f"The study '{study.Label}' has no run {run}; compute it first.")
    told = [one for one in kept_parameters(study) if one.name in row["parameters"]]
    if not told:
        raise ValueError(f"Run {run} of '{study.Label}' has other parameters; compute it again.")
    for one in told:
        numbers.set_number(owner_in(study, one), one.number, row["parameters"][one.name])


# -- additional functions for the panel


@contextmanager
def begun(study) -> Iterator[StudyRun]:
    """Provide a running study; afterwards no process and no temporary file remains."""
    with place_of(study) as folder:
        run = StudyRun(write_study(study, folder))
        try:
            yield run
        finally:
            run.end()


@contextmanager
def place_of(study) -> Iterator[str]:
    """Provide the folder of a study, or a temporary one."""
    if study.Folder:
        yield study.Folder
        return
    with tempfile.TemporaryDirectory(prefix="sheetmorph-study-") as folder:
        yield folder


def keep_results(study, run: StudyRun) -> None:
    """Store the table of a finished run. Raises ValueError with the reason if there is none."""
    study.Results = json.dumps(run.results())


def value_of(variable: Variable) -> float:
    """Return the current value of a variable, mm or degrees.

    Raises ValueError for an unset size.
    """
    found = numbers.number_of(variable.owner, variable.number)
    if variable.number != numbers.SIZE or found > 0.0:
        return found
    shape = shape_of(variable.owner)
    if shape is None:
        raise ValueError(
            f"'{variable.owner.Label}' is not a hole, slot or cylinder, so it has no size."
        )
    return shape.size


# -- helpers


def owner_of(study):
    """Return the assembly of a study. Raises ValueError."""
    require_kind(study, model.STUDY, "study")
    assembly = assembly_of(study)
    require_assembly(assembly)
    return assembly


def owner_in(study, parameter: Parameter):
    """Return the object with the number of a parameter."""
    return study.Document.getObject(parameter.owner)


def check(assembly, settings: dict[str, Any]) -> None:
    """Raise ValueError for invalid settings."""
    unknown = settings.keys() - SETTINGS.keys() - {"parameters"}
    if unknown:
        raise ValueError(f"A study has no '{unknown.pop()}'; see set_study.")
    if settings.get("sampling", METHODS[0]) not in METHODS:
        raise ValueError(
            f"'{settings['sampling']}' is not a sampling method; choose {', '.join(METHODS)}."
        )
    if settings.get("count", 1) < 1:
        raise ValueError("The count must be 1 or more.")
    tools.criteria_in(settings.get("criteria", ""))
    known = {(one.owner.Name, one.number): one for one in variables(assembly)}
    for name, owner, told, low, high in settings.get("parameters", ()):
        if (owner.Name, told) not in known:
            raise ValueError(f"'{name}': '{owner.Label}' has no number '{told}'.")
        if not number(low, "low") <= number(high, "high"):
            raise ValueError(
                f"The range of '{name}' goes from {low} to {high}; swap the two numbers."
            )
        value_of(known[owner.Name, told])
    names = [entry[0].strip() for entry in settings.get("parameters", ())]
    if "" in names or len(set(names)) < len(names):
        raise ValueError("Every parameter needs a name of its own.")


def put(study, settings: dict[str, Any]) -> None:
    """Store checked settings in a study."""
    for key, name in SETTINGS.items():
        if key in settings and getattr(study, name) != settings[key]:
            setattr(study, name, settings[key])
    if "parameters" in settings:
        found = [
            Parameter(name.strip(), owner.Name, told, float(low), float(high))
            for name, owner, told, low, high in settings["parameters"]
        ]
        if found != kept_parameters(study):
            keep_parameters(study, found)


def driven_numbers(assembly) -> list[Variable]:
    """Return the numbers of regions that expressions drive."""
    return [
        one
        for region in model.regions(assembly)
        for one in numbers.numbers_of(region)
        if one.number in numbers.driven_by_expressions(region)
    ]


def study_entries(study, names: dict[str, str]) -> dict[str, Any]:
    """Return the study file without numbers that expressions drive."""
    criteria = tools.criteria_in(study.Criteria)
    parameters: dict[str, dict] = {}
    for one in kept_parameters(study):
        parameters[one.name] = {"range": [one.low, one.high]}
        if one.owner in names:
            path = numbers.path_of(names[one.owner], one.number)
            parameters[one.name]["path"] = path
    measured = [name for name in (*tools.MEASURED, *criteria) if name not in parameters]
    sampling = {"method": study.Sampling, "count": study.Count}
    if study.Sampling != "full grid":
        sampling["seed"] = study.Seed
    return {
        "sheetmorph_study": 1,
        "recipe": RECIPE,
        "parameters": parameters,
        "sampling": sampling,
        "measure": {name: {"worst": name} for name in dict.fromkeys(measured)},
        "criteria": criteria,
        "write": ["parts", "certificate"] if study.Folder else ["certificate"],
    }


def follow_expressions(study, entries: dict, folder: Path, driven: Sequence) -> None:
    """Add the numbers that expressions drive for every sample; the document evaluates them.

    Afterwards the document is as before.
    """
    package = kernel.studies()
    samples = package.samples_of(package.read_study(folder / STUDY))
    names = recipes.names_of(owner_of(study))
    columns = {one.label: one for one in driven}
    rows = [
        [*sample.values(), *map(value_of, columns.values())]
        for sample in each_applied(study, samples)
    ]
    with open(folder / SAMPLES, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([*entries["parameters"], *columns])
        writer.writerows([repr(value) for value in row] for row in rows)
    for k, (label, one) in enumerate(columns.items(), len(entries["parameters"])):
        values = [row[k] for row in rows]
        path = numbers.path_of(names[one.owner.Name], one.number)
        entries["parameters"][label] = {"path": path, "range": [min(values), max(values)]}
    entries["sampling"] = {"method": "csv", "file": SAMPLES}


def each_applied(study, samples: list[dict[str, float]]) -> Iterator[dict[str, float]]:
    """Yield every sample while the document has its values, then restore the document."""
    assembly = owner_of(study)
    places = {one.name: (owner_in(study, one), one.number) for one in kept_parameters(study)}
    before = {name: numbers.number_of(*place) for name, place in places.items()}
    concerned = [*numbers.sheets_of(assembly), *model.regions(assembly)]
    try:
        for sample in samples:
            apply(places, sample)
            study.Document.recompute(concerned)
            yield sample
    finally:
        apply(places, before)
        study.Document.recompute(concerned)


def apply(places: dict[str, tuple], values: dict[str, float]) -> None:
    """Set numbers of the document by name."""
    for name, place in places.items():
        numbers.set_number(*place, values[name])


def write(path: Path, data: dict) -> None:
    """Write a JSON file, complete or not at all."""
    with kernel.load().files.atomic.FileSet("recipe") as files:
        text = json.dumps(data, indent=1, ensure_ascii=False)
        files.temporary_for(path).write_text(text + "\n", "utf-8")
        files.commit()
