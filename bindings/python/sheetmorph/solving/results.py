# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion of a form feature, and fidelity of a contact."""

from __future__ import annotations

from dataclasses import dataclass


from ..base.arrays import Floats


@dataclass(frozen=True)
class FeatureResult:
    """Motion of a form feature: p = centre + translation + rotation (p_hat - centre).

    Attributes
    ----------
    rotation : array (3, 3)
        Rotation matrix.
    translation, centre : array (3,)
        mm.
    edge_error : float
        Largest change of an edge vector against the rigid motion, mm (2.4).
    rotation_type : str
        "free", "interpolated" or "prescribed".
    motion : str
        Motion type.
    kind : str or None
        "hole", "slot" or "cylinder" if a size is set.
    size : float or None
        Diameter of a hole, length of a slot or radius of a cylinder, mm; p_hat has this size.
    outline_error : float or None
        Largest distance of the rim from the exact outline, mm, if a size is set.
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
    """Fidelity of a contact between two reached parts.

    Attributes
    ----------
    deviation : float
        Largest distance of a driven vertex of `target` from the best rigid motion of the side on
        `source`, mm.
    gap_change : float
        Largest change of the distance from a vertex of either side to the other part, mm.
    place : list of float or None
        Position (3,) of that vertex, mm; None without vertices.
    region_size : float
        Diagonal of both sides at rest, for comparison, mm.
    """

    name: str
    type: str
    source: str
    target: str
    deviation: float
    gap_change: float
    place: list[float] | None
    region_size: float
