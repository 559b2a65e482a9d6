# SPDX-License-Identifier: LGPL-2.1-or-later
"""A certificate as one self-contained HTML page with pictures, tables and histograms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.pages import page
from ..measuring.quality import areas, aspect
from ..pictures import SHEET, PictureError, Scene, Sheet, drawn, with_room
from .measuring import Written

_SIZE = (900, 660)
# From shrinking over unchanged to growing.
_SIGNED = ((0.13, 0.35, 0.67), SHEET, (0.70, 0.09, 0.17))
# Edges of more elements than these would hide their colours.
_MOST_EDGES = 5000
_MOST_JOINTS = 40


def page_of(certificate: dict[str, Any], written: dict[str, Written]) -> str:
    """Return the page as HTML."""
    pictures, no_pictures = _pictures(list(written.values()))
    features, parts = certificate["features"], certificate["parts"]
    return page(
        "certifying/page.html",
        **certificate,
        word="passed" if certificate["passed"] else "failed",
        pictures=pictures,
        no_pictures=no_pictures,
        rims=[{**feature, **rim} for feature in features for rim in feature["rims"] or [{}]],
        quality=[{"part": part["name"], **one} for part in parts for one in part["quality"]],
        worst_welds=_worst_welds,
        worst_joints=_worst_joints,
    )


def _worst_welds(deck: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the welds of a deck with the largest changes of their gaps, the largest first."""
    welds = [
        {**weld, "change": max(abs(b - a) for a, b in zip(weld["before"], weld["after"]))}
        for weld in deck["joints"]["welds"]
    ]
    return sorted(welds, key=lambda weld: -float(weld["change"]))[:_MOST_JOINTS]


def _worst_joints(file: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the joints of a file that came apart most for their limits, the worst first."""
    worst = sorted(file["joints"], key=lambda j: -float(j["change"] / max(j["limit"], 1e-30)))
    return worst[:_MOST_JOINTS]


def _pictures(parts: list[Written]) -> tuple[list[tuple[str, bytes]], str]:
    """Return titles and images of the parts, or why there are none."""
    scenes = _scenes(parts) if parts else []
    try:
        return [(scene.title, image) for scene, image in zip(scenes, drawn(scenes))], ""
    except PictureError as error:
        return [], str(error)


def _scenes(parts: list[Written]) -> list[Scene]:
    """Return the parts before, and after in colours; all with the same view and scale."""
    rest, moved = [part.mesh.points for part in parts], [part.places for part in parts]
    looks = Scene([], view=_view(parts), size=_SIZE)
    away = [np.linalg.norm(part.places - part.mesh.points, axis=1) for part in parts]
    away = [one[part.faces[:, :3]].mean(axis=1) for one, part in zip(away, parts)]
    change, shape = [], []
    for part in parts:
        one, two = part.rest.measured(areas), part.now.measured(areas)
        change.append(100.0 * np.divide(two - one, one, out=np.zeros_like(one), where=one > 0.0))
        shape.append(np.log10(part.now.measured(aspect)))
    most = max(float(np.abs(one).max(initial=1e-9)) for one in change)
    signed = replace(looks, ramp=_SIGNED, span=(-most, most))
    before = replace(looks, sheets=_sheets(parts, rest), title="Before")
    after = [
        _coloured(looks, "Displacement, mm", _sheets(parts, moved, away)),
        replace(signed, title="Area change, %", sheets=_sheets(parts, moved, change)),
        _coloured(looks, "Aspect ratio, log10", _sheets(parts, moved, shape)),
    ]
    after = [replace(scene, values=scene.title) for scene in after]
    return [with_room(before, after[0]), *(with_room(scene, before) for scene in after)]


def _coloured(looks: Scene, title: str, sheets: list[Sheet]) -> Scene:
    values = np.concatenate([sheet.values for sheet in sheets])
    span = float(values.min(initial=np.inf)), float(values.max(initial=0.0))
    return replace(looks, title=title, sheets=sheets, span=span)


def _sheets(
    parts: list[Written], places: list[Floats], values: Sequence[Floats | None] = ()
) -> list[Sheet]:
    """Return the parts at some places (n, 3), coloured by values of their elements (m,)."""
    edges = sum(len(part.faces) for part in parts) <= _MOST_EDGES
    return [
        Sheet(place, part.faces, values=value, is_by_face=True, has_edges=edges)
        for place, part, value in zip(places, parts, values or [None] * len(parts))
    ]


def _view(parts: list[Written]) -> tuple[float, float, float]:
    """Return the direction, of several from above, from which the triangles look largest."""
    corners = np.concatenate([part.places[part.mesh.triangles] for part in parts])
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    signs = ((1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    views = [(a * x, b * y, z) for x, y, z in permutations((0.55, 1.0, 0.75)) for a, b in signs]
    return views[int(np.abs(normals @ np.array(views).T).sum(axis=0).argmax())]
