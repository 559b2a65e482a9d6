# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Nastran deck tells besides its mesh: thickness of shells, elements between parts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ..files.nastran import NastranFile
from ..files.nastran_cards import Card, cards
from ..files.nastran_number import parse_real
from ..part_mesh import PartMesh
from ..recipe.parts import Source

# Where the nodes of an element with two of them stand among its fields.
_TWO_NODES = {
    "CELAS1": (2, 4),
    "CELAS2": (2, 4),
    "CBAR": (2, 3),
    "CBEAM": (2, 3),
    "CBUSH": (2, 3),
    "CROD": (2, 3),
    "CONROD": (1, 2),
    "RBAR": (1, 2),
    "RROD": (1, 2),
}
_ELEMENTS = frozenset({*_TWO_NODES, "RBE2", "RBE3"})

_Pair = tuple[str, int, str, int]


def part_thickness(sources: Sequence[Source]) -> dict[str, float]:
    """By part: the median thickness of its shells, for parts of decks that give one."""
    found = {}
    for source in sources:
        if not isinstance(source.file, NastranFile):
            continue
        by_property = _shell_thickness(source.file)
        values = np.array([by_property.get(int(p), 0.0) for p in source.file.properties])
        corners = source.file.mesh.triangles[:, 0]
        for name, vertices in source.members.items():
            inside = np.zeros(len(source.file.mesh.points), dtype=bool)
            inside[vertices] = True
            of_part = values[inside[corners]]
            found[name] = float(np.median(of_part)) if len(of_part) else 0.0
    return found


def _shell_thickness(file: NastranFile) -> dict[int, float]:
    found = {}
    for card in cards(file.lines, frozenset({"PSHELL"})):
        number, thickness = _integer(card.text(0)), parse_real(card.text(2) or "0.")
        if number is not None and thickness:
            found[number] = float(thickness)
    return found


def deck_connections(source: Source, meshes: Mapping[str, PartMesh]) -> Iterator[_Pair]:
    """(part, vertex index, part, vertex index) of the elements between the parts of a deck.

    Elements that meet in a node of no shell are one connection; of it every vertex of one part goes
    with the nearest of each other part.
    """
    if not isinstance(source.file, NastranFile):
        return
    places: dict[int, tuple[str, int]] = {}
    for name in source.members:
        for index, node in enumerate(meshes[name].file_ids(range(len(meshes[name].points)))):
            places[node] = (name, index)
    # Several springs between the same two nodes, one a direction, are one connection.
    yield from dict.fromkeys(
        pair for nodes in _joined(source.file, places) for pair in _pairs(nodes, places, meshes)
    )


def _joined(file: NastranFile, places: Mapping[int, tuple[str, int]]) -> list[list[int]]:
    """The shell nodes of elements that hang together over nodes of no shell, sorted."""
    groups: list[set[int]] = []
    at_node: dict[int, int] = {}
    for card in cards(file.lines, _ELEMENTS):
        nodes = set(_nodes(card))
        joined = {at_node[n] for n in nodes if n in at_node}
        number = len(groups)
        groups.append(nodes)
        for other in joined:
            groups[number] |= groups[other]
            groups[other] = set()
        at_node |= {node: number for node in groups[number] if node not in places}
    found = [sorted(node for node in group if node in places) for group in groups]
    return [group for group in found if len(group) > 1]


def _nodes(card: Card) -> list[int]:
    if card.name in _TWO_NODES:
        texts = [card.text(place) for place in _TWO_NODES[card.name]]
    elif card.name == "RBE2":
        texts = [card.text(1), *(field.text.strip() for field in card.fields[3:])]
    else:  # RBE3: reference node, then weights (real), components and nodes (whole numbers)
        texts = [card.text(2)]
        is_component = False
        for field in card.fields[4:]:
            text = field.text.strip()
            if text.upper() in ("UM", "ALPHA"):
                break
            is_weight = "." in text
            if text and not is_weight and not is_component:
                texts.append(text)
            is_component = is_weight
    numbers = [_integer(text) for text in texts]
    return [number for number in numbers if number is not None and number > 0]


def _integer(text: str) -> int | None:
    try:
        return int(text)
    except ValueError:
        return None


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
