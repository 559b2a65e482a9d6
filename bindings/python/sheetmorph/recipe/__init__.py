# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recipe: the one description of a morph, checked as a whole before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..errors import Fault, RecipeError
from ..finding.common import missing_entries
from ..finding.findings import FindPart
from ..finding.reading import connections_of, find_parts
from ..part_mesh import PartMesh
from ..progress import Progress
from ..selecting.resolving import has_selectors, resolved
from .auto import asked_sections, filled, in_file_ids, search, without_auto
from .checks import Known, mesh_faults, meaning_faults, pose_meaning_faults
from .found import Found, Resolved
from .model import Model, model_of
from .parts import Parts, parts_of_meshes, read_parts
from .pose import Moved, pose_of
from .reading import named_in, read_json
from .structure import faults_against, pose_faults, schema, structural_faults, where_faults
from .unavailable import take_out
from .values import depth_faults

__all__ = [
    "check_pose",
    "check_with_meshes",
    "faults_against",
    "filled",
    "named_in",
    "prepare",
    "read_json",
    "schema",
    "validate",
    "where_faults",
    "with_ids",
]


def validate(recipe: dict[str, Any], base: str | Path = ".") -> None:
    """Check a recipe and the files it names, relative to `base`.

    Raises RecipeError; its ``faults`` list everything that was found.
    """
    prepare(recipe, base)


def prepare(recipe: Any, base: str | Path, progress: Progress | None = None) -> Parts:
    """The parts of a recipe, read from their files; ``resolved``: with ids in place of selectors;
    what it asks to find in them is in ``found``.

    progress(fraction, task) may return False to cancel (RuntimeError). Raises RecipeError,
    KernelError if something is to be found without a kernel.
    """
    model, faults = _model(recipe)
    parts = read_parts(model.parts, base, progress)
    parts.joint_files = model.joint_files
    model = model.with_parts(parts.entries)
    faults += meaning_faults(model, Known.of(model, recipe, parts.unread))
    faults += [*parts.faults, *mesh_faults(model, parts.meshes)]
    if faults:
        raise RecipeError(faults)
    parts.resolved = _resolved(recipe, model, parts.meshes)
    if asked_sections(recipe):
        told = in_file_ids(parts.resolved.recipe, parts.meshes)
        parts.found = search(told, find_parts(parts), connections_of(parts), progress)
    return parts


def with_ids(parts: Parts) -> dict[str, Any]:
    """The recipe of the parts with vertex ids in place of selectors, and what was found."""
    ids = parts.resolved.recipe
    return ids if parts.found is None else filled(ids, parts.found)


def _resolved(recipe: Any, model: Model, meshes: Mapping[str, PartMesh]) -> Resolved:
    return resolved(recipe, model.parts, meshes) if has_selectors(recipe) else Resolved(recipe)


def check_with_meshes(
    recipe: Any, meshes: Mapping[str, PartMesh], found: Found | None = None
) -> Model:
    """The entries of a recipe whose parts are given as meshes, by name.

    found: what was found for it before; else what it asks for is found now. Raises RecipeError.
    """
    model, faults = _model(recipe)
    model = model.with_parts(parts_of_meshes(model.parts, meshes))
    faults += meaning_faults(model, Known.of(model, recipe))
    for part in model.parts:
        if part.name not in meshes:
            what = f'no mesh is given for the part "{part.name}"'
            faults.append(Fault(part.where, what, "add it to the meshes").about(part.subject))
    if not model.parts and not faults:
        faults.append(Fault("parts", "no mesh is given for any part", "add it to the meshes"))
    faults += mesh_faults(model, meshes)
    if faults:
        raise RecipeError(faults)
    if has_selectors(recipe):
        ids = resolved(recipe, model.parts, meshes)
        return replace(check_with_meshes(ids.recipe, meshes, found), told=ids.told)
    asked = asked_sections(recipe)
    if not asked:
        return _with_common_nodes(recipe, model, meshes)
    if found is None:
        shapes = [FindPart(part.name, meshes[part.name]) for part in model.parts]
        found = search(in_file_ids(recipe, meshes), shapes)
    whole = check_with_meshes(filled(recipe, found), meshes)
    return replace(whole, found=found.for_report(asked))


def _with_common_nodes(
    recipe: Mapping[str, Any], model: Model, meshes: Mapping[str, PartMesh]
) -> Model:
    """With contacts of the nodes that parts of one deck share and that no contact holds."""
    more = missing_entries(meshes, recipe.get("contacts") or [])
    if not more:
        return model
    contacts = model_of({"contacts": more}).contacts
    return replace(model, contacts=[*model.contacts, *contacts])


def check_pose(model: Model, pose: Any) -> dict[str, Moved]:
    """A pose with all its entries typed: the one door on the way to the kernel.

    pose: what stands under "pose" in a recipe, entries that are typed already as they are. Raises
    RecipeError.
    """
    faults = pose_faults(pose)
    if faults:
        raise RecipeError(faults)
    moved = pose_of(pose)
    faults = pose_meaning_faults(model, moved)
    if faults:
        raise RecipeError(faults)
    return moved


def _model(recipe: Any) -> tuple[Model, list[Fault]]:
    _require_shallow(recipe)
    available, faults = take_out(recipe)
    structural, sound = structural_faults(available)
    return model_of(without_auto(sound)), [*faults, *structural]


def _require_shallow(data: Any) -> None:
    faults = depth_faults(data)
    if faults:
        raise RecipeError(faults)
