# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conversion of selectors to vertices."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import reduce
from typing import Any

import numpy as np

from ..base.errors import Fault, RecipeError
from ..base.part_mesh import PartMesh
from ..base.words import counted
from ..recipe.found import Resolved
from ..recipe.model import PartEntry
from ..recipe.places import driven_in, place_of, subjects_at
from .chosen import Chosen, SelectorError
from .grammar import JOINING, Path, form_faults, key_of, operands
from .grown import grown, shrunk
from .looked_up import LOOKED_UP
from .named import by_figure, by_group, by_ids, by_kind, holes_in
from .part_shape import PartShape
from .volumes import VOLUMES, within

_REGIONS = ("fixed", "handles", "features", "regions")
_CHANGED: dict[str, Callable[[PartShape, Chosen, Any], Chosen]] = {"grow": grown, "shrink": shrunk}
_LEAVES: dict[str, Callable[[PartShape, Any], Chosen]] = {
    **LOOKED_UP,
    "vertices": by_ids,
    "group": by_group,
    "drawn": by_figure,
    "found": by_kind,
    "all": lambda shape, _: shape.of_vertices(np.flatnonzero(shape.used)),
}


def selected(shape: PartShape, selector: Any) -> Chosen:
    """Return the region of a selector, or of a list of them, on a part.

    Raises SelectorError if it is invalid or selects nothing.
    """
    for fault in form_faults(selector):
        raise fault
    chosen = _evaluated(shape, selector)
    if not chosen.inside.any():
        raise _nothing(shape, selector)
    is_all = isinstance(selector, dict) and "all" in selector
    if chosen.inside[shape.used].all() and not is_all:
        remark = f'it is the whole part "{shape.name}"; write {{"all": true}} if you intend that'
        chosen = replace(chosen, remarks=[*chosen.remarks, remark])
    return chosen


def _evaluated(shape: PartShape, selector: Any) -> Chosen:
    inner = [_below(shape, path, operand) for path, operand in operands(selector)]
    if isinstance(selector, list):
        return reduce(Chosen.__or__, inner)
    key = key_of(selector)
    if key in JOINING:
        join = {"union": Chosen.__or__, "intersection": Chosen.__and__, "minus": Chosen.__sub__}
        found = reduce(join[key], inner)
    elif key in _CHANGED:
        found = _CHANGED[key](shape, inner[0], selector[key])
    elif key in VOLUMES:
        found = within(shape, key, selector[key])
    else:
        found = _LEAVES[key](shape, selector)
    _check_counts(shape, selector, found)
    return found


def _below(shape: PartShape, path: Path, selector: Any) -> Chosen:
    """Return the region of an operand; an empty one gives a remark."""
    try:
        found = _evaluated(shape, selector)
    except SelectorError as error:
        raise error.below(path) from None
    if found.inside.any():
        return found
    return replace(found, remarks=[*found.remarks, f"its part {_spoken(selector)} selects nothing"])


def _check_counts(shape: PartShape, selector: Mapping[str, Any], found: Chosen) -> None:
    is_found = "found" in selector
    for key in ("holes", "count"):
        if key in selector:
            count = found.matches[0]["count"] if is_found else holes_in(shape, found)
            if count != selector[key]:
                what = counted(count, "is", "are") + f' selected on "{shape.name}"'
                what = f"{selector[key]} {key if key == 'holes' else 'matches'} expected, {what}"
                raise SelectorError(what, "correct the selector or the number", (key,))


def _nothing(shape: PartShape, selector: Any) -> SelectorError:
    what = f'{_spoken(selector)} selects nothing on "{shape.name}"'
    return SelectorError(what, f"move or widen it; {shape.describe_box()}")


def _spoken(selector: Any) -> str:
    return "the list" if isinstance(selector, list) else f'"{key_of(selector)}"'


def has_selectors(recipe: Any) -> bool:
    """Return whether a recipe has selectors; its form is already checked."""
    return any(True for _ in _holders(recipe))


def _holders(recipe: Mapping[str, Any]) -> Iterator[tuple[list[str | int], str, dict[str, Any]]]:
    """Yield every entry with a selector: its path, part and content."""
    for path, entry in _regions(recipe):
        if isinstance(entry, dict) and "where" in entry:
            yield path, entry["part"], entry
    for k, name, entry in driven_in(recipe):
        if "where" in entry:
            yield ["parts", k, "driven"], name, entry


def _regions(recipe: Mapping[str, Any]) -> Iterator[tuple[list[str | int], Any]]:
    for section in (*_REGIONS, "contacts"):
        entries = recipe.get(section)
        for k, entry in enumerate(entries if isinstance(entries, list) else []):
            if section != "contacts":
                yield [section, k], entry
            elif isinstance(entry, dict):
                for side in "ab":
                    yield [section, k, side], entry.get(side)


def resolved(
    recipe: dict[str, Any], parts: list[PartEntry], meshes: Mapping[str, PartMesh]
) -> Resolved:
    """Return the recipe with vertex ids in place of its selectors.

    The form of the recipe is already checked, and parts has the entries of split files. Raises
    RecipeError.
    """
    placements = {part.name: part.placement for part in parts}
    shapes: dict[str, PartShape] = {}
    found = Resolved(_shallow(recipe))
    faults: list[Fault] = []
    for path, name, entry in list(_holders(found.recipe)):
        if name not in shapes:
            shapes[name] = PartShape(meshes[name], placements[name], name)
        try:
            chosen = selected(shapes[name], entry["where"])
            if "holes" in entry:
                _check_counts(shapes[name], {"holes": entry["holes"]}, chosen)
        except SelectorError as error:
            place = place_of(recipe, [*path, "where", *error.path])
            subjects = subjects_at(recipe, path)
            faults.append(Fault(place, error.what, error.todo).about(*subjects))
            continue
        found.told[place_of(recipe, path)] = _told(shapes[name], chosen)
        _put(entry, shapes[name].mesh, chosen)
    if faults:
        raise RecipeError(faults)
    return found


def _shallow(recipe: dict[str, Any]) -> dict[str, Any]:
    """Return a copy of the recipe whose region entries are copies too."""
    copy = dict(recipe)
    for section in (*_REGIONS, "contacts"):
        if isinstance(copy.get(section), list):
            copy[section] = [_with_own(entry, "ab") for entry in copy[section]]
    copy["parts"] = [_with_own(entry, ("driven",)) for entry in copy["parts"]]
    return copy


def _with_own(entry: Any, keys: Iterable[str]) -> Any:
    """Return a copy of an entry and of the dicts under some of its keys."""
    if not isinstance(entry, dict):
        return entry
    return {**entry, **{key: dict(entry[key]) for key in keys if isinstance(entry.get(key), dict)}}


def _put(entry: dict[str, Any], mesh: PartMesh, chosen: Chosen) -> None:
    """Replace the selector by vertex ids; ids of the prepared mesh if file ids are ambiguous."""
    del entry["where"]
    entry.pop("holes", None)
    vertices = chosen.vertices
    ids = list(dict.fromkeys(mesh.file_ids(vertices)))
    if np.array_equal(np.sort(mesh.find(ids)[0]), vertices):
        entry["vertices"] = ids
    else:
        entry |= {"vertices": vertices.tolist(), "ids": "prepared"}


def _told(shape: PartShape, chosen: Chosen) -> dict[str, Any]:
    distances = [match["distance"] for match in chosen.matches if "distance" in match]
    return {
        "area": shape.area_of(chosen),
        "distance": max(distances, default=None),
        "matches": chosen.matches,
        "remarks": chosen.remarks,
    }
