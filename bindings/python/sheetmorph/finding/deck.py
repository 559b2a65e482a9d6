# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a deck tells besides its mesh: materials of shells, elements between parts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ..decks.materials import Material
from ..files.deck_file import DeckFile
from ..part_mesh import PartMesh
from ..recipe.parts import Source

_JOINING = ("line", "rigid", "constraint", "weld")
_Pair = tuple[str, int, str, int]


def part_material(sources: Sequence[Source]) -> dict[str, Material]:
    """By part: the material of most triangles of its shells, for parts of decks; steel where a
    deck does not tell."""
    found = {}
    for source in sources:
        if not isinstance(source.file, DeckFile):
            continue
        corners = source.file.mesh.triangles[:, 0]
        for name, vertices in source.members.items():
            inside = np.zeros(len(source.file.mesh.points), dtype=bool)
            inside[vertices] = True
            numbers, counts = np.unique(
                source.file.sheet.properties[inside[corners]], return_counts=True
            )
            if len(numbers):
                most = int(numbers[counts.argmax()])
                found[name] = source.file.deck.raw.materials.of(most)
    return found


def deck_connections(source: Source, meshes: Mapping[str, PartMesh]) -> Iterator[_Pair]:
    """(part, vertex index, part, vertex index) of the elements between the parts of a deck.

    Elements that meet in a node of no shell are one connection; of it every vertex of one part goes
    with the nearest of each other part.
    """
    if not isinstance(source.file, DeckFile):
        return
    places: dict[int, tuple[str, int]] = {}
    for name in source.members:
        for index, node in enumerate(meshes[name].file_ids(range(len(meshes[name].points)))):
            places[node] = (name, index)
    # Several springs between the same two nodes, one a direction, are one connection.
    yield from dict.fromkeys(
        pair for nodes in _joined(source.file, places) for pair in _pairs(nodes, places, meshes)
    )


def _joined(file: DeckFile, places: Mapping[int, tuple[str, int]]) -> list[list[int]]:
    """The shell nodes of elements that hang together over nodes of no shell, sorted."""
    groups: list[set[int]] = []
    at_node: dict[int, int] = {}
    for nodes in _elements(file):
        joined = {at_node[n] for n in nodes if n in at_node}
        number = len(groups)
        groups.append(nodes)
        for other in joined:
            groups[number] |= groups[other]
            groups[other] = set()
        at_node |= {node: number for node in groups[number] if node not in places}
    found = [sorted(node for node in group if node in places) for group in groups]
    return [group for group in found if len(group) > 1]


def _elements(file: DeckFile) -> Iterator[set[int]]:
    """The nodes of every element that may join two parts."""
    for block in file.deck.elements:
        if block.kind in _JOINING:
            yield from ({node for node in row if node} for row in block.nodes.tolist())


def _pairs(
    nodes: Sequence[int], places: Mapping[int, tuple[str, int]], meshes: Mapping[str, PartMesh]
) -> Iterator[_Pair]:
    by_part: dict[str, list[int]] = defaultdict(list)
    for node in nodes:
        name, index = places[node]
        by_part[name].append(index)
    names = sorted(by_part)
    for k, a in enumerate(names):
        for b in names[k + 1 :]:
            of_a, of_b = np.array(by_part[a]), np.array(by_part[b])
            away = np.linalg.norm(
                meshes[a].points[of_a][:, None] - meshes[b].points[of_b][None], axis=2
            )
            for i in range(len(of_a)):
                yield a, int(of_a[i]), b, int(of_b[away[i].argmin()])
            for j in range(len(of_b)):
                yield a, int(of_a[away[:, j].argmin()]), b, int(of_b[j])
