# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks of a recipe: its form, its meaning, and its parts; selectors become vertex ids."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..base.errors import Fault, RecipeError
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..finding.common import missing_entries
from ..finding.findings import FindPart
from ..finding.reading import connections_of, find_parts
from ..recipe.found import Found, Resolved
from ..recipe.model import Model, model_of
from ..recipe.parts import Parts, parts_of_meshes, read_parts
from ..recipe.plain import plain
from ..recipe.pose import Moved, pose_of
from ..recipe.structure import has_misspelt_section, pose_faults, structural_faults
from ..recipe.unavailable import take_out
from ..recipe.values import depth_faults
from ..selecting.resolving import has_selectors, resolved
from .auto import asked_sections, filled, in_file_ids, search, without_auto
from .faults import Known, mesh_faults, meaning_faults, pose_meaning_faults


def validate(recipe: dict[str, Any], base: str | Path = ".") -> None:
    """Check a recipe and the files that it names.

    Parameters
    ----------
    recipe : dict
        The recipe.
    base : str or path
        Folder to which its paths are relative.

    Raises
    ------
    RecipeError
        If the recipe has faults; ``faults`` lists all of them.
    """
    prepare(recipe, base)


def prepare(recipe: Any, base: str | Path, progress: Progress | None = None) -> Parts:
    """Read the parts of a recipe and check it; ``resolved`` has ids in place of selectors.

    ``found`` has the search result for "auto" entries. progress(fraction, task) may return False to
    cancel (RuntimeError). Raises RecipeError, and KernelError if a search needs the missing kernel.
    """
    recipe = _plain(recipe, {})
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
        with_file_ids = in_file_ids(parts.resolved.recipe, parts.meshes)
        parts.found = search(with_file_ids, find_parts(parts), connections_of(parts), progress)
    return parts


def with_ids(parts: Parts) -> dict[str, Any]:
    """Return the recipe with vertex ids for selectors, and with found entries for "auto"."""
    ids = parts.resolved.recipe
    return ids if parts.found is None else filled(ids, parts.found)


def _resolved(recipe: Any, model: Model, meshes: Mapping[str, PartMesh]) -> Resolved:
    return resolved(recipe, model.parts, meshes) if has_selectors(recipe) else Resolved(recipe)


def check_with_meshes(
    recipe: Any, meshes: Mapping[str, PartMesh], found: Found | None = None
) -> Model:
    """Return the model of a recipe whose parts are given as meshes, by name.

    Arrays, tuples and masks may stand for lists. found is an earlier search result; without it the
    function searches for "auto" entries. Raises RecipeError.
    """
    return _checked(_plain(recipe, meshes), meshes, found)


def _checked(recipe: Any, meshes: Mapping[str, PartMesh], found: Found | None = None) -> Model:
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
        return replace(_checked(ids.recipe, meshes, found), told=ids.told)
    asked = asked_sections(recipe)
    if not asked:
        return _with_common_nodes(recipe, model, meshes)
    if found is None:
        shapes = [FindPart(part.name, meshes[part.name]) for part in model.parts]
        found = search(in_file_ids(recipe, meshes), shapes)
    whole = _checked(filled(recipe, found), meshes)
    return replace(whole, found=found.for_report(asked))


def _with_common_nodes(
    recipe: Mapping[str, Any], model: Model, meshes: Mapping[str, PartMesh]
) -> Model:
    """Add contacts at nodes that parts of one deck share, unless a contact already joins them."""
    more = missing_entries(meshes, recipe.get("contacts") or [])
    if not more:
        return model
    contacts = model_of({"contacts": more}).contacts
    return replace(model, contacts=[*model.contacts, *contacts])


def check_pose(model: Model, pose: Any) -> dict[str, Moved]:
    """Return a pose with typed entries; every pose for the kernel is checked here.

    pose has the form of the recipe key "pose"; entries that are already typed stay as they are.
    Raises RecipeError.
    """
    faults = pose_faults(pose)
    if faults:
        raise RecipeError(faults)
    moved = pose_of(pose)
    faults = pose_meaning_faults(model, moved)
    if faults:
        raise RecipeError(faults)
    return moved


def check_entries(recipe: Mapping[str, Any], section: str, meshes: Mapping[str, PartMesh]) -> None:
    """Check the entries in a section of an unfinished recipe; selectors are not resolved.

    Raises RecipeError.
    """
    keys = ("sheetmorph", "parts", "primary", section)
    model, faults = _model({key: recipe[key] for key in keys if key in recipe})
    model = model.with_parts(parts_of_meshes(model.parts, meshes))
    faults += [*meaning_faults(model, Known.of(model, recipe)), *mesh_faults(model, meshes)]
    own = [fault for fault in faults if fault.where.startswith(section)]
    if own:
        raise RecipeError(own)


def _model(recipe: Any) -> tuple[Model, list[Fault]]:
    if isinstance(recipe, dict) and "sheetmorph_study" in recipe:
        raise RecipeError([Fault("recipe", "this is a study", "use the command `study`")])
    available, faults = take_out(recipe)
    structural, sound = structural_faults(available)
    if has_misspelt_section(available):  # what depends on the section would only repeat the fault
        raise RecipeError([*faults, *structural])
    return model_of(without_auto(sound)), [*faults, *structural]


def _plain(recipe: Any, meshes: Mapping[str, PartMesh]) -> Any:
    faults = depth_faults(recipe)
    if faults:
        raise RecipeError(faults)
    return plain(recipe, meshes)
