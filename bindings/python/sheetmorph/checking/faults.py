# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks after the schema: names, numbers, and ids that do not exist."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..base.errors import Fault, Subject, list_ids
from ..base.part_mesh import PartMesh
from ..base.words import counted
from ..recipe.feature_entries import RelationEntry
from ..recipe.model import ContactEntry, Model, PartEntry, RegionEntry
from ..recipe.places import names_in, place_of
from ..recipe.pose import Moved, Rotation
from ..selecting.grammar import form_faults
from .relations import relation_faults

_POSED = ("handles", "features", "points")
_HOLDING = ("fixed", "handles", "points")
_NOT_POSED = ("fixed", "follower")


@dataclass(frozen=True)
class Known:
    """Names that a recipe declares, including those of faulty entries.

    posed has the handles, features and points. unread has name prefixes of parts in unreadable
    files. is_held states whether any vertex is prescribed.
    """

    parts: frozenset[str]
    posed: frozenset[str]
    unread: tuple[str, ...]
    is_held: bool

    @classmethod
    def of(cls, model: Model, written: Any, unread: Sequence[str] = ()) -> Known:
        """Return the names of a model and of the recipe as the user wrote it."""
        recipe = written if isinstance(written, dict) else {}
        parts = names_in(recipe, "parts") | {part.name for part in model.parts}
        posed = set().union(*(names_in(recipe, section) for section in _POSED))
        is_held = any(recipe.get(section) for section in _HOLDING)
        return cls(frozenset(parts), frozenset(posed), tuple(unread), is_held)

    def has_part(self, name: str) -> bool:
        """Return whether a part of this name exists, or can exist in an unreadable file."""
        return name in self.parts or name.startswith(self.unread)


def meaning_faults(model: Model, known: Known) -> list[Fault]:
    """Return the faults that are visible without meshes."""
    faults = [*_repeated_names(model), *_primary(model, known)]
    for region in model.all_regions:
        if not region.part:  # the key `driven` of a part that is split
            what = "the entry is for several parts"
            todo = 'list them under "regions", as followers'
            faults.append(Fault(region.where, what, todo).about(region.subject))
        elif not known.has_part(region.part):
            what = f'there is no part "{region.part}"'
            todo = f"use one of {_list(known.parts)}"
            faults.append(Fault(f"{region.where}.part", what, todo).about(region.subject))
        faults += [fault.about(region.subject) for fault in _numbers(region)]
    for contact in model.contacts:
        if contact.a.part == contact.b.part:
            what = f'both sides are on the part "{contact.a.part}"'
            todo = "pick sides on two different parts"
            faults.append(Fault(contact.where, what, todo).about(contact.subject))
    faults += relation_faults(model, known.posed)
    if not known.is_held:
        what = "there is no fixed region and no handle"
        faults.append(Fault("recipe", what, "add a fixed region and a handle"))
    poses = {"pose": model.pose, **{f"poses.{name}": p for name, p in model.poses.items()}}
    for where, pose in poses.items():
        faults += pose_meaning_faults(model, pose, (where, known.posed))
    return faults


def pose_meaning_faults(
    model: Model, pose: Mapping[str, Moved], place: tuple[str, Set[str]] = ("pose", frozenset())
) -> list[Fault]:
    """Return the faults of a pose.

    place has its location in the recipe, and the names of entries that exist but are faulty.
    """
    regions = {region.name: region for region in model.regions if region.kind not in _NOT_POSED}
    faults: list[Fault] = []
    for name, moved in pose.items():
        where = f"{place[0]}.{name}"
        if name in regions:
            found = _moved(regions[name], moved, where)
            faults += [fault.about(regions[name].subject) for fault in found]
        elif name not in place[1]:
            todo = f"names are {_list(set(regions))}" if regions else "add a handle"
            what = f'there is no handle, feature or point "{name}"'
            subject = Subject("region", name)
            faults.append(Fault(where, what, todo).about(subject))
    return faults


def mesh_faults(model: Model, meshes: Mapping[str, PartMesh]) -> list[Fault]:
    """Return the faults of meshes, vertex ids and triangles; parts without mesh are skipped."""
    faults = [
        fault.about(part.subject)
        for part in model.parts
        if part.name in meshes
        for fault in _part_mesh(part, meshes[part.name])
    ]
    for region in model.all_regions:
        mesh = meshes.get(region.part)
        if mesh is None or not len(mesh.points):
            continue
        if region.vertices is not None:
            _, missing = mesh.find(region.vertices, region.is_prepared)
            if missing:
                what = f"vertices {list_ids(missing)} are not in part {region.part}"
                todo = f"use its ids, {mesh.describe_ids(region.is_prepared)}"
                brief = f"{counted(len(missing), 'vertex is', 'vertices are')} not in part "
                fault = Fault(f"{region.where}.vertices", what, todo, vertices=tuple(missing))
                fault = replace(fault, brief=f"{brief}{region.part}")
                faults.append(fault.about(region.subject))
        if region.triangle is not None and region.triangle >= mesh.file_triangle_count:
            what = f"triangle {region.triangle} is not in part {region.part}"
            todo = f"use one of its triangles, 0 .. {mesh.file_triangle_count - 1}"
            faults.append(Fault(f"{region.where}.triangle", what, todo).about(region.subject))
    return faults


def _part_mesh(part: PartEntry, mesh: PartMesh) -> Iterator[Fault]:
    if not len(mesh.points):
        yield Fault(part.where, f"the part {part.name} has no vertices", "give it a mesh")
    if mesh.ids is not None and len(mesh.ids):
        largest = np.iinfo(np.int32).max
        huge = mesh.ids[(mesh.ids > largest) | (mesh.ids < -largest)]
        if len(huge):
            what = (
                f"the vertex ids {list_ids(huge.tolist())} of part {part.name} are beyond {largest}"
            )
            yield Fault(part.where, what, "renumber its nodes")


def _list(names: Set[str]) -> str:
    return ", ".join(f'"{name}"' for name in sorted(names)) or "the parts, after you list them"


def _repeated_names(model: Model) -> Iterator[Fault]:
    named: dict[str, Sequence[PartEntry | RegionEntry | ContactEntry | RelationEntry]] = {
        "part": model.parts,
        "region": model.regions,
        "contact": model.contacts,
        "group": [entry for entry in model.relations if entry.type == "group"],
        "pair": [entry for entry in model.relations if entry.type != "group"],
    }
    for what, entries in named.items():
        seen: dict[str, str] = {}
        for entry in entries:
            if entry.name in seen:
                text = f'the {what} name "{entry.name}" is already used by {seen[entry.name]}'
                yield Fault(entry.where, text, "give it another name").about(entry.subject)
            else:
                seen[entry.name] = entry.where


def _primary(model: Model, known: Known) -> Iterator[Fault]:
    if model.primary is None and len(known.parts) > 1:
        todo = f"name the part you deform: {_list(known.parts)}"
        yield Fault("primary", "the key is missing, and there are several parts", todo)
    elif model.primary is not None and not known.has_part(model.primary):
        what = f'there is no part "{model.primary}"'
        yield Fault("primary", what, f"use one of {_list(known.parts)}")


def _numbers(region: RegionEntry) -> Iterator[Fault]:
    yield from _one_of_vertices_and_where(region)
    if region.kind == "handle":
        yield from _either_vertices_or_point(region)
    if region.barycentric is not None:
        where = f"{region.where}.barycentric"
        if abs(sum(region.barycentric) - 1.0) > 1e-9:
            what = f"the three numbers add up to {sum(region.barycentric):.9g}, not 1"
            yield Fault(where, what, "divide them by their sum")
        elif min(region.barycentric) < -1e-9:
            yield Fault(
                where, "a negative number is outside the triangle", "use numbers from 0 to 1"
            )
    yield from _axis(region.where, region.rotation)


def _one_of_vertices_and_where(region: RegionEntry) -> Iterator[Fault]:
    if region.selector is None:
        return
    if region.vertices is not None:
        what = "both vertices and a selector are given"
        yield Fault(region.where, what, 'keep either "vertices" or "where"')
    if region.is_prepared:
        todo = "leave it out next to a selector"
        yield Fault(f"{region.where}.ids", "only vertex ids count in a mesh", todo)
    for fault in form_faults(region.selector):
        place = place_of(region.selector, fault.path) if fault.path else ""
        joint = "" if place.startswith("[") or not place else "."
        yield Fault(f"{region.where}.where{joint}{place}", fault.what, fault.todo)


def _either_vertices_or_point(region: RegionEntry) -> Iterator[Fault]:
    has_point = region.triangle is not None, region.barycentric is not None
    if region.selector is not None and any(has_point):
        todo = 'keep either "where", or triangle and barycentric'
        yield Fault(region.where, "a selector and a point on a triangle are given", todo)
    if region.selector is not None:
        return
    if region.vertices is not None and any(has_point):
        todo = "keep either vertices, or triangle and barycentric"
        yield Fault(region.where, "vertices and a point on a triangle are given", todo)
    if region.vertices is None and not all(has_point):
        todo = "give vertices, or triangle and barycentric"
        yield Fault(region.where, "it has neither vertices nor a complete point", todo)


def _axis(where: str, rotation: Rotation | None) -> Iterator[Fault]:
    if rotation is not None and np.linalg.norm(rotation.axis) < 1e-100:
        todo = "give the axis a direction, for example [0, 0, 1]"
        yield Fault(f"{where}.rotation.axis", "the axis has no length", todo)


_MEANINGLESS = {
    "handle": (
        ("target", "a handle is moved by a translation and a rotation"),
        ("size", "only form features have a size"),
    ),
    "feature": (
        ("translation", "a form feature follows the sheet; a pose can turn it and set its size"),
        ("pivot", "a form feature turns about its own centre"),
        ("target", "a form feature follows the sheet; a pose can turn it and set its size"),
    ),
    "point": (
        ("size", "only form features have a size"),
        ("translation", "a point goes to its target"),
        ("pivot", "a point goes to its target"),
    ),
}


def _moved(region: RegionEntry, moved: Moved, where: str) -> Iterator[Fault]:
    for key, reason in _MEANINGLESS[region.kind]:
        if getattr(moved, key) is not None:
            what = f'"{key}" has no meaning for the {region.kind} "{region.name}"'
            yield Fault(f"{where}.{key}", what, f"leave it out: {reason}")
    if moved.size is not None and region.kind == "feature" and region.size is None:
        what = f'the feature "{region.name}" has no size in the recipe'
        yield Fault(f"{where}.size", what, f'add "size": ... to {region.where}')
    if moved.rotation is not None and region.kind == "handle" and region.turning == "free":
        what = f'the rotation of the handle "{region.name}" is free'
        todo = f'leave it out, or remove "rotation": "free" from {region.where}'
        yield Fault(f"{where}.rotation", what, todo)
    if moved.rotation is not None and region.rotation is None and region.kind != "handle":
        what = f'the {region.kind} "{region.name}" has no rotation of its own in the recipe'
        todo = f'add "rotation": {{"axis": ..., "degrees": 0}} to {region.where}'
        yield Fault(f"{where}.rotation", what, todo)
    yield from _axis(where, moved.rotation)
