# SPDX-License-Identifier: LGPL-2.1-or-later
"""A recipe's regions and pose as document objects; the recipe has been validated before."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from freecad.sheetmorph.api.assemblies import set_refine, set_symmetry, set_unheld
from freecad.sheetmorph.api.contacts import add_contact
from freecad.sheetmorph.api.features import add_relation, set_feature_motion, set_size
from freecad.sheetmorph.api.motions import put, set_free_rotation, set_rotation
from freecad.sheetmorph.api.propagations import set_propagation
from freecad.sheetmorph.api.regions import add_feature, add_fixed, add_follower, add_handle
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.assembly import LOCAL
from freecad.sheetmorph.objects.contact import CONTROL_MESH
from freecad.sheetmorph.objects.region import AXIS, FREE, LINE, PLANE
from freecad.sheetmorph.bridge import selecting
from freecad.sheetmorph.bridge.recipes import RELATION_KEYS
from freecad.sheetmorph.tools.motion import motion_from


WORDS = (
    ("parts", "part"),
    ("fixed", "fixed"),
    ("handles", "handle"),
    ("features", "feature"),
    ("points", "point"),
    ("regions", "region"),
    ("contacts", "contact"),
    ("groups", "group"),
    ("coaxial", "coaxial"),
    ("distance", "distance"),
)
"""What the entries of a list in a recipe are called that have no name: fixed0, fixed1, ..."""
ADDERS = (
    ("fixed", add_fixed),
    ("handles", add_handle),
    ("features", add_feature),
    ("regions", add_follower),
)


def with_names(recipe: dict) -> dict:
    """Return a recipe whose entries all have the names that others may call them."""
    named = dict(recipe)
    for key, word in WORDS:
        entries = recipe.get(key, [])
        named[key] = [{"name": f"{word}{k}", **entry} for k, entry in enumerate(entries)]
    return named


def add_regions(assembly, recipe: dict, parts: dict, meshes: dict) -> dict:
    """Add all regions of a recipe and return them by their name in it.

    `recipe`: from `with_names`; by name of the part in the recipe: `parts` and `meshes`, which
    know the ids of the file.
    """
    added = {}
    for key, add in ADDERS:
        for entry in recipe[key]:
            if "vertices" not in entry:
                continue  # a handle that is a point on a triangle: kept as an extra
            vertices, name = vertices_of(entry, meshes), entry["name"]
            added[name] = add(assembly, parts[entry["part"]], vertices, name)
            keep_sentence(added[name], entry.get(SENTENCE))
    return added


def vertices_of(entry: dict, meshes: dict) -> np.ndarray:
    """Return the vertices (k,) of a region or a side of a contact on its mesh."""
    is_prepared = entry.get("ids") == "prepared"
    return meshes[entry["part"]].find(entry["vertices"], is_prepared)[0]


SENTENCE = "where it was"
"""A key, of no recipe, with what a region said before it was resolved."""


def with_sentences(recipe: dict, written: dict) -> dict:
    """Return a recipe from `with_names` whose regions still know what they said in the file."""
    told = dict(recipe)
    for key, _ in ADDERS:
        said = written.get(key)
        if isinstance(said, list) and len(said) == len(recipe[key]):
            told[key] = [
                {**entry, SENTENCE: old["where"]} if "where" in old else entry
                for entry, old in zip(recipe[key], said)
            ]
    told["parts"] = [
        {**entry, "driven": {**entry["driven"], SENTENCE: old["driven"].get("where")}}
        if "driven" in entry
        else entry
        for entry, old in zip(recipe["parts"], written["parts"])
    ]
    contacts = written.get("contacts")
    if isinstance(contacts, list):
        told["contacts"] = [
            {**entry, **{side: {**entry[side], SENTENCE: old[side].get("where")} for side in "ab"}}
            for entry, old in zip(recipe["contacts"], contacts)
        ]
    return told


def add_driven(assembly, recipe: dict, parts: dict, meshes: dict) -> None:
    """Add a follower for what a part says of itself is driven; arguments as for `add_regions`."""
    for entry in recipe["parts"]:
        if "driven" in entry:
            name = entry["name"]
            vertices = vertices_of({**entry["driven"], "part": name}, meshes)
            added = add_follower(assembly, parts[name], vertices, f"{name}: driven")
            keep_sentence(added, entry["driven"].get(SENTENCE))


def keep_sentence(region, where) -> None:
    """Let a region say what it is, if that gives just its vertices in the document too."""
    if says(region.Part, where, model.vertices(region)):
        model.set_vertices(region, model.vertices(region), json.dumps(where))


def says(part, where, vertices: np.ndarray) -> bool:
    """Whether a selector, None for none, stands for just these vertices (k,) of a part."""
    try:
        return where is not None and np.array_equal(selecting.select(part, where), vertices)
    except ValueError:
        return False


def add_contacts(assembly, recipe: dict, parts: dict, meshes: dict) -> None:
    """Add all contacts of a recipe; arguments as for `add_regions`."""
    for entry in recipe["contacts"]:
        a, b = (
            (parts[side["part"]], vertices_of(side, meshes)) for side in (entry["a"], entry["b"])
        )
        kind = entry.get("type", CONTROL_MESH)
        added = add_contact(assembly, a, b, label=entry["name"], type=kind)
        for side, (part, _) in (("a", a), ("b", b)):
            vertices, where = model.contact_vertices(added, side), entry[side].get(SENTENCE)
            if says(part, where, vertices):
                model.set_contact_vertices(added, side, vertices, json.dumps(where))


def apply_propagation(assembly, recipe: dict) -> None:
    """Set how the motion reaches the other parts as a recipe has it."""
    wanted = recipe.get("propagation", {})
    set_propagation(
        assembly,
        wanted.get("type", LOCAL),
        levels=wanted.get("levels"),
        smoothness=wanted.get("smoothness"),
    )


def add_relations(assembly, recipe: dict, regions: dict) -> None:
    """Add the groups and pairs of form features; `regions`: from `add_regions`."""
    for kind, key in RELATION_KEYS.items():
        for entry in recipe[key]:
            features = [regions[name] for name in entry["features"]]
            add_relation(assembly, kind, features, entry["name"])


def apply_options(assembly, recipe: dict) -> None:
    """Set symmetry, refinement and what becomes of loose pieces as a recipe has them."""
    if "symmetry" in recipe:
        set_symmetry(assembly, recipe["symmetry"]["normal"], recipe["symmetry"]["point"])
    set_refine(assembly, recipe.get("refine", False))
    set_unheld(assembly, recipe.get("unheld", "rest"))


def apply_allowed(feature, entry: dict) -> None:
    """Set one feature's motion and size from its entry in a recipe."""
    motion = entry.get("motion", {})
    direction = motion.get("normal", motion.get("direction"))
    kind = motion.get("type", FREE)
    has_direction = kind in (PLANE, LINE, AXIS)
    set_feature_motion(
        feature, kind, direction=direction if has_direction else None, point=motion.get("point")
    )
    if "size" in entry:
        set_size(feature, entry["size"])


def apply_pose(regions: dict, recipe: dict) -> None:
    """Set motions of handles, rotations, motions and sizes of features as a recipe has them."""
    pose = recipe.get("pose", {})
    for entry in recipe["handles"]:
        region = regions.get(entry["name"])
        if region is not None:
            put(region, motion_from({**pick(entry, "pivot"), **pose.get(entry["name"], {})}))
            set_free_rotation(region, entry.get("rotation") == FREE)
    for entry in recipe["features"]:
        merged = {**entry, **pose.get(entry["name"], {})}
        apply_rotation(regions[entry["name"]], merged.get("rotation", FREE))
        apply_allowed(regions[entry["name"]], merged)


def pick(entry: dict, key: str) -> dict:
    """Return a dict with `key` alone, empty if the entry lacks it."""
    return {key: entry[key]} if key in entry else {}


def apply_rotation(feature, rotation: str | dict) -> None:
    """Set one feature's rotation from its entry in a recipe or a pose."""
    if isinstance(rotation, dict):
        degrees = rotation["degrees"]
        axis = rotation["axis"] if degrees != 0 else (0, 0, 1)
        set_rotation(feature, (axis, degrees))
    else:
        set_rotation(feature, rotation)


def keep_extras(assembly, recipe: dict, regions: dict, parts: dict) -> None:
    """Keep in the document what a recipe says beyond regions: points, and what moves them."""
    point_handles = [entry for entry in recipe["handles"] if "vertices" not in entry]
    extras = {
        key: [{**entry, "part": parts[entry["part"]].Name} for entry in entries]
        for key, entries in (("points", recipe["points"]), ("handles", point_handles))
        if entries
    }
    pose = {name: move for name, move in recipe.get("pose", {}).items() if name not in regions}
    if extras or pose:
        assembly.Extras = json.dumps({"recipe": extras, "pose": pose})


def keep_files(assembly, recipe: dict, folder: Path) -> None:
    """Keep in the document what a recipe, its files relative to `folder`, says of others than those
    of parts: repair, and files of welds and bolts."""
    joints = recipe.get("joint_files", [])
    repair = {True: "standard", False: ""}.get(recipe.get("repair", ""), recipe.get("repair", ""))
    asked = [folder / name for name in (repair, *(one["file"] for one in joints))]
    files = {path.name: path.read_bytes().decode("latin-1") for path in asked if path.is_file()}
    assembly.Repair = Path(repair).name
    if files or joints:
        beside = [{**one, "file": Path(one["file"]).name} for one in joints]
        extras = json.loads(assembly.Extras or "{}")
        assembly.Extras = json.dumps({**extras, "joint_files": beside, "files": files})
