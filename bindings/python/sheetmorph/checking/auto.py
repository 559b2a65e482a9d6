# SPDX-License-Identifier: LGPL-2.1-or-later
"""`"features": "auto"` and `"contacts": "auto"`: the search result replaces the word."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..finding.findings import FindPart, Findings, body_entries
from ..finding.options import HOLES, USUAL_FEATURES, FindOptions
from ..finding.search import Connection, find
from ..recipe.found import Found
from ..recipe.places import driven_in
from .stacks import regions_by_vertex, solvable

SECTIONS = ("features", "contacts")
# Options of "auto" that are copied to every feature.
_OF_EVERY = ("rotation",)


def asked_sections(recipe: Any) -> dict[str, dict[str, Any]]:
    """Return the search options of every "auto" section; {} for the plain word."""
    asked: dict[str, dict[str, Any]] = {}
    for section in SECTIONS if isinstance(recipe, dict) else ():
        value = recipe.get(section)
        if value == "auto":
            asked[section] = {}
        elif isinstance(value, dict) and isinstance(value.get("auto", {}), dict):
            asked[section] = dict(value.get("auto") or {})
    return asked


def without_auto(recipe: Any) -> Any:
    """Return the recipe with empty lists in its "auto" sections."""
    asked = asked_sections(recipe)
    return {**recipe, **{section: [] for section in asked}} if asked else recipe


def search(
    recipe: dict[str, Any],
    parts: Sequence[FindPart],
    connections: Sequence[Connection] = (),
    progress: Progress | None = None,
) -> Found:
    """Search the parts of a recipe for features and contacts.

    connections are elements that join two parts, as for find(). The form of the recipe is already
    checked. Raises RuntimeError without a kernel.
    """
    asked = asked_sections(recipe)
    with_contacts = "contacts" in asked
    found = find(parts, _options(asked), connections, progress, with_contacts=with_contacts)
    bodies = [entry for part in parts for entry in body_entries(part)]
    return _taken(recipe, asked, replace(found, features=[*found.features, *bodies]))


def filled(recipe: dict[str, Any], found: Found) -> dict[str, Any]:
    """Return the recipe with lists in place of its "auto" sections."""
    lists = {section: getattr(found, section) for section in asked_sections(recipe)}
    return {**recipe, **lists}


def in_file_ids(recipe: dict[str, Any], meshes: Mapping[str, PartMesh]) -> dict[str, Any]:
    """Return the recipe with file ids in place of ids of prepared meshes, for the search.

    Each is the id of the nearest file vertex.
    """
    changed = dict(recipe)
    for section in ("fixed", "handles", "regions", "features"):
        if isinstance(recipe.get(section), list):
            changed[section] = [_of_file(entry, meshes) for entry in recipe[section]]
    for k, name, entry in driven_in(recipe):
        told = _of_file({**entry, "part": name}, meshes)
        parts = list(changed["parts"])
        parts[k] = {**parts[k], "driven": {"vertices": told["vertices"]}}
        changed["parts"] = parts
    return changed


def _of_file(entry: dict[str, Any], meshes: Mapping[str, PartMesh]) -> dict[str, Any]:
    if entry.get("ids") != "prepared":
        return entry
    return {**entry, "vertices": meshes[entry["part"]].file_ids(entry["vertices"])}


def _options(asked: Mapping[str, Mapping[str, Any]]) -> FindOptions:
    features = dict(asked.get("features", {}))
    contacts = dict(asked.get("contacts", {}))
    for key in ("kinds", "parts", *_OF_EVERY):
        features.pop(key, None)
    for key in ("type", "parts"):
        contacts.pop(key, None)
    if "kinds" in contacts:
        contacts["contact_kinds"] = contacts.pop("kinds")
    return FindOptions().changed({**features, **contacts})


def _taken(
    recipe: Mapping[str, Any], asked: Mapping[str, Mapping[str, Any]], found: Findings
) -> Found:
    result = Found(gap=found.gap)
    if "features" in asked:
        chosen = _wanted_features(asked["features"], found.features, result.left_out)
        turning = {key: asked["features"][key] for key in _OF_EVERY if key in asked["features"]}
        kept = _without_conflicts(recipe, chosen, result.left_out)
        result.features = [{**entry, **turning} for entry in kept]
    if "contacts" in asked:
        options = asked["contacts"]
        parts = options.get("parts")
        for entry in found.contacts:
            if parts is None or {entry["a"]["part"], entry["b"]["part"]} <= set(parts):
                kind = {"type": options["type"]} if "type" in options else {}
                result.contacts.append({**entry, **kind})
        if "type" not in options:
            features = result.features if "features" in asked else recipe.get("features", [])
            result.contacts = solvable(recipe, features, result.contacts, result.left_out)
    return result


def _wanted_features(
    options: Mapping[str, Any], found: list[dict[str, Any]], left_out: list[str]
) -> list[dict[str, Any]]:
    """Return the features of the requested kinds and parts; report omitted holes in left_out."""
    kinds, parts = options.get("kinds", (*USUAL_FEATURES, "rigid body")), options.get("parts")
    on_parts = [entry for entry in found if parts is None or entry["part"] in parts]
    left_out += [
        f'{entry["name"]}: "kinds" excludes {entry["kind"]}s'
        for entry in on_parts
        if entry["kind"] in HOLES and entry["kind"] not in kinds
    ]
    return [entry for entry in on_parts if entry["kind"] in kinds]


def _without_conflicts(
    recipe: Mapping[str, Any], entries: list[dict[str, Any]], left_out: list[str]
) -> list[dict[str, Any]]:
    """Return the features with their washer rings, as far as nothing else claims the rings.

    Features that share vertices are joined. A feature between two regions is left out.
    """
    regions = regions_by_vertex(recipe)
    entries = _joined(entries, left_out)
    claims: dict[tuple[str, int], set[str]] = defaultdict(set)
    for entry in entries:
        for vertex in entry["vertices"]:
            claims[entry["part"], vertex].add(entry["name"])
    taken: set[tuple[str, int]] = set()
    kept = []
    for entry in entries:
        own = {(entry["part"], vertex) for vertex in entry["vertices"]}
        holders = set().union(*(regions.get(place, set()) for place in own))
        if len(holders) > 1:
            left_out.append(f"{entry['name']}: two regions constrain it")
            continue
        vertices = set(own)
        for ring in entry.get("washer", ()):
            places = {(entry["part"], vertex) for vertex in ring}
            is_free = all(
                claims[place] <= {entry["name"]} and regions.get(place, set()) <= holders
                for place in places
            )
            if not is_free or places & taken:
                break
            vertices |= places
        taken |= vertices
        kept.append({**entry, "vertices": sorted(vertex for _, vertex in vertices)})
    return kept


def _joined(entries: list[dict[str, Any]], told: list[str]) -> list[dict[str, Any]]:
    """Join entries that share vertices, under the name of the first."""
    kept: dict[str, dict[str, Any]] = {}
    owner: dict[tuple[str, int], str] = {}
    for entry in entries:
        places = [(entry["part"], vertex) for vertex in entry["vertices"]]
        touched = list(dict.fromkeys(owner[place] for place in places if place in owner))
        first = touched[0] if touched else entry["name"]
        joined = [kept.pop(name) for name in touched[1:]] + [entry]
        for other in joined if touched else []:
            vertices = {*kept[first]["vertices"], *other["vertices"]}
            # The rings around one feature cross the other.
            kept[first] = {**kept[first], "vertices": sorted(vertices), "washer": []}
            told.append(f"{other['name']}: merged with {first}, because they share vertices")
        if not touched:
            kept[first] = entry
        for vertex in kept[first]["vertices"]:
            owner[entry["part"], vertex] = first
    return list(kept.values())
