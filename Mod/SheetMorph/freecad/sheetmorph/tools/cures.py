# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cures for a mesh: which a diagnosis offers, and what they were worth."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from html import escape

from freecad.sheetmorph.tools.words import length

NEEDED = ("weld", "orient", "remesh", "scale")
"""Cures without which a part is not fit to bend."""


FEW = 0.01
"""Slivers of this share of all triangles or fewer do no harm."""


@dataclass(frozen=True)
class Wish:
    """What is asked for: lengths in mm, None for no weld and no remesh."""

    weld: float | None = None
    edge: float | None = None
    rims: str = "polygon"
    scale: float = 1.0
    is_thin: bool = False
    is_split: bool = False

    def changes_mesh(self) -> bool:
        """Whether the mesh is to be another one."""
        return self.weld is not None or self.edge is not None or self.scale != 1.0

    def arguments(self) -> dict:
        """The arguments of `api.prepare` that differ from its defaults."""
        default = asdict(Wish())
        given = {key: value for key, value in asdict(self).items() if value != default[key]}
        return {key: value for key, value in given.items() if not key.startswith("is_")}


def units() -> dict[str, float]:
    """The units that a mesh may be in other than mm, and how many mm each has."""
    from sheetmorph.file_unit import UNITS

    return {name: scale for name, scale in UNITS.items() if scale != 1.0}


def unit_of(diagnosis: dict) -> str:
    """The unit to propose for a mesh that is not in mm: the likeliest one, else metres."""
    unit = diagnosis["unit"]
    likely = [name for name in (unit["guess"], *unit["plausible"]) if name in units()]
    return likely[0] if likely else "m"


def is_needed(diagnosis: dict) -> bool:
    """Whether a part is not fit to bend as it is."""
    few = FEW * diagnosis["triangles"]
    return any(
        finding["cure"] in NEEDED and (finding["cure"] != "remesh" or finding["count"] > few)
        for finding in diagnosis["findings"]
        if finding["finding"] != "long edges"  # where coarse is fine enough, only the eye knows
    )


def offered(diagnosis: dict) -> Wish:
    """The cures that a diagnosis offers."""
    keys: dict = {}
    for finding in diagnosis["findings"]:
        if finding["cure"] != "split":
            keys.update(finding["recipe"] or {})
    edge = (keys.get("remesh") or {}).get("edge")
    is_thin = keys.get("thin") == "auto"
    scale = keys.get("scale", 1.0)
    return Wish(
        keys.get("weld"), edge, scale=scale, is_thin=is_thin, is_split=pieces(diagnosis) > 1
    )


def pieces(diagnosis: dict) -> int:
    """How many pieces there are that nothing connects."""
    return len(diagnosis["components"])


def tolerance_of(diagnosis: dict) -> float:
    """The tolerance to weld with, mm: that of the diagnosis, up to the next full digit."""
    tolerance = diagnosis["tolerance"]
    if not tolerance > 0.0:
        return 0.0
    digit = 10.0 ** math.floor(math.log10(tolerance))
    return float(f"{math.ceil(tolerance / digit - 1e-9) * digit:.0e}")


def with_unit_of(diagnosis: dict, first: dict) -> dict:
    """A diagnosis in another unit, with what the first one says about the unit."""
    unit = [finding for finding in first["findings"] if finding["finding"] == "unit"]
    return {**diagnosis, "findings": unit + diagnosis["findings"]}


def as_text(diagnosis: dict) -> str:
    """A diagnosis as rich text: what the mesh is, and what is the matter."""
    kinds = {"open shell": "an open sheet", "thin solid": "a thin solid", "mixed": "of many kinds"}
    kind = kinds.get(diagnosis["kind"], f"a {diagnosis['kind']}")
    number = diagnosis["triangles"]
    lines = [f"<b>{number:,} triangle{'' if number == 1 else 's'}, {kind}.</b>"]
    lines += [f"&bull; {escape(finding['text'])}" for finding in diagnosis["findings"]]
    if not is_needed(diagnosis):
        lines.append("It is fit to bend as it is.")
    return "<br>".join(lines)


def summary(made) -> str:
    """What a preparation (sheetmorph.PreparedMesh) did, as rich text."""
    from sheetmorph.words import counted, preparation

    done, fresh = made.preparation, made.preparation["remesh"]
    lines = [f"<b>{len(made.triangles):,} triangles</b>, {len(made.points):,} vertices"]
    lines.append(preparation(done))
    if fresh:
        lines.append(
            f"At most {length(fresh['deviation'], 2)} from the facets as they were, "
            f"{length(fresh['flat_deviation'], 1)} on flats"
        )
        if fresh["rims"] == "circle":
            rims = ("rim put on its circle", "rims put on their circles")
            lines.append(counted(fresh["rims_on_circles"], *rims))
    if done["unsettled"]:
        lines.append(escape(done["unsettled"]))
    return "<br>".join(lines)
