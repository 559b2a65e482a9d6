# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several parts in one file, split by connected components or by element properties."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np

from ..base.arrays import Ints
from ..base.errors import InputError, list_ids
from ..base.part_mesh import PartMesh
from ..files import PartFile
from ..files.deck_file import DeckFile


_MOST = 500


class SplitError(InputError):
    """A file that cannot be split as the recipe requires."""


def split_triangles(file: PartFile, way: str) -> dict[str, Ints]:
    """Return triangle indices by part name, without the stem of the file.

    "components" are counted from 1 in the order of their first vertex; in a CAD file they are its
    solids and free shells. "property" uses the property ids of a deck, or their names if the file
    has them. Such parts can share nodes. Raises SplitError.
    """
    mesh = file.mesh
    if way == "components" and file.bodies is not None:
        return file.bodies
    if way == "components":
        return pieces_of(mesh)
    if file.properties is None:
        raise SplitError("only decks have properties", 'use "split": "components"')
    labels = file.properties
    names = _names_of(file, list(dict.fromkeys(labels.tolist())))
    found: dict[str, Ints] = {
        name: np.flatnonzero(labels == label) for label, name in names.items()
    }
    if not isinstance(file, DeckFile):
        _check_apart(mesh, found)
    return found


def _names_of(file: PartFile, labels: list[int]) -> dict[int, str]:
    """Return the unique names of properties; a number replaces a missing or ambiguous name."""
    known = {label: file.property_names.get(label, "").replace("/", "_") for label in labels}
    counts = Counter(known.values())
    numbers = {str(label) for label in labels}
    return {
        label: name if name and counts[name] == 1 and name not in numbers else str(label)
        for label, name in known.items()
    }


def usual_split(file: PartFile) -> str:
    """Return the best way to split a deck, or "" if it is one part or has too many pieces.

    "property" is best if no two properties share a node, otherwise "components".
    """
    for way in ("property", "components"):
        try:
            parts = split_triangles(file, way)
            if way == "property":
                _check_apart(file.mesh, parts)
            count = len(parts)
        except SplitError:
            continue
        if 1 < count <= _MOST:
            return way
    return ""


def pieces_of(mesh: PartMesh) -> dict[str, Ints]:
    """Return the triangle indices of each connected component, named from "1"."""
    labels = _component_labels(len(mesh.points), mesh.triangles)[mesh.triangles[:, 0]]
    return {
        str(k + 1): np.flatnonzero(labels == label)
        for k, label in enumerate(np.unique(labels).tolist())
    }


def _component_labels(count: int, triangles: Ints) -> Ints:
    """Return for each vertex (n,) the smallest vertex index in its component."""
    labels = np.arange(count)
    while True:
        before = labels
        smallest = labels[triangles].min(axis=1)
        labels = labels.copy()
        for corner in range(3):
            np.minimum.at(labels, triangles[:, corner], smallest)
        labels = labels[labels]
        if np.array_equal(labels, before):
            return labels


def _check_apart(mesh: PartMesh, found: dict[str, Ints]) -> None:
    owner = np.full(len(mesh.points), -1)
    for number, rows in enumerate(found.values()):
        vertices = np.unique(mesh.triangles[rows])
        shared = vertices[owner[vertices] >= 0]
        if len(shared):
            what = f"two properties share the vertices {list_ids(mesh.file_ids(shared))}"
            raise SplitError(what, 'use "split": "components"')
        owner[vertices] = number


def part_of(mesh: PartMesh, rows: Ints, name: str) -> tuple[PartMesh, Ints]:
    """Return the mesh of some triangles with file ids, and the indices (k,) of its vertices."""
    vertices, corners = np.unique(mesh.triangles[rows], return_inverse=True)
    part = mesh.restricted(vertices, corners.reshape(-1, 3), name)
    labels = None if mesh.labels is None else mesh.labels.carried(rows)
    return replace(part, labels=labels), vertices
