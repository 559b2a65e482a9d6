# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shells of a deck as its parts list shows them: a line for every property."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Ints
from .deck import Deck
from .shells import Sheet


@dataclass(frozen=True)
class Shells:
    """The shells of one property: its number and name ("" if it has none), thickness in mm (0 if
    the deck does not tell), material, and how many elements there are."""

    number: int
    name: str
    thickness: float
    material: str
    elements: int

    @property
    def title(self) -> str:
        """As a tree shows them."""
        thickness = f"{self.thickness:.4g} mm" if self.thickness > 0.0 else "no thickness"
        return " · ".join(filter(None, (self.name, f"PID {self.number}", thickness)))


def thickness_of(deck: Deck, sheet: Sheet, rows: Ints) -> float:
    """The median thickness of the elements of some triangles (k,) of a sheet, mm; 0 if the deck
    does not tell."""
    elements = sheet.elements[rows]
    is_first = np.diff(elements, prepend=-1) != 0
    numbers, counts = np.unique(sheet.properties[rows][is_first], return_counts=True)
    told = [deck.raw.thickness.get(number, 0.0) for number in numbers.tolist()]
    return float(np.median(np.repeat(told, counts))) if len(elements) else 0.0


def shells_of(deck: Deck, sheet: Sheet, rows: Ints) -> list[Shells]:
    """The properties of some triangles (k,) of a sheet, the lowest number first."""
    properties, elements = sheet.properties[rows], sheet.elements[rows]
    raw = deck.raw
    return [
        Shells(
            number,
            raw.names.get(number, ""),
            raw.thickness.get(number, 0.0),
            raw.materials.of(number).name,
            len(np.unique(elements[properties == number])),
        )
        for number in np.unique(properties).tolist()
    ]
