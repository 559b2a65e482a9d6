# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shells of a deck for the list of parts, one entry per property."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.arrays import Ints
from .deck import Deck
from .shells import Sheet


@dataclass(frozen=True)
class Shells:
    """The shells of one property.

    name is "" if it has none. thickness is in mm, 0 if the deck does not give it. elements is their
    number.
    """

    number: int
    name: str
    thickness: float
    material: str
    elements: int

    @property
    def title(self) -> str:
        """The title in a tree."""
        thickness = f"{self.thickness:.4g} mm" if self.thickness > 0.0 else "no thickness"
        return " · ".join(filter(None, (self.name, f"PID {self.number}", thickness)))


def thickness_of(deck: Deck, sheet: Sheet, rows: Ints) -> float:
    """Return the median thickness of the elements of triangles (k,), mm; 0 if not given."""
    elements = sheet.elements[rows]
    is_first = np.diff(elements, prepend=-1) != 0
    numbers, counts = np.unique(sheet.properties[rows][is_first], return_counts=True)
    told = [deck.raw.thickness.get(number, 0.0) for number in numbers.tolist()]
    return float(np.median(np.repeat(told, counts))) if len(elements) else 0.0


def shells_of(deck: Deck, sheet: Sheet, rows: Ints) -> list[Shells]:
    """Return the properties of triangles (k,) of a sheet in ascending order."""
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
