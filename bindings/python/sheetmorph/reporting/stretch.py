# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report entries on stretch and bending of the sheet in a pose.

They are kinematic: effects of a press or of friction are not included.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.words import energy
from ..measuring.stretch import SheetStretch
from ..solving.answer import Answer
from ..solving.preprocessed import Preprocessed

_APART = 0.05  # Share of the size: minimum distance between listed places.
_NEAR = 0.25  # Share of the size: named regions farther away are not mentioned.
_STRAIGHT = 1e3  # Multiple of the size: bends with a larger radius are ignored.
_GENTLE = 500.0  # Thicknesses: with a larger bend radius the skin strain is below 0.1 %.
_TOLD = 5e-4  # Smaller stretches are not reported.


def steel_report(session: Preprocessed, part: str) -> dict[str, Any] | None:
    """Return the entry "steel" of a part: thickness and its source; None for other energies."""
    if session.model.energy != "steel":
        return None
    entry = next(entry for entry in session.model.parts if entry.name == part)
    is_told = session.meshes[part].thickness > 0.0 and not entry.thin
    found = "deck" if is_told else "a hundredth of the size"
    found = "thin solid" if session.thin_solid(part) is not None else found
    return {
        "thickness": session.sheet_thickness(part),
        "from": "recipe" if entry.sheet.thickness else found,
        "poisson": entry.sheet.poisson,
    }


def stretch_report(result: Answer, part: str) -> dict[str, Any] | None:
    """Return the entry "stretch" of a part; None if all triangles are degenerate."""
    session = result.session
    sheet = session.sheet(part)
    now = np.asarray(result.deformed.sheet_positions(session.parts.index(part)))
    found = SheetStretch(result.rest.sheets[part], now, np.asarray(sheet.triangles))
    if not len(found.rows):
        return None
    regions = _regions(result, part)
    return {
        "largest": float(found.strain.max()),
        "percentile_99": found.percentile(0.99),
        "share_above_1_percent": found.share_above(0.01),
        "worst": [
            {
                "triangle": int(found.rows[k]),
                "place": found.centres[k].tolist(),
                "stretch": found.stretches[k].tolist(),
                "near": _nearest(regions, found.centres[k], _NEAR * sheet.size),
            }
            for k in found.worst_places(_APART * sheet.size)
        ],
        **_bending(session, part, found),
    }


def stretch_words(entry: dict[str, Any]) -> Iterator[str]:
    """Yield sentences about the sheet of a part; entry is its report entry."""
    steel, stretch, name = entry["steel"], entry["stretch"], entry["name"]
    if steel["from"] == "a hundredth of the size":
        yield (
            f'"{name}" bends as a sheet of {steel["thickness"]:.3g} mm, a hundredth '
            'of its size: give its "thickness"'
        )
    if stretch is None:
        return
    bend = stretch["bend"]
    if bend is not None and bend["over_thickness"] < _GENTLE:
        place = ", ".join(f"{x:.4g}" for x in bend["place"])
        yield (
            f'"{name}" bends most to a radius of {bend["radius"]:.3g} mm, '
            f"{bend['over_thickness']:.3g} times its thickness, at ({place}); it "
            f"stores {energy(stretch['springs_back'])} of elastic energy"
        )
    if stretch["largest"] < _TOLD:
        return
    worst = stretch["worst"][0]
    near = f", near {worst['near']}" if worst["near"] else ""
    place = ", ".join(f"{x:.4g}" for x in worst["place"])
    yield (
        f'this pose stretches the sheet "{name}" by {100.0 * stretch["largest"]:.1f} % at '
        f'({place}){near}; {100.0 * stretch["share_above_1_percent"]:.0f} % of it by more than 1 %'
    )


def _bending(session: Preprocessed, part: str, found: SheetStretch) -> dict[str, Any]:
    """Return the entries "bend" and "springs_back"."""
    thickness = session.sheet_thickness(part)
    entry = next(entry for entry in session.model.parts if entry.name == part)
    change = np.abs(found.curvature).max(axis=1)
    tightest = int(change.argmax())
    curvature = float(change[tightest])
    bend = None
    if curvature * session.sheet(part).size * _STRAIGHT > 1.0:
        place = found.centres[tightest].tolist()
        radius = 1.0 / curvature
        bend = {"radius": radius, "over_thickness": radius / thickness, "place": place}
    return {"bend": bend, "springs_back": found.stored(thickness, entry.sheet.poisson)}


def _regions(result: Answer, part: str) -> list[tuple[str, Floats]]:
    """Return the named regions of a part as (label, positions (k, 3))."""
    session, words = result.session, {"fixed": "fixed region", "handle": "handle"}
    return [
        (f'{words.get(entry.kind, "feature")} "{entry.name}"', result.positions[part][ids])
        for kind in ("fixed", "handle", "feature")
        for entry in session.model.of_kind(kind)
        if entry.part == part and not entry.is_point
        for ids in [session.region_vertices(entry)]
    ]


def _nearest(regions: list[tuple[str, Floats]], place: Floats, reach: float) -> str | None:
    found = [
        (float(np.linalg.norm(points - place, axis=1).min()), label) for label, points in regions
    ]
    return min(found)[1] if found and min(found)[0] <= reach else None
