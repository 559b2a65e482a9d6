# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of the proxies of our document objects."""

from __future__ import annotations

from collections.abc import Sequence

from freecad.sheetmorph import doors
from freecad.sheetmorph.objects.migrations import migrate
from freecad.sheetmorph.objects.properties import SCHEMA_VERSION, Property, apply_properties


class Execution:
    """The `execute` of a proxy: it calls `computed`, which returns a MorphError or None.

    FreeCAD then reports the error as one sentence without a traceback.
    """

    def __get__(self, proxy, _owner=None):
        """Return the function for one proxy."""
        return doors.without_traceback(proxy.computed)


class ObjectProxy:
    """Base class of the proxies; all saved data is in properties, none in the proxy."""

    Type = ""
    PROPERTIES: Sequence[Property] = ()

    def __init__(self, obj):
        """Give `obj` its properties, its proxy and, with a GUI, its view provider."""
        obj.Proxy = self
        apply_properties(obj, [SCHEMA_VERSION, *self.PROPERTIES])
        doors.give_looks(obj)

    def onDocumentRestored(self, obj) -> None:
        """Bring an object of an older version up to date."""
        migrate(obj)
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
    """Return whether a change comes from a user or a script, not from opening, copying or undo.

    Only then may other objects be changed as a consequence, because FreeCAD restores their changes
    when it opens a document or undoes a step.
    """
    document = obj.Document
    busy = document.Restoring or document.Importing or document.Transacting
    return not busy and "Restore" not in obj.State


def make_due(deformation) -> None:
    """Request a recompute of a deformation, which may be None.

    Objects that are not its dependencies call this, also during undo. FreeCAD then restores
    property values without notifying other objects.
    """
    if deformation is not None:
        deformation.touch()
