# SPDX-License-Identifier: LGPL-2.1-or-later
"""The materials of a deck: Young's modulus, Poisson's ratio and density of its shells."""

from __future__ import annotations

from dataclasses import dataclass, field

# Range of densities, and factors for density and squared speed, in three unit systems: t/mm3 with
# MPa and s, kg/mm3 with GPa and ms, g/mm3 with MPa and ms. The squared speed of sound is in (mm/s)2
# with the first and in (m/s)2 with the others.
_UNITS = ((1e-10, 3e-8, 1.0, 1e-6), (1e-7, 3e-5, 1e-3, 1.0), (1e-4, 3e-2, 1e-6, 1.0))
_SLOWEST, _FASTEST = 100.0, 20000.0


@dataclass(frozen=True)
class Material:
    """A material: display name, density in t/mm3, and speed of sound in a sheet in m/s."""

    name: str
    density: float
    sound: float


STEEL = Material("steel", 7.85e-9, 5420.0)


@dataclass
class Materials:
    """The materials of a deck while it is read; keys are the ids in its sections."""

    young: dict[str, float] = field(default_factory=dict)
    poisson: dict[str, float] = field(default_factory=dict)
    density: dict[str, float] = field(default_factory=dict)
    names: dict[str, str] = field(default_factory=dict)
    of_property: dict[int, str] = field(default_factory=dict)

    def of(self, number: int) -> Material:
        """Return the material of a property, or steel if its units do not fit millimetres."""
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
