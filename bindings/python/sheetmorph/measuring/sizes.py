# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feature sizes in the report: requested and measured."""

from __future__ import annotations

from typing import Any

from ..base.arrays import Floats, Ints
from ..base.errors import Caution, Subject
from ..base.kernel import load_kernel

NOT_RIGID = "not rigid"
"""Code of a failure of a form feature."""


def measured_size(positions: Floats, triangles: Ints, vertices: Ints) -> float | None:
    """Return the size of a feature with vertices (k,) of a mesh (n, 3), (m, 3), mm.

    Return None if the vertices do not form a hole, slot or cylinder.
    """
    shape = load_kernel().feature_shape(positions, triangles, vertices)
    return None if shape is None else float(shape.size)


def not_rigid(feature: str, part: str, text: str) -> Caution:
    """Return the failure of a form feature that lost its shape or size."""
    return Caution(text, Subject("feature", feature), code=NOT_RIGID, where=f"{feature} on {part}")


def missed_sizes(
    features: list[dict[str, Any]], parts: list[dict[str, Any]], tol: float
) -> list[Caution]:
    """Return a failure for every feature whose measured size differs from the requested one.

    tol is in mm; rounding by the file format is allowed in addition.
    """
    rounding = {part["name"]: 4.0 * (part["file"] or {}).get("error", 0.0) for part in parts}
    found = []
    for entry in features:
        size, measured = entry["size"], entry["measured_size"]
        name = entry["name"], entry["part"]
        if size is not None and measured is None:
            found.append(not_rigid(*name, "its size cannot be measured in this pose"))
        elif size is not None:
            if not abs(measured - size) <= 1e-9 * size + tol + rounding[entry["part"]]:
                found.append(not_rigid(*name, f"{measured:.6g} mm instead of {size:.6g} mm"))
    return found
