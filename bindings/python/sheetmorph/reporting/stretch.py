# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report entries on stretch and bending of the sheet in a pose.

They are kinematic: effects of a press or of friction are not included.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..measuring.strain import areas, curvature_changes, principal_stretches
from ..solving.answer import Answer
from ..solving.preprocessed import Preprocessed

_MOST_PLACES = 10
_APART = 0.05  # Share of the size: minimum distance between listed places.
_NEAR = 0.25  # Share of the size: named regions farther away are not mentioned.
_STRAIGHT = 1e3  # Multiple of the size: bends with a larger radius are ignored.
_YOUNG = 210e3  # N/mm^2, steel
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
    rest, triangles = result.rest.sheets[part], np.asarray(sheet.triangles)
    now = np.asarray(result.deformed.sheet_positions(session.parts.index(part)))
    stretches = principal_stretches(rest, now, triangles)
    sound = np.flatnonzero(np.isfinite(stretches).all(axis=1))
    if not len(sound):
        return None
    triangles, stretches = triangles[sound], stretches[sound]
    area = areas(rest, triangles)
    strain = np.abs(stretches - 1.0).max(axis=1)
    order = np.argsort(strain)
    reached = np.cumsum(area[order]) / area.sum()
    centres = sum(now[corner] for corner in triangles.T) / 3.0
    regions = _regions(result, part)
    return {
        "largest": float(strain.max()),
        "percentile_99": float(strain[order[np.searchsorted(reached, 0.99)]]),
        "share_above_1_percent": float(min(1.0, area[strain > 0.01].sum() / area.sum())),
        "worst": [
            {
                "triangle": int(sound[k]),
                "place": centres[k].tolist(),
                "stretch": stretches[k].tolist(),
                "near": _nearest(regions, centres[k], _NEAR * sheet.size),
            }
            for k in _worst_places(strain, centres, _APART * sheet.size)
        ],
        **_bending(session, part, (rest, now, triangles), (area, strain, stretches)),
    }


def stretch_words(entry: dict[str, Any]) -> Iterator[str]:
    """Yield sentences about the sheet of a part; entry is its report entry."""
    steel, stretch, name = entry["steel"], entry["stretch"], entry["name"]
    if steel["from"] == "a hundredth of the size":
        yield (
            f'"{name}" is bent as a sheet of {steel["thickness"]:.3g} mm, a hundredth of its '
            'size: give its "thickness"'
        )
    if stretch is None:
        return
    bend = stretch["bend"]
    if bend is not None and bend["over_thickness"] < _GENTLE:
        place = ", ".join(f"{x:.4g}" for x in bend["place"])
        yield (
            f'"{name}" is bent most to a radius of {bend["radius"]:.3g} mm, '
            f'{bend["over_thickness"]:.3g} times its thickness, at ({place}); let go, it springs '
            f'back with {stretch["springs_back"]:.3g} mJ'
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


def _bending(
    session: Preprocessed,
    part: str,
    shapes: tuple[Floats, Floats, Ints],
    told: tuple[Floats, Floats, Floats],
) -> dict[str, Any]:
    """Return the entries "bend" and "springs_back"."""
    (rest, now, triangles), (area, _, stretches) = shapes, told
    thickness = session.sheet_thickness(part)
    entry = next(entry for entry in session.model.parts if entry.name == part)
    change = _principal(np.nan_to_num(curvature_changes(rest, now, triangles)))
    tightest = int(np.abs(change).max(axis=1).argmax())
    curvature = float(np.abs(change[tightest]).max())
    size = session.sheet(part).size
    bend = None
    if curvature * size * _STRAIGHT > 1.0:
        place = now[triangles[tightest]].mean(axis=0).tolist()
        radius = 1.0 / curvature
        bend = {"radius": radius, "over_thickness": radius / thickness, "place": place}
    poisson = entry.sheet.poisson
    strains = 0.5 * (stretches**2 - 1.0)
    stored = area @ (
        thickness * _stored(strains, poisson) + thickness**3 / 12.0 * _stored(change, poisson)
    )
    return {"bend": bend, "springs_back": float(0.5 * _YOUNG / (1.0 - poisson**2) * stored)}


def _principal(values: Floats) -> Floats:
    """Return the eigenvalues (m, 2) of symmetric matrices (m, 2, 2), ascending."""
    mean, half = 0.5 * (values[:, 0, 0] + values[:, 1, 1]), values[:, 0, 0] - values[:, 1, 1]
    radius = np.hypot(0.5 * half, values[:, 0, 1])
    return np.stack([mean - radius, mean + radius], axis=1)


def _stored(values: Floats, poisson: float) -> Floats:
    """Return (1 - nu) times the sum of squares plus nu times the squared sum of values (m, 2)."""
    found: Floats = (1.0 - poisson) * (values**2).sum(axis=1) + poisson * values.sum(axis=1) ** 2
    return found


def _worst_places(strain: Floats, centres: Floats, apart: float) -> list[int]:
    found: list[int] = []
    left = np.ones(len(strain), bool)
    while left.any() and len(found) < _MOST_PLACES:
        worst = int(np.where(left, strain, -1.0).argmax())
        found.append(worst)
        left &= np.linalg.norm(centres - centres[worst], axis=1) > apart
        left[worst] = False
    return found


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
