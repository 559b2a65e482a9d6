# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of the arguments of the scripting interface."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import FreeCAD
import numpy as np

from freecad.sheetmorph.objects import assembly_of, deformation_of, kind, model
from freecad.sheetmorph.objects.region import FORM_FEATURE


def refuse_link(source) -> None:
    """Raise ValueError for a link (App::Link), because it shows another object."""
    if str(getattr(source, "TypeId", "")).startswith("App::Link"):
        linked = source.getLinkedObject(True)
        if linked in (None, source):
            raise ValueError(f"The link '{source.Label}' has no target; choose a mesh or a shape.")
        raise ValueError(
            f"A morph cannot deform the link '{source.Label}'; choose the object "
            f"'{linked.Label}' that it links to, or a copy of it."
        )


def require_kind(obj, wanted: str, word: str) -> None:
    """Raise ValueError unless `obj` is a SheetMorph object of the wanted kind."""
    if kind(obj) != wanted:
        label = getattr(obj, "Label", repr(obj))
        raise ValueError(f"'{label}' is not a SheetMorph {word}; pass one.")


def require_assembly(obj) -> None:
    """Raise ValueError unless `obj` is a complete assembly."""
    require_kind(obj, model.ASSEMBLY, "assembly")
    if deformation_of(obj) is None:
        raise ValueError(
            f"The morph '{obj.Label}' has lost its hidden object 'Deformation'; "
            "undo its deletion or create the morph again."
        )


def require_part_of(assembly, part) -> None:
    """Raise ValueError unless `part` is a part of `assembly`."""
    require_assembly(assembly)
    require_kind(part, model.PART, "part")
    if assembly_of(part) != assembly:
        raise ValueError(
            f"Part '{part.Label}' is not in the morph '{assembly.Label}'; pass one of its parts."
        )


def require_role(region, role: str) -> None:
    """Raise ValueError unless `region` is a region of that role."""
    require_kind(region, model.REGION, "region")
    if region.Role != role:
        raise ValueError(
            f"Region '{region.Label}' has the role '{region.Role}', not '{role}'; "
            "pass a region with that role."
        )


def require_features_of(assembly, features: list) -> None:
    """Raise ValueError unless `features` are two or more form features of `assembly`."""
    require_assembly(assembly)
    for feature in features:
        require_role(feature, FORM_FEATURE)
        if assembly_of(feature) != assembly:
            raise ValueError(f"'{feature.Label}' is not in '{assembly.Label}'; pass its features.")
    if len(set(features)) < 2 or len(set(features)) < len(features):
        raise ValueError("Pass at least two different form features.")


def vertex_count(part) -> int:
    """Return the number of vertices of a part's mesh; raises ValueError if its source is lost."""
    if part.Source is None:
        raise ValueError(
            f"Part '{part.Label}' has lost its source mesh: undo its deletion or delete the part."
        )
    return part.Source.Mesh.CountPoints


def vector(values: Sequence[float], word: str) -> FreeCAD.Vector:
    """Return three finite numbers as a vector, or raise ValueError."""
    numbers = np.asarray(list(values), dtype=float)
    if numbers.shape != (3,) or not np.isfinite(numbers).all():
        raise ValueError(f"The {word} must be three finite numbers, not {list(values)}.")
    return FreeCAD.Vector(*numbers.tolist())


def direction(values: Sequence[float], word: str) -> FreeCAD.Vector:
    """Return a vector that is not zero, or raise ValueError."""
    found = vector(values, word)
    if found.Length == 0.0:
        raise ValueError(f"The {word} is zero; give it a direction, such as (0, 0, 1).")
    return found


def number(value: float, word: str) -> float:
    """Return a finite number, or raise ValueError."""
    found = float(value)
    if not np.isfinite(found):
        raise ValueError(f"The {word} must be a finite number, not {value}.")
    return found


def indices(values: Iterable[int], count: int, word: str) -> np.ndarray:
    """Return sorted unique indices (k,) int64; raise ValueError if none or outside 0 .. count-1.

    `word` names the items, `vertex` or `facet`.
    """
    given = np.asarray(list(values))
    if given.size == 0:
        raise ValueError(f"No {word} was given; pick at least one.")
    if not np.issubdtype(given.dtype, np.integer) or given.ndim != 1:
        raise ValueError(f"A {word} is given by its index in the mesh; pass whole numbers.")
    outside = given[(given < 0) | (given >= count)]
    if outside.size:
        raise ValueError(f"The mesh has no {word} {outside[0]}, only 0 to {count - 1}; pick again.")
    return np.unique(given.astype(np.int64))
