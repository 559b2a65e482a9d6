# SPDX-License-Identifier: LGPL-2.1-or-later
"""The repairs of a mesh that a diagnosis offers, and a summary of their effect."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from html import escape

from freecad.sheetmorph.tools.words import length

NEEDED = ("weld", "orient", "remesh", "scale")
"""The repairs without which a part cannot be deformed well."""


FEW = 0.01
"""The largest share of sliver triangles that does no harm."""


@dataclass(frozen=True)
class Wish:
    """The repairs to make: lengths in mm, None for no weld and no remesh."""

    weld: float | None = None
    edge: float | None = None
    rims: str = "polygon"
    scale: float = 1.0
    is_thin: bool = False
    is_split: bool = False

    def changes_mesh(self) -> bool:
        """Return whether the repairs change the mesh."""
        return self.weld is not None or self.edge is not None or self.scale != 1.0

    def arguments(self) -> dict:
        """Return the arguments of `api.prepare` that differ from its defaults."""
        default = asdict(Wish())
        given = {key: value for key, value in asdict(self).items() if value != default[key]}
        return {key: value for key, value in given.items() if not key.startswith("is_")}


def units() -> dict[str, float]:
    """Return the units other than mm that a mesh may have, with their length in mm."""
    from sheetmorph.base.file_unit import UNITS

    return {name: scale for name, scale in UNITS.items() if scale != 1.0}


def unit_of(diagnosis: dict) -> str:
    """Return the likeliest unit of a mesh that is not in mm, else metres."""
    unit = diagnosis["unit"]
    likely = [name for name in (unit["guess"], *unit["plausible"]) if name in units()]
    return likely[0] if likely else "m"


def is_needed(diagnosis: dict) -> bool:
    """Return whether a part needs a repair before it can be deformed well."""
    few = FEW * diagnosis["triangles"]
    return any(
        finding["cure"] in NEEDED and (finding["cure"] != "remesh" or finding["count"] > few)
        for finding in diagnosis["findings"]
        # only the user can judge whether a coarse mesh is fine enough
        if finding["finding"] != "long edges"
    )


def offered(diagnosis: dict) -> Wish:
    """Return the repairs that a diagnosis offers."""
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
    """Return the number of connected components."""
    return len(diagnosis["components"])


def tolerance_of(diagnosis: dict) -> float:
    """Return the weld tolerance of a diagnosis in mm, rounded up to one significant digit."""
    tolerance = diagnosis["tolerance"]
    if not tolerance > 0.0:
        return 0.0
    digit = 10.0 ** math.floor(math.log10(tolerance))
    return float(f"{math.ceil(tolerance / digit - 1e-9) * digit:.0e}")


def with_unit_of(diagnosis: dict, first: dict) -> dict:
    """Return a diagnosis in another unit with the findings about the unit from the first one."""
    unit = [finding for finding in first["findings"] if finding["finding"] == "unit"]
    return {**diagnosis, "findings": unit + diagnosis["findings"]}


def as_text(diagnosis: dict) -> str:
    """Return a diagnosis as rich text: the kind of mesh and its faults."""
    kinds = {"open shell": "an open sheet", "thin solid": "a thin solid", "mixed": "of mixed kinds"}
    kind = kinds.get(diagnosis["kind"], f"a {diagnosis['kind']}")
    number = diagnosis["triangles"]
    lines = [f"<b>{number:,} triangle{'' if number == 1 else 's'}, {kind}.</b>"]
    lines += [f"&bull; {escape(finding['text'])}" for finding in diagnosis["findings"]]
    if not is_needed(diagnosis):
        lines.append("The mesh is ready to bend.")
    return "<br>".join(lines)


def summary(made) -> str:
    """Return the effect of a preparation (`sheetmorph.PreparedMesh`) as rich text."""
    from sheetmorph.base.words import counted, preparation

    done, fresh = made.preparation, made.preparation["remesh"]
    lines = [f"<b>{len(made.triangles):,} triangles</b>, {len(made.points):,} vertices"]
    lines.append(preparation(done))
    if fresh:
        lines.append(
            f"At most {length(fresh['deviation'], 2)} from the original facets, "
            f"{length(fresh['flat_deviation'], 1)} on flat faces"
        )
        if fresh["rims"] == "circle":
            rims = ("rim fitted to its circle", "rims fitted to their circles")
            lines.append(counted(fresh["rims_on_circles"], *rims))
    if done["unsettled"]:
        lines.append(escape(done["unsettled"]))
    return "<br>".join(lines)
