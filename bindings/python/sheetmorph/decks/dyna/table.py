# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the LS-DYNA cards that SheetMorph reads; all positions are defined here.

All fields of a card have one width, except coordinates. The widths depend on the format: standard,
`i10=y`, `long=y`.
"""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Widths:
    """Field widths in characters: ids in nodes and elements, other fields, coordinates."""

    label: int
    other: int
    real: int


STANDARD, TEN, LONG = Widths(8, 10, 16), Widths(10, 10, 16), Widths(20, 20, 20)


@dataclass(frozen=True)
class Field:
    """A field, or several adjacent fields.

    card is that of the keyword or element from 0, without titles and `_ID` cards. at is the field
    number in the card from 0. count is the number of fields.
    """

    card: int
    at: int
    count: int = 1


# Fields of these cards are as wide as ids of nodes and elements.
NODE = {"id": Field(0, 0), "point": Field(0, 1, 3)}


@dataclass(frozen=True)
class Element:
    """An element type.

    kind is its kind and nodes the location of its nodes. part is the location of its part, or None.
    options maps each option to the number of cards that it adds.
    """

    kind: str
    nodes: Field
    options: dict[str, int] = field(default_factory=dict)
    part: Field | None = Field(0, 1)


# Options that share one card.
SHARED = {"THICKNESS": 1, "BETA": 1, "MCID": 1}
ELEMENTS = {
    "SHELL": Element(
        "shell", Field(0, 2, 8), {**SHARED, "OFFSET": 1, "DOF": 1, "SHL4_TO_SHL8": 0}
    ),
    "TSHELL": Element("solid", Field(0, 2, 8), {"BETA": 1}),
    "SOLID": Element(
        "solid", Field(0, 2, 8), {"ORTHO": 2, "DOF": 2, "TET4TOTET10": 0, "H8TOH20": 0}
    ),
    "BEAM": Element(
        "line", Field(0, 2, 3),
        {"THICKNESS": 1, "SECTION": 1, "SCALAR": 1, "SCALR": 1, "PID": 1, "OFFSET": 1,
         "ORIENTATION": 1},
    ),
    "MASS": Element("mass", Field(0, 1), part=None),
    "INERTIA": Element("mass", Field(0, 1), {"OFFSET": 1}, part=None),
    "DISCRETE": Element("line", Field(0, 2, 2), {"LCO": 1}),
    "SEATBELT": Element("line", Field(0, 2, 2)),
    "PLOTEL": Element("line", Field(0, 1, 2), part=None),
}  # fmt: skip
# Solids with their nodes in separate cards, ten per card.
SOLID_NODES = Field(1, 0, 10)
CARDS: dict[str, dict[str, Field]] = {
    "CONSTRAINED_SPOTWELD": {"nodes": Field(0, 0, 2)},
    "CONSTRAINED_RIVET": {"nodes": Field(0, 0, 2)},
    "CONSTRAINED_JOINT": {"nodes": Field(0, 0, 6)},
    "CONSTRAINED_NODAL_RIGID_BODY": {"id": Field(0, 0), "set": Field(0, 2), "main": Field(0, 3)},
    "CONSTRAINED_EXTRA_NODES_NODE": {"id": Field(0, 0), "nodes": Field(0, 1)},
    "CONSTRAINED_EXTRA_NODES_SET": {"id": Field(0, 0), "set": Field(0, 1)},
    "CONSTRAINED_NODE_SET": {"id": Field(0, 0), "set": Field(0, 0)},
    "CONSTRAINED_GENERALIZED_WELD": {"id": Field(0, 0), "set": Field(0, 0)},
    "DEFINE_COORDINATE_NODES": {"id": Field(0, 0), "nodes": Field(0, 1, 3)},
    "SET": {"id": Field(0, 0), "members": Field(1, 0, 8)},  # continued in every further card
    "PART": {"id": Field(0, 0), "section": Field(0, 1), "material": Field(0, 2)},
    "SECTION_SHELL": {
        "id": Field(0, 0), "points": Field(0, 3), "angles": Field(0, 6), "thickness": Field(1, 0),
    },
    "MAT": {
        "id": Field(0, 0), "density": Field(0, 1), "young": Field(0, 2), "poisson": Field(0, 3),
    },
}  # fmt: skip
