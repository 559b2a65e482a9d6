# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the Radioss starter blocks that SheetMorph reads; all columns are defined here."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Field:
    """A field, or several adjacent ones of equal width.

    line is the data line of the block or element from 0, and a title counts. begin is the first
    column from 0. width is in characters, and count the number of fields.
    """

    line: int
    begin: int
    width: int
    count: int = 1


def _element(count: int) -> dict[str, tuple[Field, ...]]:
    """Return the fields of an element on one line: its id, then its nodes."""
    return {"id": (Field(0, 0, 10),), "nodes": (Field(0, 10, 10, count),)}


def _long_element(*counts: int) -> dict[str, tuple[Field, ...]]:
    """Return the fields of an element with its id on one line and nodes on further lines."""
    nodes = tuple(Field(1 + k, 0, 10, count) for k, count in enumerate(counts))
    return {"id": (Field(0, 0, 10),), "nodes": nodes}


# Kind of each element.
ELEMENTS = {
    "SHELL": "shell", "SH3N": "shell", "QUAD": "solid", "TRIA": "solid", "BRICK": "solid",
    "TETRA4": "solid", "PENTA6": "solid", "SPRING": "line", "BEAM": "line", "TRUSS": "line",
    "XELEM": "line", "SHEL16": "solid", "TETRA10": "solid", "BRIC20": "solid",
}  # fmt: skip
_SHELL_PROPERTY: dict[str, tuple[Field, ...]] = {"thickness": (Field(3, 20, 20),)}
BLOCKS: dict[str, dict[str, tuple[Field, ...]]] = {
    "BEGIN": {"version": (Field(1, 0, 10),)},
    "NODE": {"id": (Field(0, 0, 10),), "point": (Field(0, 10, 20, 3),)},
    "SHELL": _element(4),
    "SH3N": _element(3),
    "QUAD": _element(4),
    "TRIA": _element(3),
    "BRICK": _element(8),
    "TETRA4": _element(4),
    "PENTA6": _element(6),
    "SPRING": _element(3),
    "BEAM": _element(3),
    "TRUSS": _element(2),
    "XELEM": {"id": (Field(0, 0, 10),), "group": (Field(0, 10, 10),)},
    "SHEL16": _long_element(8, 8),
    "TETRA10": _long_element(10),
    "BRIC20": _long_element(8, 8, 4),
    "PART": {"property": (Field(1, 0, 10),), "thickness": (Field(1, 30, 20),)},
    "PROP/SHELL": _SHELL_PROPERTY,
    "PROP/SH_ORTH": _SHELL_PROPERTY,
    "PROP/SH_COMP": _SHELL_PROPERTY,
    "RBODY": {"main": (Field(1, 0, 10),), "group": (Field(1, 60, 10),)},
    "GRNOD": {"members": (Field(1, 0, 10, 10),)},  # continued in every further line
    "//SUBMODEL": {"offsets": (Field(1, 0, 10, 6),)},
}
# Alternative names of blocks.
ALIASES = {"TYPE1": "SHELL", "TYPE9": "SH_ORTH", "TYPE10": "SH_COMP"}


def field(block: str, name: str) -> Field:
    """Return the first location of a field."""
    return BLOCKS[block][name][0]


def texts(line: str, place: Field) -> list[str]:
    """Return the texts of adjacent fields in a line."""
    begins = (place.begin + k * place.width for k in range(place.count))
    return [line[begin : begin + place.width] for begin in begins]
