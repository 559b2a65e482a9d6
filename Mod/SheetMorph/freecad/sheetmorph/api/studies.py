# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies: many variants of an assembly, computed in processes of their own, as a table."""

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
PAUSE = 0.05  # seconds between two looks at a process
SETTINGS = {"sampling": "Sampling", "count": "Count", "seed": "Seed", "criteria": "Criteria"}
SETTINGS["folder"] = "Folder"


def add_study(assembly, label: str = "Study", **settings: Any):
    """Add a study to an assembly and return it; `settings` as `set_study` takes them."""
    require_assembly(assembly)
    check(assembly, settings)
    study = assembly.Document.addObject("App::FeaturePython", "Study")
    StudyProxy(study)
    study.Label = label
    assembly.addObject(study)
    put(study, settings)
    return study


def set_study(study, **settings: Any) -> None:
    """Say what a study changes, and how; what is left out stays as it is.

    `parameters`: (name, object, property or cell, low, high) each, mm or degrees, of those that
    `variables` returns; `sampling`: "latin hypercube", "sobol", "halton" or "full grid"; `count`
    of variants; `seed`; `criteria`: "stretch <= 0.2, angle >= 12"; `folder` for the files, "" for
    the table alone. Raises ValueError.
    """
    check(owner_of(study), settings)
    put(study, settings)


def variables(assembly) -> list[Variable]:
    """Return the numbers that a study may change: `owner`, `number`, `label`, `unit`, each.

    They are motions of handles, sizes and prescribed rotations of form features, and cells of the
    spreadsheets that drive any of those.
    """
    require_assembly(assembly)
    return numbers.variables_of(assembly)


def write_study(study, folder: str | os.PathLike) -> Path:
    """Write recipe, parts at rest and study file into a folder; return the study file's path.

    `python3 -m sheetmorph study` computes it, here or on another machine. Raises MorphError,
    ValueError, OSError.
    """
    assembly, place = owner_of(study), Path(folder)
    parameters = kept_parameters(study)
    if not parameters:
        raise ValueError(f"The study '{study.Label}' changes nothing yet; add a parameter.")
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
    """Compute a study in processes of their own, keep its table; return how many came out how.

    Raises MorphError, ValueError with what is wrong with the study, OSError.
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
    """Give the document the numbers of a variant: its pose, its sizes, its cells.

    Raises ValueError: there is no such variant, or nothing of it is in the study any more.
    """
    row = next((row for row in results(study) if row["run"] == run), None)
    if row is None:
        raise ValueError(f"The study '{study.Label}' has no run {run}; compute it first.")
    told = [one for one in kept_parameters(study) if one.name in row["parameters"]]
    if not told:
        raise ValueError(f"Run {run} of '{study.Label}' is of other parameters; compute it again.")
    for one in told:
        numbers.set_number(owner_in(study, one), one.number, row["parameters"][one.name])


# -- what the panel uses besides


@contextmanager
def begun(study) -> Iterator[StudyRun]:
    """Context with a study that is being computed; after it no process and no file is left."""
    with place_of(study) as folder:
        run = StudyRun(write_study(study, folder))
        try:
            yield run
        finally:
            run.end()


@contextmanager
def place_of(study) -> Iterator[str]:
    """Context with the folder of a study; without one it is there for a while only."""
    if study.Folder:
        yield study.Folder
        return
    with tempfile.TemporaryDirectory(prefix="sheetmorph-study-") as folder:
        yield folder


def keep_results(study, run: StudyRun) -> None:
    """Keep the table of a run that is over; raises ValueError with why there is none."""
    study.Results = json.dumps(run.results())


def value_of(variable: Variable) -> float:
    """Return a number as it is now, mm or degrees; raises ValueError for a size that is none."""
    found = numbers.number_of(variable.owner, variable.number)
    if variable.number != numbers.SIZE or found > 0.0:
        return found
    shape = shape_of(variable.owner)
    if shape is None:
        raise ValueError(f"'{variable.owner.Label}' is no hole, slot or cylinder; it has no size.")
    return shape.size


# -- parts of the above


def owner_of(study):
    """Return the assembly of a study; raises ValueError."""
    require_kind(study, model.STUDY, "study")
    assembly = assembly_of(study)
    require_assembly(assembly)
    return assembly


def owner_in(study, parameter: Parameter):
    """Return whose number a parameter is."""
    return study.Document.getObject(parameter.owner)


def check(assembly, settings: dict[str, Any]) -> None:
    """Raise ValueError for settings that are none."""
    unknown = settings.keys() - SETTINGS.keys() - {"parameters"}
    if unknown:
        raise ValueError(f"A study has no '{unknown.pop()}'; see set_study.")
    if settings.get("sampling", METHODS[0]) not in METHODS:
        raise ValueError(f"'{settings['sampling']}' is no sampling; choose {', '.join(METHODS)}.")
    if settings.get("count", 1) < 1:
        raise ValueError("The count must be 1 or more.")
    tools.criteria_in(settings.get("criteria", ""))
    known = {(one.owner.Name, one.number): one for one in variables(assembly)}
    for name, owner, told, low, high in settings.get("parameters", ()):
        if (owner.Name, told) not in known:
            raise ValueError(f"'{name}': '{owner.Label}' has no number '{told}' to change.")
        if not number(low, "low") <= number(high, "high"):
            raise ValueError(f"'{name}' goes from {low} to {high}; turn them round.")
        value_of(known[owner.Name, told])
    names = [entry[0].strip() for entry in settings.get("parameters", ())]
    if "" in names or len(set(names)) < len(names):
        raise ValueError("Every parameter needs a name of its own.")


def put(study, settings: dict[str, Any]) -> None:
    """Give a study settings that were checked."""
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
    """Return the study file without what expressions drive."""
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
    """Let a study say what expressions make of every sample: the document works them out.

    The document is as it was afterwards.
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
    """Yield every sample while the document has it; then the document has what it had."""
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
    """Give the document numbers by name."""
    for name, place in places.items():
        numbers.set_number(*place, values[name])


def write(path: Path, data: dict) -> None:
    """Write a JSON file, whole or not at all."""
    with kernel.load().files.atomic.FileSet("recipe") as files:
        text = json.dumps(data, indent=1, ensure_ascii=False)
        files.temporary_for(path).write_text(text + "\n", "utf-8")
        files.commit()
