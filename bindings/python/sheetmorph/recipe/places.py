# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places in a recipe as text for the user."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ..base.errors import Subject

_SECTIONS = {
    "parts": ("part", "part"),
    "fixed": ("fixed region", "fixed"),
    "handles": ("handle", "handle"),
    "features": ("feature", "feature"),
    "points": ("point", "point"),
    "regions": ("follower", "follower"),
    "contacts": ("contact", "contact"),
    "groups": ("group", "group"),
    "coaxial": ("pair", "coaxial"),
    "distance": ("pair", "distance"),
}
"""Section to the kind of its entries and the prefix of their default names."""


def place_of(recipe: Any, path: Sequence[str | int]) -> str:
    """Return a path as text with entry names: `handles[0] (tip).vertices[2]`."""
    text = ""
    node = recipe
    for step in path:
        if isinstance(step, int):
            text += f"[{step}]"
        else:
            text += f".{step}" if text else step
        node = _child(node, step)
        if isinstance(step, int) and isinstance(node, dict) and isinstance(node.get("name"), str):
            text += f" ({node['name']})"
    return text or "recipe"


def subjects_at(recipe: Any, path: Sequence[str | int]) -> tuple[Subject, ...]:
    """Return the recipe entry that contains a path; an empty tuple outside the lists of entries."""
    section, number = (*path, "", "")[:2]
    if isinstance(number, int) and (found := _SECTIONS.get(str(section))):
        kind, begin = found
        entry = _child(_child(recipe, section), number)
        name = entry.get("name") if isinstance(entry, dict) else None
        return (Subject(kind, name if isinstance(name, str) else f"{begin}{number}"),)
    steps = path[1:] if section == "pose" else path[2:] if section == "poses" else ()
    return (Subject("region", steps[0]),) if steps and isinstance(steps[0], str) else ()


def driven_in(recipe: Mapping[str, Any]) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """Yield the key `driven` of all parts: number, name and entry.

    The name is "" for a split file, whose parts have no name of their own here.
    """
    parts = recipe.get("parts")
    for k, part in enumerate(parts if isinstance(parts, list) else []):
        if isinstance(part, dict) and isinstance(part.get("driven"), dict):
            name = "" if part.get("split") else part.get("name", f"part{k}")
            yield k, name, part["driven"]


def _child(node: Any, step: str | int) -> Any:
    if isinstance(node, dict):
        return node.get(step)
    if isinstance(node, list) and isinstance(step, int) and 0 <= step < len(node):
        return node[step]
    return None


def names_in(recipe: Any, section: str) -> set[str]:
    """Return the names in a list of the recipe, including those of faulty entries."""
    entries = recipe.get(section) if isinstance(recipe, dict) else None
    if not isinstance(entries, list):
        return set()
    found = [entry.get("name") for entry in entries if isinstance(entry, dict)]
    return {name for name in found if isinstance(name, str)}
