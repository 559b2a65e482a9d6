# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sets of a Nastran deck: SET of the case control, SET1 and SET3 of the bulk data."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ..labels import Labels
from .nastran_cards import bulk_range, cards

_SET = re.compile(r"^\s*SET\s+(\d+)\s*=\s*(.*)$", re.IGNORECASE)
_LARGEST = 100_000_000
# Of SET3: what its ids are of; other kinds are no region of a mesh.
_KINDS = {"GRID": "nodes", "POINT": "nodes", "ELEM": "elements", "ELEMENT": "elements"}


def labels_of(
    lines: list[str], elements: Sequence[int], rows: np.ndarray, nodes: Sequence[int]
) -> Labels:
    """The sets as groups: "SET 3", and "SET 3 nodes" or "SET 3 elements" where both may be meant.

    elements: ids of the shells; rows: (m,) of every triangle the place of its shell among them.
    """
    groups: dict[str, np.ndarray] = {}
    of_nodes: dict[str, list[int]] = {}
    known = set(nodes)
    place = {element: k for k, element in enumerate(elements)}
    for name, kind, wanted in _sets(lines):
        as_elements = [place[i] for i in wanted if i in place] if kind != "nodes" else []
        as_nodes = [i for i in wanted if i in known] if kind != "elements" else []
        plain = "nodes" if len(as_nodes) > len(as_elements) else "elements"
        if as_elements:
            triangles = np.flatnonzero(np.isin(rows, as_elements))
            groups |= _called(name, "elements", plain, triangles)
        if as_nodes:
            of_nodes |= _called(name, "nodes", plain, as_nodes)
    return Labels(groups, of_nodes)


def _called(name: str, kind: str, plain: str, found: object) -> Mapping[str, object]:
    return {f"{name} {kind}": found, **({name: found} if kind == plain else {})}


def _sets(lines: list[str]) -> Iterator[tuple[str, str, list[int]]]:
    """(name, "nodes", "elements" or "" if it is not said, ids)."""
    first, _ = bulk_range(lines)
    text = ""
    for line in lines[:first]:
        body = line.split("$", 1)[0].rstrip()
        text = text + body.strip() if text else body
        if text.endswith(","):
            continue
        if match := _SET.match(text):
            yield f"SET {match.group(1)}", "", _listed(re.split(r"[,\s]+", match.group(2)))
        text = ""
    for card in cards(lines, frozenset({"SET1", "SET3"})):
        skipped = 2 if card.name == "SET3" else 1
        kind = _KINDS.get(card.text(1).upper(), "") if skipped == 2 else ""
        if skipped == 1 or kind:
            fields = [card.text(k) for k in range(skipped, len(card.fields))]
            yield f"SET {card.text(0)}", kind, _listed(fields)


def _listed(words: Sequence[str]) -> list[int]:
    """The ids of a list in which THRU stands between the ends of a range."""
    found: list[int] = []
    is_range = False
    for word in words:
        if word.upper() == "THRU":
            is_range = bool(found)
        elif word.isdigit() and len(word) < 10:
            last = int(word)
            start = found[-1] + 1 if is_range else last
            found += range(start, min(last, start + _LARGEST) + 1)
            is_range = False
        elif word.upper() in ("EXCEPT", "BY"):
            break  # what is left out, or a step: no region can be told from the rest
    return found
