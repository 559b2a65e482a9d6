# SPDX-License-Identifier: LGPL-2.1-or-later
"""`"features": "auto"` and `"contacts": "auto"`: what is found takes the place of the word."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

from ..finding.findings import FindPart, Findings
from ..finding.options import USUAL_FEATURES, FindOptions
from ..finding.search import Connection, find
from .found import Found

SECTIONS = ("features", "contacts")
_REGIONS = ("fixed", "handles", "regions")


def asked_sections(recipe: Any) -> dict[str, dict[str, Any]]:
    """The options of every section that is to be found, by section; {} for the plain word."""
    asked = {}
    for section in SECTIONS if isinstance(recipe, dict) else ():
        value = recipe.get(section)
        if value == "auto":
            asked[section] = {}
        elif isinstance(value, dict) and isinstance(value.get("auto", {}), dict):
            asked[section] = dict(value.get("auto") or {})
    return asked


def without_auto(recipe: Any) -> Any:
    """A recipe in which sections to be found are empty lists."""
    asked = asked_sections(recipe)
    return {**recipe, **{section: [] for section in asked}} if asked else recipe


def search(
    recipe: dict[str, Any], parts: Sequence[FindPart], connections: Sequence[Connection] = ()
) -> Found:
    """What is found in the parts for a recipe of sound form.

    connections: elements that hold two parts together, as find() takes them.
    Raises RuntimeError if the kernel is missing.
    """
    asked = asked_sections(recipe)
    found = find(parts, _options(asked), connections, with_contacts="contacts" in asked)
    return _taken(recipe, asked, found)


def filled(recipe: dict[str, Any], found: Found) -> dict[str, Any]:
    """The recipe with lists in place of what was to be found."""
    lists = {section: getattr(found, section) for section in asked_sections(recipe)}
    return {**recipe, **lists}


def _options(asked: Mapping[str, Mapping[str, Any]]) -> FindOptions:
    features = dict(asked.get("features", {}))
    contacts = dict(asked.get("contacts", {}))
    for key in ("kinds", "parts"):
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
        options = asked["features"]
        kinds, parts = options.get("kinds", USUAL_FEATURES), options.get("parts")
        chosen = [
            entry
            for entry in found.features
            if entry["kind"] in kinds and (parts is None or entry["part"] in parts)
        ]
        result.features = _without_conflicts(recipe, chosen, result.left_out)
    if "contacts" in asked:
        options = asked["contacts"]
        parts = options.get("parts")
        for entry in found.contacts:
            if parts is None or {entry["a"]["part"], entry["b"]["part"]} <= set(parts):
                kind = {"type": options["type"]} if "type" in options else {}
                result.contacts.append({**entry, **kind})
    return result


def _without_conflicts(
    recipe: Mapping[str, Any], entries: list[dict[str, Any]], left_out: list[str]
) -> list[dict[str, Any]]:
    """The features with those of their washer rings that no other feature or region claims.

    A feature torn between two regions, or that shares vertices with one before, is left out.
    """
    regions = _regions_by_vertex(recipe)
    claims: dict[tuple[str, int], set[str]] = defaultdict(set)
    for entry in entries:
        for vertex in entry["vertices"]:
            claims[entry["part"], vertex].add(entry["name"])
    taken: set[tuple[str, int]] = set()
    kept = []
    for entry in entries:
        own = {(entry["part"], vertex) for vertex in entry["vertices"]}
        holders = set().union(*(regions.get(place, set()) for place in own))
        if len(holders) > 1 or own & taken:
            why = "two regions hold it" if len(holders) > 1 else "it overlaps another feature"
            left_out.append(f"{entry['name']}: {why}")
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


def _regions_by_vertex(recipe: Mapping[str, Any]) -> dict[tuple[str, int], set[str]]:
    found: dict[tuple[str, int], set[str]] = defaultdict(set)
    for section in _REGIONS:
        entries = recipe.get(section, [])
        for k, entry in enumerate(entries if isinstance(entries, list) else []):
            for vertex in (entry or {}).get("vertices", ()):
                found[entry["part"], vertex].add(f"{section}{k}")
    return found
