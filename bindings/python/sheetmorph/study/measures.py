# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of every variant, taken at exact positions, mm."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Fault, RecipeError
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..measuring.distance import Gap
from ..recipe.model import Model
from .expressions import Expression
from .reading import Study
from .spots import spot_of

# Steel, kg/mm3.
_DENSITY = 7.85e-6
_KINDS = ("position", "distance", "diameter", "area", "mass", "gap", "worst", "expression")
_BESIDES = {
    "axis": ("position",),
    "thickness": ("mass",),
    "density": ("mass",),
    "part": ("worst",),
}

Numbers = dict[str, float | None]


class Scene:
    """One variant.

    positions (n, 3) are by part, mm. values has parameters and the measures so far. figure returns
    a figure of the certificate by name and part ("" for all).
    """

    def __init__(
        self,
        positions: Mapping[str, Floats],
        values: Mapping[str, float],
        figure: Callable[[str, str], float | None],
    ):
        self.positions = positions
        self.values: Numbers = dict(values)
        self.figure = figure


Measured = Callable[[Scene], Numbers]


class Measures:
    """The measures of a study, prepared for many variants. Raises RecipeError."""

    def __init__(self, study: Study, model: Model, meshes: Mapping[str, PartMesh]):
        self._makers = _Makers(study, model, meshes)
        self._ways = [self._makers.way(name, entry) for name, entry in study.measure.items()]
        self.columns = self._makers.columns

    def taken(self, scene: Scene) -> Numbers:
        """Return the measures of a variant by column; None if there is nothing to measure."""
        found: Numbers = {}
        for way in self._ways:
            numbers = {name: _finite(value) for name, value in way(scene).items()}
            found |= numbers
            scene.values |= numbers
        return found


def _finite(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else float(value)


class _Makers:
    """Builder of a measuring function for each entry of `measure`; columns has the names so far."""

    def __init__(self, study: Study, model: Model, meshes: Mapping[str, PartMesh]):
        self._study, self._model, self._meshes = study, model, meshes
        self.columns: list[str] = []

    def way(self, name: str, entry: dict[str, Any]) -> Measured:
        """Return the function that takes a measure. Raises RecipeError."""
        where = f"{self._study.path}, measure.{name}"
        kinds = [key for key in _KINDS if key in entry]
        if len(kinds) != 1:
            what = f"it measures {' and '.join(kinds)}" if kinds else "it measures nothing"
            raise _error(where, what, f"give one of {', '.join(_KINDS)}")
        for key, places in _BESIDES.items():
            if key in entry and kinds[0] not in places:
                raise _error(where, f'"{key}" is not for {kinds[0]}', "leave it out")
        way = getattr(self, f"_{kinds[0]}")(name, entry, where)
        is_place = kinds[0] == "position" and "axis" not in entry
        self.columns += [f"{name}.{axis}" for axis in "xyz"] if is_place else [name]
        found: Measured = way
        return found

    def _spot(self, told: Any, where: str) -> Any:
        return spot_of(told, self._model, self._meshes, where)

    def _position(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        spot = self._spot(entry["position"], where)
        if "axis" in entry:
            axis = "xyz".index(entry["axis"])
            return lambda scene: {name: spot.at(scene.positions)[axis]}
        names = [f"{name}.{axis}" for axis in "xyz"]
        return lambda scene: dict(zip(names, spot.at(scene.positions).tolist()))

    def _distance(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        a, b = (self._spot(told, where) for told in entry["distance"])
        return lambda scene: {
            name: float(np.linalg.norm(a.at(scene.positions) - b.at(scene.positions)))
        }

    def _diameter(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        features = {feature.name: feature for feature in self._model.of_kind("feature")}
        if entry["diameter"] not in features:
            known = ", ".join(features) or "none"
            raise _error(
                where, f'there is no form feature "{entry["diameter"]}"', f"known: {known}"
            )
        region = features[entry["diameter"]]
        mesh = self._meshes[region.part]
        rim = _rim(mesh, mesh.find(region.vertices or [])[0])
        core = load_kernel()
        return lambda scene: {name: 2.0 * core.fit_circle(scene.positions[region.part][rim]).radius}

    def _area(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        parts = self._known_parts(entry["area"], where)
        return lambda scene: {name: sum(self._area_of(part, scene) for part in parts)}

    def _mass(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        parts = self._known_parts(entry["mass"], where)
        thickness: float | str | None = entry.get("thickness")
        if thickness is None:
            raise _error(where, "the thickness is missing", 'give "thickness", mm, or a parameter')
        if isinstance(thickness, str) and thickness not in self._study.names:
            known = ", ".join(self._study.names)
            raise _error(where, f'there is no parameter "{thickness}"', f"parameters are {known}")
        density = entry.get("density", _DENSITY)

        def taken(scene: Scene) -> Numbers:
            thick = scene.values[thickness] if isinstance(thickness, str) else thickness
            area = sum(self._area_of(part, scene) for part in parts)
            return {name: None if thick is None else area * thick * density}

        return taken

    def _gap(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        a, b = self._known_parts(entry["gap"], where)
        if a == b:
            raise _error(where, f'it names "{a}" twice', "name two parts")
        gap = Gap(self._meshes[a], self._meshes[b])
        return lambda scene: {name: gap.smallest(scene.positions[a], scene.positions[b])}

    def _worst(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        part = entry.get("part", "")
        if part:
            self._known_parts([part], f"{where}.part")
        return partial(_figure, name, entry["worst"], part)

    def _expression(self, name: str, entry: dict[str, Any], where: str) -> Measured:
        known = [*self._study.names, *self.columns]
        formula = Expression(entry["expression"], known, where)
        return partial(_formula, name, formula)

    def _known_parts(self, names: list[str], where: str) -> list[str]:
        for name in names:
            if name not in self._meshes:
                known = ", ".join(self._meshes)
                raise _error(where, f'there is no part "{name}"', f"parts are {known}")
        return names

    def _area_of(self, part: str, scene: Scene) -> float:
        corners = scene.positions[part][self._meshes[part].triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return 0.5 * float(np.linalg.norm(normals, axis=1).sum())


def _figure(name: str, figure: str, part: str, scene: Scene) -> Numbers:
    return {name: scene.figure(figure, part)}


def _formula(name: str, formula: Expression, scene: Scene) -> Numbers:
    known = {of: value for of, value in scene.values.items() if value is not None}
    return {name: float(formula.value(known)) if formula.names <= known.keys() else None}


def _rim(mesh: PartMesh, vertices: Ints) -> Ints:
    """Return the rim of a hole among the vertices of a form feature, or all vertices."""
    core = load_kernel()
    inside = set(vertices.tolist())
    loops = core.boundary_loops(core.TriangleMesh(mesh.points, mesh.triangles))
    rims = [loop for loop in loops if inside.issuperset(loop.tolist())]
    return min(rims, key=len) if rims else vertices


def _error(where: str, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(where, what, todo)])
