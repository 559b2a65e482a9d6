# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph as a recipe, from the objects of a document, without meshes or the kernel."""

from __future__ import annotations

import json

import numpy as np

from freecad.sheetmorph.kinds import CONTACT, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.model import Members
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.objects.deck import told_thickness
from freecad.sheetmorph.objects.part import MODES, THIN_AUTOMATIC, THIN_GIVEN
from freecad.sheetmorph.objects.region import (
    AXIS,
    FIXED,
    FOLLOWER,
    FORM_FEATURE,
    FREE,
    HANDLE,
    LINE,
    PLANE,
    PRESCRIBED,
    as_told,
    motion_of,
)
from freecad.sheetmorph.objects.properties import number_of, vector_of
from freecad.sheetmorph.objects.relation import COAXIAL, DISTANCE, GROUP
from freecad.sheetmorph.tools.motion import Motion

FORMAT = 1
"""Version of the recipe format."""

KEYS = {FIXED: "fixed", HANDLE: "handles", FORM_FEATURE: "features", FOLLOWER: "regions"}
"""Recipe list of the regions of each role."""

RELATION_KEYS = {GROUP: "groups", COAXIAL: "coaxial", DISTANCE: "distance"}
"""Recipe list of the relations of each type."""


def names_of(assembly) -> dict[str, str]:
    """Return the recipe names of parts, regions, contacts and relations by object name.

    They are labels, because the user reads them. A label that another object or an entry of the
    imported recipe uses is followed by the object name. Here and below `assembly` may be its
    Members, which callers of several functions read once.
    """
    return {found: name for (_, name), found in objects_of(assembly).items()}


def objects_of(assembly) -> dict[tuple[str, str], str]:
    """Return the document object names by recipe list and name."""
    found: dict[tuple[str, str], str] = {}
    members = Members.of(assembly)
    of_list = {
        "part": members.parts,
        "region": members.regions,
        "contact": members.contacts,
        "relation": members.relations,
    }
    extras = extras_of(members.assembly)
    foreign = {entry.get("name") for entries in extras.values() for entry in entries}
    for of_kind, objects in of_list.items():
        taken = {name for name in foreign if isinstance(name, str)}
        for obj in objects:
            name = obj.Label or obj.Name
            while name in taken:
                name = f"{name} ({obj.Name})"
            taken.add(name)
            found[of_kind, name] = obj.Name
    return found


def recipe_of(assembly, ids: dict[str, np.ndarray]) -> dict:
    """Return the recipe of `assembly` without its pose. Raises MorphError for lost vertices.

    `ids` has the file ids (n,) of the vertices by object name of the part. The entries of the parts
    have no files; the writer of a recipe adds them.
    """
    members = Members.of(assembly)
    names, found, assembly = names_of(members), members.parts, members.assembly
    recipe = {
        "sheetmorph": FORMAT,
        "parts": [part_entry(part, names) for part in found],
        "primary": names[primary_of(members).Name] if found else "",
        "energy": assembly.Energy,
        "operator": assembly.Operator,
        "fixed": [],
        "handles": [],
        "features": [],
        "regions": [],
    }
    if len(found) > 1:
        recipe["propagation"] = propagation_of(assembly)
    for region in members.regions:
        if region.Part is None or region.Part.Name not in ids:
            continue
        recipe[KEYS[region.Role]].append(entry_of(region, names, ids[region.Part.Name]))
    recipe["contacts"] = [contact_entry(c, names, ids) for c in used_contacts(members)]
    recipe.update(relation_entries(members, names))
    recipe.update(answer_options(assembly))
    for key, entries in extras_of(assembly).items():
        named = [{**e, "part": names[e["part"]]} for e in entries if e["part"] in names]
        recipe[key] = recipe.get(key, []) + named
    return recipe


def primary_of(assembly):
    """Return the primary part: the chosen one, else the first; None without parts."""
    members = Members.of(assembly)
    primary = members.assembly.Primary
    if primary in members.parts:
        return primary
    return members.parts[0] if members.parts else None


def relation_entries(members: Members, names: dict[str, str]) -> dict[str, list]:
    """Return the complete groups and pairs of form features by recipe key."""
    entries: dict[str, list] = {}
    for relation in members.relations:
        features = [f for f in relation.Features if f in members.group and f.Part is not None]
        if len(features) >= 2 and all(f.Role == FORM_FEATURE for f in features):
            entry = {"name": names[relation.Name], "features": [names[f.Name] for f in features]}
            entries.setdefault(RELATION_KEYS[relation.Type], []).append(entry)
    return entries


def answer_options(assembly) -> dict:
    """Return symmetry, refinement and behaviour of loose pieces, if not the default."""
    found: dict = {}
    if assembly.Symmetry:
        point, normal = (
            list(vector_of(assembly, f"Symmetry{what}")) for what in ("Point", "Normal")
        )
        found["symmetry"] = {"point": point, "normal": normal}
    if assembly.Refine:
        found["refine"] = True
    if assembly.Unheld != "rest":
        found["unheld"] = assembly.Unheld
    return found


def part_entry(part, names: dict[str, str]) -> dict:
    """Return the recipe entry of a part without its file."""
    mode = MODES.index(part.Mode)
    found = {"name": names[part.Name], **({"mode": mode} if mode else {})}
    return {**found, **thin_entry(part), **sheet_entry(part)}


def sheet_entry(part) -> dict:
    """Return the steel properties of a part, if not the default."""
    thickness, poisson = number_of(part, "SheetThickness") or told_thickness(part), part.Poisson
    found = {"thickness": thickness} if thickness > 0.0 else {}
    return {**found, **({"poisson": poisson} if poisson != 0.3 else {})}


def thin_entry(part) -> dict:
    """Return the recipe key of a thin solid; empty for any other part."""
    if part.Thin == THIN_AUTOMATIC:
        return {"thin": "auto"}
    return {"thin": {"thickness": number_of(part, "Thickness")}} if part.Thin == THIN_GIVEN else {}


def propagation_of(assembly) -> dict:
    """Return the propagation in the form of a recipe."""
    return {
        "type": assembly.Propagation,
        "levels": assembly.Levels,
        "smoothness": assembly.Smoothness,
    }


def used_contacts(assembly) -> list:
    """Return the active contacts whose parts both exist."""
    members = Members.of(assembly)
    return [c for c in members.contacts if c.Active and has_both_parts(c, members.parts)]


def has_both_parts(contact, parts: list) -> bool:
    """Return whether both parts of a contact are in the assembly."""
    return contact.PartA in parts and contact.PartB in parts


def contact_entry(contact, names: dict[str, str], ids: dict[str, np.ndarray]) -> dict:
    """Return the recipe entry of a contact. Raises MorphError for lost vertices."""
    entry = {"name": names[contact.Name], "type": contact.Type}
    for side, part in (("a", contact.PartA), ("b", contact.PartB)):
        vertices = model.contact_vertices(contact, side)
        chosen = ids_of(vertices, (contact, part), ids[part.Name])
        entry[side] = {"part": names[part.Name], "vertices": chosen}
    return entry


def ids_of(vertices: np.ndarray, owner: tuple, ids: np.ndarray) -> list[int]:
    """Return the file ids of vertices; `owner` has their object and the part.

    Raises MorphError if there are none, or if the part has lost one.
    """
    obj, part = owner
    word = "Contact" if kind(obj) == CONTACT else "Region"
    if len(vertices) == 0:
        raise MorphError(f"{word} '{obj.Label}' has no vertices; pick some or delete it.", obj)
    if vertices.min() < 0:
        raise MorphError(
            f"The vertices of {word.lower()} '{obj.Label}' are damaged; pick them again.", obj
        )
    if vertices.max() >= len(ids):
        raise MorphError(
            f"{word} '{obj.Label}': vertex {vertices.max()} is no longer in part "
            f"'{part.Label}', which has 0 .. {len(ids) - 1}; pick again.",
            obj,
        )
    return ids[vertices].tolist()


def entry_of(region, names: dict[str, str], ids: np.ndarray) -> dict:
    """Return the recipe entry of a region. Raises MorphError for lost vertices."""
    entry = {
        "name": names[region.Name],
        "part": names[region.Part.Name],
        "vertices": ids_of(model.vertices(region), (region, region.Part), ids),
    }
    if region.Role == FOLLOWER:
        entry["role"] = FOLLOWER
    if region.Role == FORM_FEATURE:
        # The recipe states only whether the rotation is prescribed; the pose has its value.
        is_prescribed = region.Rotation == PRESCRIBED
        entry["rotation"] = {"axis": [0, 0, 1], "degrees": 0} if is_prescribed else region.Rotation
        entry.update(allowed_of(region))
    if region.Role == HANDLE and region.FreeRotation:
        entry["rotation"] = FREE
    return entry


def allowed_of(feature) -> dict:
    """Return the motion and the size of a form feature, if set."""
    found: dict = {}
    direction = list(vector_of(feature, "MotionDirection"))
    if feature.Motion != FREE:
        found["motion"] = {"type": feature.Motion}
    if feature.Motion == PLANE:
        found["motion"]["normal"] = direction
    elif feature.Motion in (LINE, AXIS):
        found["motion"]["direction"] = direction
    if feature.Motion == AXIS:
        found["motion"]["point"] = list(vector_of(feature, "MotionPoint"))
    if number_of(feature, "Size") > 0.0:
        found["size"] = number_of(feature, "Size")
    return found


def pose_of(assembly, names: dict[str, str] | None = None) -> dict:
    """Return the pose by recipe name: handles, prescribed rotations, and imported points."""
    members = Members.of(assembly)
    names = names or names_of(members)
    pose = dict(extras_of(members.assembly, "pose"))
    for region in members.regions:
        is_turned = region.Role == FORM_FEATURE and region.Rotation == PRESCRIBED
        if region.Part is not None and (region.Role == HANDLE or is_turned):
            pose[names[region.Name]] = as_told(region, motion_of(region))
    return pose


def entries_of(pose: dict) -> dict:
    """Return a pose in the form of a recipe."""
    return {k: one.entry() if isinstance(one, Motion) else one for k, one in pose.items()}


def beside_of(assembly) -> tuple[dict, dict[str, str]]:
    """Return the recipe keys for files other than parts, and their texts by name.

    These are the repair criteria and joint files of an imported recipe; FreeCAD uses neither.
    """
    joints, texts = extras_of(assembly, "joint_files"), extras_of(assembly, "files")
    names = [assembly.Repair, *(one["file"] for one in joints)]
    found = {"repair": assembly.Repair} if assembly.Repair else {}
    found |= {"joint_files": joints} if joints else {}
    return found, {name: texts[name] for name in names if name in texts}


def extras_of(assembly, part: str = "recipe") -> dict:
    """Return data of an imported recipe without objects: `recipe`, `pose`, `joint_files` or
    `files`.

    Those of the recipe are lists of entries, such as points on triangles; their part is a document
    object name.
    """
    return json.loads(assembly.Extras).get(part, {}) if assembly.Extras else {}
