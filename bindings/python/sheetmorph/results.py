# SPDX-License-Identifier: LGPL-2.1-or-later
"""How one form feature moved, and how well one contact was kept."""

from __future__ import annotations

from dataclasses import dataclass


from .arrays import Floats


@dataclass(frozen=True)
class FeatureResult:
    """How a form feature moved: p = centre + translation + rotation (p_hat - centre).

    rotation is (3, 3); translation and centre are (3,), mm. edge_error is the worst change of an
    edge against the rigid motion, mm (2.4). rotation_type is "free", "interpolated" or
    "prescribed"; motion is its type. If a size is set (mm, else None), p_hat has it: kind is "hole"
    (diameter), "slot" (length) or "cylinder" (radius), and outline_error is the worst distance of
    the rim from the exact outline, mm.
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
