# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of properties, applied to new objects and again when a document is opened.

Objects of an older document thus get their missing properties.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from freecad.sheetmorph.objects.migrations import VERSION

SHOWN, READ_ONLY, HIDDEN = 0, 1, 2
"""Editor modes of FreeCAD."""


@dataclass(frozen=True)
class Property:
    """A property: FreeCAD's type without `App::Property`, name, group, tooltip, default, mode."""

    type: str
    name: str
    group: str
    doc: str
    default: Any = None  # for an Enumeration its values, the first of which is the default
    mode: int = SHOWN
    is_output: bool = False  # a change does not require a recompute


SCHEMA_DOC = "Version of this object's properties"
SCHEMA_VERSION = Property(
    "Integer", "SchemaVersion", "SheetMorph", SCHEMA_DOC, VERSION, HIDDEN, is_output=True
)


def number_of(obj, name: str) -> float:
    """Return a length, mm, or an angle, degrees, of an object.

    Reading it as an attribute would leak memory, because FreeCAD 0.20 counts its references one too
    high.
    """
    return float(obj.getPropertyByName(name).Value)


def vector_of(obj, name: str) -> tuple[float, float, float]:
    """Return a vector of an object, without attribute access as in `number_of`."""
    return tuple(obj.getPropertyByName(name))


def apply_properties(obj, table: Sequence[Property]) -> None:
    """Add the missing properties of `table` to `obj`, and set all editor modes.

    An enumeration of an older version keeps its value and gets the new choices.
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
