# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the search: kinds and tolerances."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .. import _core

HOLES = ("round hole", "slotted hole", "rectangular hole", "hole")
SURFACES = ("plane", "cylinder", "cone", "sphere")
KINDS = (*HOLES, "round edge", *SURFACES, "flange", "bead", "emboss", "bend")
# Features that keep their form on real parts: those with a rim, without outlines.
USUAL_FEATURES = HOLES

ODD_HOLE = "odd hole"
"""The name on the command line for holes that are neither round, slotted nor rectangular."""

CONTACT_KINDS = ("bolt", "weld", "flange", "face", "edge")

# The valid range of every numeric option.
LIMITS = {
    "rings": (0, 20),
    "smallest_radius": (0.0, 1e12),
    "largest_radius": (0.0, 1e12),
    "roundness": (1e-9, 0.3),
    "surface": (1e-9, 0.3),
    "crease_angle": (1.0, 89.0),
    "plane_angle": (0.001, 45.0),
    "smallest_area": (0.0, 1.0),
    "scatter": (0.0, 1e12),
    "gap": (0.0, 1e12),
    "facing_angle": (0.0, 89.0),
    "smallest": (1, 1_000_000),
}

_OF_FEATURES = (
    *("rings", "smallest_radius", "largest_radius", "roundness", "surface"),
    *("crease_angle", "plane_angle", "smallest_area", "scatter"),
)


@dataclass(frozen=True)
class FindOptions:
    """Options of the search for features and contacts; lengths in mm, angles in degrees.

    Parameters
    ----------
    kinds, contact_kinds : tuple of str
        Kinds to keep.
    rings : int
        Washer rings around a hole.
    smallest_radius, largest_radius : float
        Limits for holes.
    roundness : float
        Largest residual of a rim, relative to its radius.
    surface : float
        Largest residual of a cylinder, cone or sphere, relative to its radius.
    crease_angle : float
        A sharper bend is an edge.
    plane_angle : float
        Largest bend inside a plane.
    smallest_area : float
        Smallest area of a surface, relative to its part.
    scatter : float or None
        Standard deviation of measured vertices in one direction; None to estimate it from each
        mesh.
    gap : float or None
        Largest distance of parts in contact, beyond half of both thicknesses; None to propose one.
    facing_angle : float
        Largest angle between surfaces in contact.
    smallest : int
        Fewest vertices of the smaller side.
    one_per_pair : bool
        One contact per pair of parts, not one per location.
    """

    kinds: tuple[str, ...] = KINDS
    contact_kinds: tuple[str, ...] = CONTACT_KINDS
    rings: int = 1
    smallest_radius: float = 0.0
    largest_radius: float = 1e12
    roundness: float = 0.12
    surface: float = 0.01
    crease_angle: float = 35.0
    plane_angle: float = 6.0
    smallest_area: float = 0.004
    scatter: float | None = None
    gap: float | None = None
    facing_angle: float = 35.0
    smallest: int = 3
    one_per_pair: bool = False

    def feature_key(self) -> tuple[float | None, ...]:
        """Return the options that determine which features the kernel finds on a mesh."""
        return tuple(getattr(self, name) for name in _OF_FEATURES)

    def feature_tolerances(self, core: ModuleType) -> _core.FeatureTolerances:
        """Return the options as FeatureTolerances of the kernel."""
        found: _core.FeatureTolerances = core.FeatureTolerances()
        found.washer_rings = int(self.rings)
        found.smallest_radius = float(self.smallest_radius)
        found.largest_radius = float(self.largest_radius)
        found.roundness = float(self.roundness)
        found.surface = float(self.surface)
        found.crease_angle = math.radians(self.crease_angle)
        found.plane_angle = math.radians(self.plane_angle)
        found.smallest_area = float(self.smallest_area)
        found.scatter = -1.0 if self.scatter is None else float(self.scatter)
        return found

    def contact_tolerances(self, core: ModuleType) -> _core.ContactTolerances:
        """Return the options as ContactTolerances of the kernel."""
        found: _core.ContactTolerances = core.ContactTolerances()
        found.gap = -1.0 if self.gap is None else float(self.gap)
        found.facing_angle = math.radians(self.facing_angle)
        found.smallest = int(self.smallest)
        found.joins_pairs = bool(self.one_per_pair)
        return found

    def faults(self) -> list[tuple[str, str]]:
        """Return (what is wrong, what to do) for every number outside its range."""
        found = []
        for name, (least, most) in LIMITS.items():
            value = getattr(self, name)
            if value is not None and not least <= value <= most:
                found.append((f"{name} is {value}", f"give a number from {least:g} to {most:g}"))
        if self.largest_radius < self.smallest_radius:
            found.append(("largest_radius is below smallest_radius", "swap them"))
        return found

    def as_dict(self) -> dict[str, Any]:
        """Return the options by name, for JSON."""
        return {
            key: list(value) if isinstance(value, tuple) else value
            for key, value in dataclasses.asdict(self).items()
        }

    def changed(self, values: dict[str, Any]) -> FindOptions:
        """Return a copy with other values; lists become tuples.

        Raises TypeError for unknown names.
        """
        tuples = {k: tuple(v) if isinstance(v, list) else v for k, v in values.items()}
        return dataclasses.replace(self, **tuples)
