# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data of a deck for the search: shell materials, and elements between parts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..decks.attachment import pinned_nodes
from ..decks.materials import Material
from ..decks.welds import REACH as WELD_REACH
from ..files.deck_file import DeckFile
from ..measuring.strain import middle_edge
from ..recipe.parts import Source

_JOINING = ("line", "rigid", "constraint", "weld")
# A flexible joint with more vertex pairs is a seam and not a spot.
_MOST_OF_SPOT = 12
_Pair = tuple[str, int, str, int]


class DeckConnection(NamedTuple):
    """Two vertices, by part and index, that elements connect.

    joint is the number of the joint, and is_rigid states whether it contains a rigid body.
    """

    part_a: str
    vertex_a: int
    part_b: str
    vertex_b: int
    joint: int
    is_rigid: bool


def part_material(sources: Sequence[Source]) -> dict[str, Material]:
    """Return for each part of a deck the material of most of its triangles, by default steel."""
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


def deck_connections(source: Source, meshes: Mapping[str, PartMesh]) -> Iterator[DeckConnection]:
    """Yield the elements between the parts of a deck as pairs of vertices.

    Elements that share a node outside the shells form one joint. In a joint every vertex of a part
    is paired with the nearest vertex of each other part. A weld whose nodes do not belong to shells
    joins the nearest vertices of the two nearest parts.
    """
    if not isinstance(source.file, DeckFile):
        return
    places: dict[int, tuple[str, int]] = {}
    for name in source.members:
        for index, node in enumerate(meshes[name].file_ids(range(len(meshes[name].points)))):
            places.setdefault(node, (name, index))
    # Several springs between two nodes, one for each direction, are one connection.
    known: set[_Pair] = set()
    number = 0
    for nodes, is_rigid in _joined(source, places, meshes):
        pairs = [p for p in dict.fromkeys(_pairs(nodes, places, meshes)) if p not in known]
        is_seam = not is_rigid and len(pairs) > _MOST_OF_SPOT
        for pair in pairs:
            known.add(pair)
            yield DeckConnection(*pair, number, is_rigid)
            number += is_seam
        number += not is_seam


def rigid_bodies(source: Source, meshes: Mapping[str, PartMesh]) -> dict[str, list[list[int]]]:
    """Return for each part the vertex indices in each rigid body of the deck, two or more."""
    found: dict[str, list[list[int]]] = {name: [] for name in source.members}
    if not isinstance(source.file, DeckFile):
        return found
    deck, sheet = source.file.deck, source.file.sheet
    blocks = [block for block in deck.elements if block.kind == "rigid"]
    if not blocks:
        return found
    # A node can be joined to a coincident node of the sheet by springs of zero length.
    pinned = pinned_nodes(deck, sheet)
    ends = zip(deck.ids[pinned[:, 0]].tolist(), deck.ids[sheet.nodes[pinned[:, 1]]].tolist())
    on_sheet = dict(ends)
    groups = [
        {on_sheet.get(node, node) for node in row if node}
        for block in blocks
        for row in block.nodes.tolist()
    ]
    for name in source.members:
        row = {n: k for k, n in enumerate(meshes[name].file_ids(range(len(meshes[name].points))))}
        for group in groups:
            inside = sorted(row[node] for node in group if node in row)
            found[name] += [inside] if len(inside) > 1 else []
    return found


def _joined(
    source: Source, places: Mapping[int, tuple[str, int]], meshes: Mapping[str, PartMesh]
) -> list[tuple[list[int], bool]]:
    """Return the sorted shell nodes of each joint, and whether it contains a rigid body."""
    file = source.file
    assert isinstance(file, DeckFile)
    found = [
        (sorted(node for node in group if node in places), is_rigid)
        for group, is_rigid in _groups(file, places.keys())
    ]
    return [
        *((group, is_rigid) for group, is_rigid in found if len(group) > 1),
        *((group, False) for group in _between_sheets(source, places, meshes)),
    ]


def _groups(file: DeckFile, sheet: Collection[int]) -> list[tuple[set[int], bool]]:
    """Return the nodes of elements connected outside the sheet, and whether one is rigid."""
    groups: list[set[int]] = []
    rigid: list[bool] = []
    at_node: dict[int, int] = {}
    for nodes, is_rigid in _elements(file):
        joined = {at_node[n] for n in nodes if n in at_node}
        number = len(groups)
        groups.append(nodes)
        rigid.append(is_rigid)
        for other in joined:
            groups[number] |= groups[other]
            rigid[number] = rigid[number] or rigid[other]
            groups[other] = set()
        at_node |= {node: number for node in groups[number] if node not in sheet}
    return [(group, is_rigid) for group, is_rigid in zip(groups, rigid) if group]


def _elements(file: DeckFile) -> Iterator[tuple[set[int], bool]]:
    """Yield the nodes of every element that can join two parts, and whether it is a rigid body."""
    for block in file.deck.elements:
        if block.kind in _JOINING:
            is_rigid = block.kind == "rigid"
            yield from (({node for node in row if node}, is_rigid) for row in block.nodes.tolist())


def _between_sheets(
    source: Source, places: Mapping[int, tuple[str, int]], meshes: Mapping[str, PartMesh]
) -> Iterator[list[int]]:
    """Yield for every weld without shell nodes the nearest nodes on the two nearest parts."""
    file = source.file
    assert isinstance(file, DeckFile)
    deck = file.deck
    blocks = [block for block in deck.elements if block.kind == "weld"]
    wanted = [row for block in blocks for row in block.nodes.tolist()]
    wanted = [row for row in wanted if any(row) and not any(node in places for node in row)]
    if not wanted:
        return
    reach = WELD_REACH * middle_edge(deck.points[file.sheet.nodes], file.sheet.triangles)
    parts = [(meshes[name], meshes[name].points) for name in source.members]
    trees = [load_kernel().PickingTree(points, mesh.triangles) for mesh, points in parts]
    index = deck.find(np.array([next(node for node in row if node) for row in wanted]))
    for point in source.placement.placed(deck.points[index[index >= 0]]):
        hits = []
        for (mesh, _), tree in zip(parts, trees):
            hit = tree.nearest_point(point)
            if hit is not None and hit.distance <= reach:
                corner = int(np.argmax(hit.barycentric))
                node = mesh.file_ids([mesh.triangles[hit.triangle][corner]])[0]
                hits.append((float(hit.distance), node))
        if len(hits) > 1:
            yield [node for _, node in sorted(hits)[:2]]


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
