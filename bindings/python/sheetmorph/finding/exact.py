# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact values of CAD surfaces in place of values fitted to their meshes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..files.cad_file import CadFile, exact_features
from ..recipe.parts import Source
from .exact_outlines import OUTLINES, exact_outline

Entry = dict[str, Any]
_NUMBERS = ("radius", "angle", "hollow", "residual")


def exact_of(source: Source) -> dict[str, list[Entry]]:
    """Return the exact features of the parts of a CAD file by part name; vertices are indices.

    Other files give an empty dict.
    """
    if not isinstance(source.file, CadFile):
        return {}
    parts = source.file.model.parts
    placed = source.placement.placed_entry
    bodies = [[placed(entry) for entry in exact_features(part)] for part in parts]
    names = [f"{source.file.path.stem}/{part.name}" for part in parts]
    if len(source.members) > 1 or names[0] in source.members:
        return dict(zip(names, bodies))
    first = np.cumsum([0, *(len(part.points) for part in parts)]).tolist()
    whole = [_shifted(entry, start) for start, body in zip(first, bodies) for entry in body]
    return {name: whole for name in source.members}


def _shifted(entry: Entry, first: int) -> Entry:
    return {**entry, "vertices": [v + first for v in entry["vertices"]]}


def with_exact(entries: list[Entry], exact: list[Entry], walls: list[Entry]) -> list[Entry]:
    """Return the entries found on a part's mesh, with exact values where CAD has the same feature.

    Vertices are indices in all lists. Two features are the same if nearly all vertices of the first
    lie on the surface of the second. The centre moves to the exact axis; rims and washers stay. CAD
    features that the mesh search did not find are added. walls has all CAD features; their walls
    define slots and rectangles.
    """
    surfaces = [(known, frozenset(known["vertices"])) for known in exact]
    is_found = [False] * len(exact)
    result = []
    for entry in entries:
        for k, (known, vertices) in enumerate(surfaces):
            if _is_same(entry, known, vertices):
                is_found[k] = is_found[k] or entry["kind"] == known["kind"]
                entry = _snapped(entry, known)
                break
        if entry["kind"] in OUTLINES:
            entry = exact_outline(entry, walls)
        if entry["kind"] == "bend":
            entry = _exact_bend(entry, walls)
        result.append(entry)
    return result + [known for known, found in zip(exact, is_found) if not found]


def _is_same(entry: Entry, known: Entry, vertices: frozenset[int]) -> bool:
    nearly_all = 0.9
    # The mesh search also finds the wall of a hole as a cylinder.
    is_wall = entry["kind"] == "cylinder" and known["kind"] == "round hole"
    if entry["kind"] != known["kind"] and not is_wall:
        return False
    return len(vertices.intersection(entry["vertices"])) >= nearly_all * len(entry["vertices"])


def _exact_bend(entry: Entry, walls: list[Entry]) -> Entry:
    """Return a bend with the values of its cylinders: one, or those of both skins."""
    bend = frozenset(entry["vertices"])
    cylinders = [wall for wall in walls if wall["kind"] == "cylinder" and wall["vertices"]]
    skins = [wall for wall in cylinders if bend.issuperset(wall["vertices"])]
    skins.sort(key=lambda skin: float(skin["radius"]))
    if not skins:
        return entry
    depth = {"depth": skins[-1]["radius"] - skins[0]["radius"]} if "depth" in entry else {}
    return {**_snapped(entry, skins[0]), **depth}


def _snapped(entry: Entry, known: Entry) -> Entry:
    numbers = {key: known[key] for key in _NUMBERS if key in known and key in entry}
    center, axis = np.array(known["center"]), np.array(known["axis"])
    away = np.array(entry["center"]) - center
    along = float(away @ axis)
    if entry["kind"] == "plane":
        moved = center + away - along * axis
    else:
        moved = center if entry["kind"] == "sphere" else center + along * axis
    same_way = 1.0 if float(np.dot(axis, entry["axis"])) >= 0.0 else -1.0
    return {**entry, **numbers, "center": moved.tolist(), "axis": (same_way * axis).tolist()}
