# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of deck elements after a morph: which nodes may slide, and the result."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.errors import Fault, RecipeError
from ..base.part_mesh import PartMesh
from ..files.deck_file import DeckFile
from ..recipe.model import RegionEntry
from ..recipe.parts import Source
from ..solving.answer import Answer
from .criteria import read_criteria
from .sliding import Sliding, Slid, borders_and_creases

Shown = TypeVar("Shown", bound=Answer)

# Degrees. Nodes on sharper edges stay, because they belong to unmarked features.
_CREASE = 30.0


def criteria_of(asked: Any, base: Path) -> str | Path | None:
    """Return the set or the file that the option `repair` names, relative to the folder base."""
    if asked in (None, False):
        return None
    if asked is True:
        return "standard"
    place = base / str(asked)
    return place if place.is_file() else str(asked)


def repaired(result: Shown, sources: list[Source], criteria: str | Path) -> Shown:
    """Slide nodes of the decks in their sheets until the criteria are met; return the new result.

    Its `repairs` describe every part. Raises FileError, and RecipeError if none of the parts is a
    deck.
    """
    wanted = read_criteria(criteria)
    decks = [(s, s.file) for s in sources if isinstance(s.file, DeckFile)]
    if not decks:
        what = "no part of the recipe is a deck"
        raise RecipeError(
            [Fault("repair", what, "leave it out: only elements of decks are repaired")]
        )
    positions, told = dict(result.positions), []
    for source, file in decks:
        for name, vertices in source.members.items():
            faces = file.faces_among(vertices)
            stays = _stays(result, name, faces)
            stays |= _near_joints(file)[vertices]
            triangles = result.session.meshes[name].triangles
            slid = Sliding(positions[name], triangles, faces, stays, wanted.elements).slid()
            told.append(_entry(name, wanted.name, slid, positions[name]))
            positions[name] = slid.places
    return replace(result, positions=positions, repairs=told)


def _entry(name: str, criteria: str, slid: Slid, before: Floats) -> dict[str, Any]:
    way = np.linalg.norm(slid.places - before, axis=1)
    return {
        "part": name,
        "criteria": criteria,
        "failing_before": slid.failing[0],
        "failing_after": slid.failing[1],
        "moved": int((way > 0.0).sum()),
        "farthest": float(way.max(initial=0.0)),
        "off_sheet": slid.off_sheet,
        "rounds": slid.rounds,
    }


def _stays(result: Answer, name: str, faces: Ints) -> Bools:
    """Return which vertices (n,) of a part must not slide.

    These belong to regions, features and contacts, lie on borders and creases, or surround mid-side
    nodes. Vertices of thin solids never slide.
    """
    session = result.session
    mesh = session.meshes[name]
    stays = borders_and_creases(mesh.points, faces, _CREASE)
    if session.thin_solid(name) is not None:
        stays[:] = True
    for region in session.model.all_regions:
        if region.part == name:
            stays[_vertices(region, mesh)] = True
    of_feature = (one.name for one in result.features if one.part == name)
    for feature in of_feature:
        stays[session.feature_vertices(feature)] = True
    # The last entry absorbs the corner -1 of triangles.
    is_corner = np.zeros(len(mesh.points) + 1, dtype=bool)
    is_corner[faces] = True
    odd = mesh.triangles[~is_corner[:-1][mesh.triangles].all(axis=1)]
    stays[odd] = True
    return stays


def _near_joints(file: DeckFile) -> Bools:
    """Return the vertices (n,) of a deck at its joints, and their neighbours.

    Passengers follow the former, and their rotation follows from the latter.
    """
    deck, sheet = file.deck, file.sheet
    used = [block.nodes.ravel() for block in deck.elements if block.kind != "shell"]
    used.append(np.array([node for frame in deck.frames.values() for node in frame.nodes or ()]))
    found = np.isin(deck.ids[sheet.nodes], np.concatenate(used))
    found[file.passengers.holding()] = True
    found[sheet.triangles[found[sheet.triangles].any(axis=1)]] = True
    return found


def _vertices(region: RegionEntry, mesh: PartMesh) -> Ints:
    if region.is_point:
        found: Ints = mesh.triangles[region.on_triangle[0]]
        return found
    return mesh.find(region.vertices or [], region.is_prepared)[0]
