# SPDX-License-Identifier: LGPL-2.1-or-later
"""How one form feature moved, and how well one contact was kept."""

from __future__ import annotations

from dataclasses import dataclass


from .arrays import Floats


@dataclass(frozen=True)
class FeatureResult:
    """How a form feature moved: p = centre + translation + rotation (p_hat - centre).

    rotation: (3, 3); translation, centre: (3,), mm; edge_error: worst |p_i - p_j - R (p_hat_i -
    p_hat_j)| over its edges, mm (2.4); rotation_type: "free", "interpolated" or "prescribed";
    motion: its type; size: mm, None unless it is set, then kind is "hole" (diameter), "slot"
    (length) or "cylinder" (radius), p_hat has that size, and outline_error is the worst distance of
    its rim from the exact outline, mm.
    """

    name: str
    part: str
    rotation: Floats
    translation: Floats
    centre: Floats
    edge_error: float
    rotation_type: str = "free"
    motion: str = "free"
    kind: str | None = None
    size: float | None = None
    outline_error: float | None = None


@dataclass(frozen=True)
class ContactResult:
    """How well a contact between two reached parts was kept, mm.

    deviation: farthest a driven vertex of `target` is from the best rigid motion of the side on
    `source`; gap_change: worst change of the distance from a vertex of either side to the other
    part; place: where that vertex is, None without vertices; region_size: diagonal of both sides
    at rest, to compare with.
    """

    name: str
    type: str
    source: str
    target: str
    deviation: float
    gap_change: float
    place: list[float] | None
    region_size: float
