# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feature sizes in the report: requested and measured."""

from __future__ import annotations

from typing import Any

from .answer import Answer
from .arrays import Floats
from .results import FeatureResult


def measured_size(result: Answer, feature: FeatureResult, positions: Floats) -> float | None:
    """Return the size of a feature on positions (n, 3) of its part, mm.

    Return None if no size is set, or if the vertices do not form a hole, slot or cylinder.
    """
    if feature.size is None:
        return None
    session = result.session
    vertices = session.feature_vertices(feature.name)
    triangles = session.meshes[feature.part].triangles
    shape = session.core.feature_shape(positions, triangles, vertices)
    return None if shape is None else float(shape.size)


def missed_sizes(
    features: list[dict[str, Any]], parts: list[dict[str, Any]], tol: float
) -> list[str]:
    """Return a sentence for every feature whose measured size differs from the requested one.

    tol is in mm; rounding by the file format is allowed in addition.
    """
    rounding = {part["name"]: 4.0 * (part["file"] or {}).get("error", 0.0) for part in parts}
    found = []
    for entry in features:
        size, measured = entry["size"], entry["measured_size"]
        name = f"{entry['name']} on {entry['part']}"
        if size is not None and measured is None:
            found.append(f"{name}: its size cannot be measured in this pose")
        elif size is not None:
            if not abs(measured - size) <= 1e-9 * size + tol + rounding[entry["part"]]:
                found.append(f"{name}: {measured:.6g} mm instead of {size:.6g} mm")
    return found
