# SPDX-License-Identifier: LGPL-2.1-or-later
"""The materials of a deck: Young's modulus, Poisson's ratio and density of its shells."""

from __future__ import annotations

from dataclasses import dataclass, field

# Densities of solids in t/mm3, and what others are to it: kg/mm3 with GPa and ms, g/mm3 with MPa
# and ms. The square of the speed is in (mm/s)2 with the first, in (m/s)2 with the others.
_UNITS = ((1e-10, 3e-8, 1.0, 1e-6), (1e-7, 3e-5, 1e-3, 1.0), (1e-4, 3e-2, 1e-6, 1.0))
_SLOWEST, _FASTEST = 100.0, 20000.0


@dataclass(frozen=True)
class Material:
    """name: as people are told it; density: t/mm3; sound: its speed in a sheet of it, m/s."""

    name: str
    density: float
    sound: float


STEEL = Material("steel", 7.85e-9, 5420.0)


@dataclass
class Materials:
    """What a deck says of materials while it is read. A key is what its sections call it by."""

    young: dict[str, float] = field(default_factory=dict)
    poisson: dict[str, float] = field(default_factory=dict)
    density: dict[str, float] = field(default_factory=dict)
    names: dict[str, str] = field(default_factory=dict)
    of_property: dict[int, str] = field(default_factory=dict)

    def of(self, number: int) -> Material:
        """The material of a property, steel if the deck does not tell it in millimetres."""
        key = self.of_property.get(number, "")
        young, density = self.young.get(key, 0.0), self.density.get(key, 0.0)
        poisson = self.poisson.get(key, 0.0)
        if not (0.0 < young < 1e300 and -1.0 < poisson <= 0.5):
            return STEEL
        for low, high, tonnes, metres in _UNITS:
            if low <= density <= high:
                speed = (young / (density * (1.0 - poisson**2)) * metres) ** 0.5
                if _SLOWEST <= speed <= _FASTEST:
                    return Material(self.names.get(key, key), density * tonnes, speed)
        return STEEL
