# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties as tables: applied when an object is made and again when a document is opened.

A document of an earlier version so gets the properties it lacks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

SHOWN, READ_ONLY, HIDDEN = 0, 1, 2
"""Editor modes of FreeCAD."""


@dataclass(frozen=True)
class Property:
    """One row: FreeCAD's type without `App::Property`, name, group, tooltip, default, mode."""

    type: str
    name: str
    group: str
    doc: str
    default: Any = None  # for an Enumeration the list of values, the first is the default
    mode: int = SHOWN
    is_output: bool = False  # a change does not ask for a recompute


SCHEMA_VERSION = Property(
    "Integer", "SchemaVersion", "SheetMorph", "Version of this object's properties", 1, HIDDEN
)


def number_of(obj, name: str) -> float:
    """Return a length, mm, or an angle, degrees, of an object.

    Read as an attribute, it would stay in memory for ever: FreeCAD 0.20 counts its references one
    too high.
    """
    return float(obj.getPropertyByName(name).Value)


def vector_of(obj, name: str) -> tuple[float, float, float]:
    """Return a vector of an object; not as an attribute, as in `number_of`."""
    return tuple(obj.getPropertyByName(name))


def apply_properties(obj, table: Sequence[Property]) -> None:
    """Add the properties of `table` that `obj` lacks, and set the editor modes of all.

    A choice of an earlier version keeps its value and gets the values it lacks.
    """
    for row in table:
        if row.name not in obj.PropertiesList:
            obj.addProperty(f"App::Property{row.type}", row.name, row.group, row.doc)
            if row.default is not None:
                setattr(obj, row.name, row.default)
        elif row.type == "Enumeration" and obj.getEnumerationsOfProperty(row.name) != row.default:
            chosen = getattr(obj, row.name)
            setattr(obj, row.name, row.default)
            setattr(obj, row.name, chosen)
        obj.setEditorMode(row.name, row.mode)
        if row.is_output:
            obj.setPropertyStatus(row.name, "Output")
