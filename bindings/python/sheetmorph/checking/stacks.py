# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proposed rigid contacts, checked against regions: each joins its parts to one rigid body."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from ..recipe.places import driven_in

_REGIONS = ("fixed", "handles", "regions")
Place = tuple[str, int]


def regions_by_vertex(recipe: Mapping[str, Any]) -> dict[Place, set[str]]:
    """Return the fixed regions, handles and followers of each (part, vertex)."""
    found: dict[Place, set[str]] = defaultdict(set)
    for section in _REGIONS:
        entries = recipe.get(section, [])
        for k, entry in enumerate(entries if isinstance(entries, list) else []):
            for vertex in (entry or {}).get("vertices", ()):
                found[entry["part"], vertex].add(f"{section}{k}")
    for k, part, entry in driven_in(recipe):
        for vertex in entry.get("vertices", ()):
            found[part, vertex].add(f"driven{k}")
    return found


def solvable(
    recipe: Mapping[str, Any],
    features: Sequence[Mapping[str, Any]],
    contacts: list[dict[str, Any]],
    told: list[str],
) -> list[dict[str, Any]]:
    """Return the contacts, with rigid ones changed to tied if different regions move their body.

    All fixed regions count as one. The list `told` receives a sentence for each change.
    """
    movers = _movers(recipe)
    bodies = _Bodies()
    bodies.add((entry["part"], entry.get("vertices", ())) for entry in features)
    rigid = [k for k, entry in enumerate(contacts) if entry["type"] == "rigid"]
    for k in rigid:
        bodies.join([_places(contacts[k][side]) for side in "ab"])
    held = bodies.touched(movers)
    result = list(contacts)
    for k in rigid:
        body = bodies.root(next(iter(_places(contacts[k]["a"]))))
        if len(held.get(body, ())) > 1:
            result[k] = {**contacts[k], "type": "tied"}
            told.append(
                f"{contacts[k]['name']}: tied instead of rigid, {' and '.join(sorted(held[body]))} "
                "would tear the rigid body"
            )
    return result


def _movers(recipe: Mapping[str, Any]) -> dict[Place, set[str]]:
    found: dict[Place, set[str]] = defaultdict(set)
    for section, what in (("fixed", "a fixed region"), ("handles", "the handle")):
        for k, entry in enumerate(recipe.get(section, [])):
            name = entry.get("name", f"handle{k}")
            for vertex in entry.get("vertices", ()):
                found[entry["part"], vertex].add(what if section == "fixed" else f'{what} "{name}"')
    return found


def _places(side: Mapping[str, Any]) -> list[Place]:
    return [(side["part"], vertex) for vertex in side["vertices"]]


class _Bodies:
    """Union-find over the vertices of all parts."""

    def __init__(self) -> None:
        self._parent: dict[Place, Place] = {}

    def root(self, place: Place) -> Place:
        self._parent.setdefault(place, place)
        while self._parent[place] != place:
            self._parent[place] = self._parent[self._parent[place]]
            place = self._parent[place]
        return place

    def join(self, sides: Iterable[Iterable[Place]]) -> None:
        """Join all vertices of the sides to one body."""
        first = None
        for side in sides:
            for place in side:
                root = self.root(place)
                first = root if first is None else first
                self._parent[root] = self.root(first)

    def add(self, sets: Iterable[tuple[str, Iterable[int]]]) -> None:
        """Make one body of each set of vertices."""
        for part, vertices in sets:
            self.join([[(part, vertex) for vertex in vertices]])

    def touched(self, movers: Mapping[Place, set[str]]) -> dict[Place, set[str]]:
        """Return the names of the regions that prescribe vertices of each body."""
        found: dict[Place, set[str]] = defaultdict(set)
        for place, names in movers.items():
            if place in self._parent:
                found[self.root(place)] |= names
        return found
