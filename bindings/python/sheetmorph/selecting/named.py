# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors by name or kind: groups of the file, found features, vertex ids."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import list_ids
from ..finding.options import HOLES, KINDS
from .chosen import Chosen, SelectorError
from .looked_up import far_remarks
from .part_shape import PartShape

_EQUAL = 1e-9

Told = Mapping[str, Any]


def by_ids(shape: PartShape, told: Told) -> Chosen:
    """Return vertices by their file ids."""
    vertices, missing = shape.mesh.find(told["vertices"])
    if missing:
        what = f'vertices {list_ids(missing)} are not in part "{shape.name}"'
        raise SelectorError(what, f"use its ids, {shape.mesh.describe_ids()}", ("vertices",))
    return shape.of_vertices(vertices)


def by_figure(shape: PartShape, told: Told) -> Chosen:
    """Return the vertices inside a figure that the user drew in a view."""
    if shape.drawn is None:
        what = "only FreeCAD knows the figures drawn in a view"
        raise SelectorError(what, "use vertex ids or another selector", ("drawn",))
    return shape.of_vertices(shape.drawn(told["drawn"]))


def by_group(shape: PartShape, told: Told) -> Chosen:
    """Return the region with a name in the file."""
    wanted = str(told["group"])
    labels = shape.labels
    found = [name for name in labels.names if name == wanted]
    found = found or [name for name in labels.names if name.split(" ", 1)[-1] == wanted]
    lower = wanted.lower()  # names in input decks are not case-sensitive
    found = found or [n for n in labels.names if lower in (n.lower(), n.split(" ", 1)[-1].lower())]
    if not found:
        raise SelectorError(
            f'the file of "{shape.name}" has no group "{wanted}"', _names(labels.names, wanted),
            ("group",),
        )  # fmt: skip
    if len(found) > 1:
        named = " and ".join(f'"{name}"' for name in found)
        raise SelectorError(f'"{wanted}" may be {named}', "write the whole name", ("group",))
    if found[0] in labels.groups:
        return shape.of_triangles(labels.groups[found[0]])
    vertices, _ = shape.mesh.find(labels.nodes[found[0]])
    return shape.of_vertices(vertices)


def _names(names: Sequence[str], wanted: str) -> str:
    if not names:
        return "it has no names at all; use a place, such as face_at or a box"
    near = difflib.get_close_matches(wanted, names, 3, 0.4)
    shown = near or list(names)[:8]
    more = len(names) - len(shown)
    return "names are " + ", ".join(f'"{n}"' for n in shown) + (f" and {more} more" if more else "")


def by_kind(shape: PartShape, told: Told) -> Chosen:
    """Return found features: all of a kind, those in a diameter range, or the nearest one."""
    kind = told["found"]
    if kind not in KINDS:
        near = difflib.get_close_matches(str(kind), KINDS, 1, 0.4)
        raise SelectorError(
            f'"{kind}" is not a kind of feature', f"use {near[0] if near else ', '.join(KINDS)}",
            ("found",),
        )  # fmt: skip
    of_kind = [entry for entry in shape.features if entry["kind"] == kind]
    if not of_kind:
        others = ", ".join(sorted({entry["kind"] for entry in shape.features})) or "nothing"
        raise SelectorError(
            f'no {kind} is found on "{shape.name}"', f"found there: {others}", ("found",)
        )
    if "diameter" in told:
        of_kind = _sized(of_kind, told)
    match: dict[str, Any] = {"selector": "found", "kind": kind, "count": len(of_kind)}
    remarks: list[str] = []
    if "near" in told:
        of_kind, distance, remarks = _nearest(shape, of_kind, told["near"])
        match |= {"count": 1, "distance": distance}
    vertices = np.concatenate([entry["vertices"] for entry in of_kind])
    return replace(shape.of_vertices(vertices), matches=[match], remarks=remarks)


def _sized(entries: list[dict[str, Any]], told: Told) -> list[dict[str, Any]]:
    low, high = sorted(told["diameter"])
    kind = told["found"]
    if not all("radius" in entry for entry in entries):
        raise SelectorError(f"a {kind} has no diameter", "leave it out", ("diameter",))
    sizes = sorted(2.0 * entry["radius"] for entry in entries)
    slack = _EQUAL * high
    kept = [e for e in entries if low - slack <= 2.0 * e["radius"] <= high + slack]
    if not kept:
        shown = ", ".join(dict.fromkeys(f"{size:.4g}" for size in sizes))
        what = f"no {kind} has a diameter from {low:.6g} to {high:.6g} mm"
        raise SelectorError(what, f"those found have {shown} mm", ("diameter",))
    return kept


def _nearest(
    shape: PartShape, entries: list[dict[str, Any]], point: Any
) -> tuple[list[dict[str, Any]], float, list[str]]:
    place = np.array(point, dtype=float)
    gaps = [_distance(shape, entry, place) for entry in entries]
    order = np.argsort(gaps, kind="stable")
    first = gaps[order[0]]
    remarks = far_remarks(shape, "found", first)
    if len(order) > 1 and gaps[order[1]] <= first + shape.slack:
        kind = entries[0]["kind"]
        remarks.append(f"found: two {kind}s are equally near to the point; the first one is used")
    return [entries[order[0]]], float(first), remarks


def _distance(shape: PartShape, entry: dict[str, Any], place: Floats) -> float:
    """Return the distance from a point to the vertices or the centre of a feature.

    The smaller one counts. Features without holes are measured to their triangles.
    """
    to_centre = float(np.linalg.norm(np.array(entry["center"]) - place))
    chosen = shape.of_vertices(np.array(entry["vertices"]))
    rows = np.flatnonzero(chosen.share)
    if entry["kind"] in HOLES or not len(rows):
        away = np.linalg.norm(shape.points[entry["vertices"]] - place, axis=1)
        return min(to_centre, float(away.min()))
    tree = shape.core.PickingTree(shape.points, shape.triangles[rows])
    return float(tree.nearest_point(place).distance)


def holes_in(shape: PartShape, chosen: Chosen) -> int:
    """Count the holes whose rims all lie in a region."""
    return sum(
        bool(chosen.inside[entry["vertices"]].all())
        for entry in shape.features
        if entry["kind"] in HOLES
    )
