# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sizes of form features: the one requested beside the one measured."""

from __future__ import annotations

from typing import Any

from .answer import Answer
from .arrays import Floats
from .results import FeatureResult


def measured_size(result: Answer, feature: FeatureResult, positions: Floats) -> float | None:
    """Return the size of a feature on positions (n, 3) of its part, mm.

    None if no size is set for it, or if it is no hole, slot or cylinder there.
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
    """Return a sentence for every feature whose measured size is not the requested one.

    tol: mm; what the format of a part's file rounds away is allowed besides.
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
                found.append(f"{name}: {measured:.6g} mm in place of {size:.6g} mm")
    return found
