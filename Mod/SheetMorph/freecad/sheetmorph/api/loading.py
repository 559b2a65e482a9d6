# SPDX-License-Identifier: LGPL-2.1-or-later
"""The regions and the pose of a validated recipe as document objects."""

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
"""Names of recipe entries without a name: fixed0, fixed1, ..."""
ADDERS = (
    ("fixed", add_fixed),
    ("handles", add_handle),
    ("features", add_feature),
    ("regions", add_follower),
)


def with_names(recipe: dict) -> dict:
    """Return a recipe with a name for every entry."""
    named = dict(recipe)
    for key, word in WORDS:
        entries = recipe.get(key, [])
        named[key] = [{"name": f"{word}{k}", **entry} for k, entry in enumerate(entries)]
    return named


def add_regions(assembly, recipe: dict, parts: dict, meshes: dict) -> dict:
    """Add all regions of a recipe and return them by their recipe names.

    `recipe` comes from `with_names`. `parts` and `meshes` are by recipe name, and the meshes have
    the file ids.
    """
    added = {}
    for key, add in ADDERS:
        for entry in recipe[key]:
            if "vertices" not in entry:
                continue  # a handle at a point on a triangle is stored as an extra
            vertices, name = vertices_of(entry, meshes), entry["name"]
            added[name] = add(assembly, parts[entry["part"]], vertices, name)
            keep_sentence(added[name], entry.get(SENTENCE))
    return added


def vertices_of(entry: dict, meshes: dict) -> np.ndarray:
    """Return the vertices (k,) of a region or a contact side on its mesh."""
    is_prepared = entry.get("ids") == "prepared"
    return meshes[entry["part"]].find(entry["vertices"], is_prepared)[0]


SENTENCE = "where it was"
"""Internal key with the selector of a region before it was resolved."""


def with_sentences(recipe: dict, written: dict) -> dict:
    """Return a recipe from `with_names` with the original selectors of its regions."""
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
    """Add a follower for the key `driven` of each part; arguments as for `add_regions`."""
    for entry in recipe["parts"]:
        if "driven" in entry:
            name = entry["name"]
            vertices = vertices_of({**entry["driven"], "part": name}, meshes)
            added = add_follower(assembly, parts[name], vertices, f"{name}: driven")
            keep_sentence(added, entry["driven"].get(SENTENCE))


def keep_sentence(region, where) -> None:
    """Store the selector of a region if it gives the same vertices in the document."""
    if says(region.Part, where, model.vertices(region)):
        model.set_vertices(region, model.vertices(region), json.dumps(where))


def says(part, where, vertices: np.ndarray) -> bool:
    """Return whether a selector, or None, gives exactly these vertices (k,) of a part."""
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
    """Set the propagation of a recipe."""
    wanted = recipe.get("propagation", {})
    set_propagation(
        assembly,
        wanted.get("type", LOCAL),
        levels=wanted.get("levels"),
        smoothness=wanted.get("smoothness"),
    )


def add_relations(assembly, recipe: dict, regions: dict) -> None:
    """Add the groups and pairs of form features; `regions` comes from `add_regions`."""
    for kind, key in RELATION_KEYS.items():
        for entry in recipe[key]:
            features = [regions[name] for name in entry["features"]]
            add_relation(assembly, kind, features, entry["name"])


def apply_options(assembly, recipe: dict) -> None:
    """Set symmetry, refinement and the behaviour of loose pieces from a recipe."""
    if "symmetry" in recipe:
        set_symmetry(assembly, recipe["symmetry"]["normal"], recipe["symmetry"]["point"])
    set_refine(assembly, recipe.get("refine", False))
    set_unheld(assembly, recipe.get("unheld", "rest"))


def apply_allowed(feature, entry: dict) -> None:
    """Set motion and size of a feature from its recipe entry."""
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
    """Set motions of handles, and rotations, motions and sizes of features from a recipe."""
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
    """Return a dict with only `key`, empty if the entry lacks it."""
    return {key: entry[key]} if key in entry else {}


def apply_rotation(feature, rotation: str | dict) -> None:
    """Set the rotation of a feature from its entry in a recipe or a pose."""
    if isinstance(rotation, dict):
        degrees = rotation["degrees"]
        axis = rotation["axis"] if degrees != 0 else (0, 0, 1)
        set_rotation(feature, (axis, degrees))
    else:
        set_rotation(feature, rotation)


def keep_extras(assembly, recipe: dict, regions: dict, parts: dict) -> None:
    """Store recipe data without regions in the document: points, and their motions."""
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
    """Store the repair criteria and joint files of a recipe in the document.

    Paths are relative to `folder`.
    """
    joints = recipe.get("joint_files", [])
    repair = {True: "standard", False: ""}.get(recipe.get("repair", ""), recipe.get("repair", ""))
    asked = [folder / name for name in (repair, *(one["file"] for one in joints))]
    files = {path.name: path.read_bytes().decode("latin-1") for path in asked if path.is_file()}
    assembly.Repair = Path(repair).name
    if files or joints:
        beside = [{**one, "file": Path(one["file"]).name} for one in joints]
        extras = json.loads(assembly.Extras or "{}")
        assembly.Extras = json.dumps({**extras, "joint_files": beside, "files": files})
