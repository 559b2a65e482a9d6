# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proxies of all our document objects have in common."""

from __future__ import annotations

from collections.abc import Sequence

from freecad.sheetmorph import doors
from freecad.sheetmorph.objects.properties import SCHEMA_VERSION, Property, apply_properties


class Execution:
    """The `execute` that FreeCAD calls: the proxy's method `computed`, which returns a MorphError
    or None. FreeCAD reports the error as one sentence, without a traceback."""

    def __get__(self, proxy, _owner=None):
        """Return the function for one proxy."""
        return doors.without_traceback(proxy.computed)


class ObjectProxy:
    """Data lives in properties; a proxy holds nothing that is saved."""

    Type = ""
    PROPERTIES: Sequence[Property] = ()

    def __init__(self, obj):
        """Make `obj` one of ours: properties, proxy, and a view provider where there is a GUI."""
        obj.Proxy = self
        apply_properties(obj, [SCHEMA_VERSION, *self.PROPERTIES])
        doors.give_looks(obj)

    def onDocumentRestored(self, obj) -> None:
        """Give an object of an earlier version the properties it lacks."""
        apply_properties(obj, [SCHEMA_VERSION, *self.PROPERTIES])

    def dumps(self) -> None:
        """Save nothing (FreeCAD 0.21.2 and later)."""

    def loads(self, _state) -> None:
        """Restore nothing (FreeCAD 0.21.2 and later)."""

    def __getstate__(self) -> None:
        """Save nothing (FreeCAD before 0.21.2)."""

    def __setstate__(self, _state) -> None:
        """Restore nothing (FreeCAD before 0.21.2)."""


def is_settled(obj) -> bool:
    """Whether a change comes from a user or a script, not from opening, copying or undo.

    Then, and only then, other objects may be changed in consequence: while a document is opened
    or a step undone FreeCAD brings back those changes itself.
    """
    document = obj.Document
    busy = document.Restoring or document.Importing or document.Transacting
    return not busy and "Restore" not in obj.State


def make_due(deformation) -> None:
    """Ask for a recompute of a deformation, None for none.

    What is no dependency of it does so itself, in undo too: FreeCAD brings back the value of a
    property then, but tells nobody else that it changed.
    """
    if deformation is not None:
        deformation.touch()
