# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan of a study: its samples, and a hash of everything that each depends on."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from ..base.arrays import Floats
from ..base.errors import Fault, RecipeError
from ..base.progress import Progress
from ..base.version import __version__
from ..checking import check_pose, check_with_meshes, prepare
from ..recipe.model import Model
from ..recipe.parts import Parts
from ..recipe.reading import named_in, read_json
from ..recipe.structure import structural_faults
from .certifying import STANDARD
from .figures import FIGURES
from .measures import Measures
from .reading import Study, read_study
from .sampling import Values, out_of_range, samples_of
from .spots import spot_of
from .variants import Changes, Variant

_FORMAT = 2
# Number of samples to check; at least one must be valid.
_TRIED = 8


class Plan:
    """A study with its recipe and parts. Raises RecipeError, FileError.

    samples has the parameter values of every variant, in the order of the runs.
    """

    def __init__(self, study: str | Path | dict[str, Any], progress: Progress | None = None):
        self._is_in_memory = isinstance(study, dict)
        self.study: Study = read_study(study)
        self.recipe: Any = read_json(self.study.recipe)
        if isinstance(self.recipe, dict) and self.recipe.get("repair"):
            what = "a study cannot repair elements"
            raise RecipeError([Fault("repair", what, "leave it out, then repair the best variant")])
        self.folder = self.study.recipe.parent
        with named_in(self.study.recipe):
            self.parts: Parts = prepare(self.recipe, self.folder, progress)
            self.model: Model = check_with_meshes(self.recipe, self.parts.meshes, self.parts.found)
        with named_in(self.study.path):
            self.changes = Changes(self.recipe, self.study.parameters, self._place_of)
        self.measures = Measures(self.study, self.model, self.parts.meshes)
        _require_known_criteria(self.study, self.measures)
        self.samples: list[Values] = samples_of(self.study)
        self._common = _digest(self._depended_on())
        self._check_first()

    @property
    def files_read(self) -> list[Path]:
        """The study, its recipe and the files of its parts."""
        parts = (path for source in self.parts.sources for path in source.file.files_read)
        own = [] if self._is_in_memory else [self.study.path]
        return [*own, self.study.recipe, *parts]

    @property
    def columns(self) -> list[str]:
        """Names of the measures, by column."""
        return self.measures.columns

    def variant(self, values: Values) -> Variant:
        """Return the recipe for parameter values. Raises RecipeError."""
        return self.changes.variant(values)

    def refusal(self, values: Values) -> str:
        """Return why a sample is not computed, or an empty text."""
        return out_of_range(self.study, values)

    def hash_of(self, values: Values, refusal: str = "") -> str:
        """Return a hash of everything that the files of a variant depend on, in hex.

        refusal is the reason why it is not computed, if any.
        """
        told = [refusal] if refusal else []
        return _digest([self._common, [values[name] for name in self.study.names], *told])

    @property
    def range_hash(self) -> str:
        """Hash of everything that the admissible range depends on, in hex."""
        study = self.study
        limits = [[entry.low, entry.high, entry.values] for entry in study.parameters]
        constraints = [entry.text for entry in study.constraints]
        asked = [study.measure, study.criteria, asdict(study.certify)]
        return _digest([*self._inputs(), limits, constraints, asked])

    def _place_of(self, told: Any, where: str) -> Floats:
        rest = {name: mesh.points for name, mesh in self.parts.meshes.items()}
        return spot_of(told, self.model, self.parts.meshes, where).at(rest)

    def _check_first(self) -> None:
        """Report faults of all variants early, such as a parameter for a missing handle."""
        feasible = [values for values in self.samples if not self.refusal(values)]
        wrong: list[RecipeError] = []
        tried = feasible[:: max(1, len(feasible) // _TRIED)]
        for values in tried:
            try:
                with named_in(self.study.path):
                    self._check(values)
                return
            except RecipeError as error:
                wrong.append(error)
        if wrong:
            raise wrong[0]

    def _check(self, values: Values) -> None:
        variant = self.variant(values)
        faults = structural_faults(variant.recipe)[0] if variant.key != "{}" else []
        if faults:
            raise RecipeError(faults)
        check_pose(self.model, variant.pose)

    def _depended_on(self) -> Any:
        study = self.study
        limits = [[entry.low, entry.high, entry.values] for entry in study.parameters]
        constraints = [entry.text for entry in study.constraints]
        asked = [study.measure, study.criteria, study.write, asdict(study.certify)]
        # If range and constraints refuse no sample, the results do not depend on them.
        refuses = any(map(self.refusal, self.samples))
        told = [limits, constraints] if refuses else []
        return [*self._inputs(), asked, told]

    def _inputs(self) -> list[Any]:
        """Return the recipe with its files, and the effect of the parameters on it."""
        files = {
            source.file.origin.name: [*map(_digest_of_file, source.file.files_read)]
            for source in self.parts.sources
        }
        meanings = [entry.meaning() for entry in self.study.parameters]
        return [_FORMAT, __version__, self.recipe, files, meanings]


def _require_known_criteria(study: Study, measures: Measures) -> None:
    known = [*measures.columns, *study.names, *FIGURES]
    faults = [
        Fault(
            f"{study.path}, criteria.{name}",
            f'there is no measure "{name}"',
            f"known: {', '.join(known)}",
        )
        for name in {**STANDARD, **study.criteria}
        if name not in known
    ]
    if faults:
        raise RecipeError(faults)


def _digest(data: Any) -> str:
    text = json.dumps(data, sort_keys=True, ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _digest_of_file(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
