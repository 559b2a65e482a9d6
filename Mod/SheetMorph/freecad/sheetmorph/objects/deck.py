# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deck of imported parts, and the shells of one of its properties in a part."""

from __future__ import annotations

import numpy as np

from freecad.sheetmorph.kinds import DECK, SHELLS
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, Property, number_of
from freecad.sheetmorph.objects.proxy import ObjectProxy

JOINTS = ["refuse", "tell"]
JOINTS_DOC = (
    "What an export does if a joint of the deck comes apart. Refuse: it "
    "writes nothing. Tell: it reports the joint"
)


class DeckProxy(ObjectProxy):
    """Proxy of a deck: the file with all its includes, which Export Parts writes again."""

    Type = DECK
    PROPERTIES = (
        Property("String", "FileName", "Deck", "The file", "", READ_ONLY),
        Property("String", "Format", "Deck", "Solver format", "", READ_ONLY),
        Property("Integer", "Nodes", "Deck", "Number of nodes", mode=READ_ONLY),
        Property("Integer", "Elements", "Deck", "Number of elements", mode=READ_ONLY),
        Property("Enumeration", "BrokenJoints", "Deck", JOINTS_DOC, JOINTS),
        Property(
            "FileIncluded",
            "FileData",
            "Deck",
            "The file, packed together with its includes",
            mode=HIDDEN,
        ),
        Property("String", "Split", "Deck", "How it was split into parts", "", HIDDEN),
        Property("String", "Settings", "Deck", "Passengers and joints, as JSON", "", HIDDEN),
    )

    def execute(self, _obj) -> None:
        """Do nothing: a deck is only stored."""


class ShellsProxy(ObjectProxy):
    """Proxy of the shells of one property."""

    Type = SHELLS
    PROPERTIES = (
        Property("Integer", "Number", "Shells", "The property, part or set (PID)", mode=READ_ONLY),
        Property("String", "Title", "Shells", "Name in the deck", "", READ_ONLY),
        Property(
            "Length", "Thickness", "Shells", "Thickness; 0: not given in the deck", mode=READ_ONLY
        ),
        Property("String", "Material", "Shells", "Name in the deck", "", READ_ONLY),
        Property("Integer", "Elements", "Shells", "Number of elements", mode=READ_ONLY),
        Property("LinkHidden", "Part", "Shells", "The part with these elements", mode=HIDDEN),
    )

    def execute(self, _obj) -> None:
        """Do nothing: these objects only display data."""


def told_thickness(part) -> float:
    """Return the median shell thickness of a part from its deck, mm; 0 if there is none.

    The package uses the same value if a recipe has no thickness.
    """
    thicknesses = [number_of(shells, "Thickness") for shells in part.Shells]
    counts = [shells.Elements for shells in part.Shells]
    return float(np.median(np.repeat(thicknesses, counts))) if sum(counts) else 0.0
