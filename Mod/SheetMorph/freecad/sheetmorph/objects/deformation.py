# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hidden object that solves all parts of an assembly once per recompute."""

from __future__ import annotations

from typing import Any

from freecad.sheetmorph import doors
from freecad.sheetmorph.objects import watcher
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.objects.model import DEFORMATION, PART, assembly_of, kind
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.objects.proxy import Execution, ObjectProxy


class DeformationProxy(ObjectProxy):
    """Proxy of the deformation; results are computed from rest and stay in memory only."""

    Type = DEFORMATION
    PROPERTIES = (
        Property("LinkListGlobal", "Sources", "Morph", "Rest meshes", mode=HIDDEN),
        Property("LinkList", "Regions", "Morph", "Regions of all parts", mode=HIDDEN),
        Property("LinkList", "Relations", "Morph", "Relations of form features", mode=HIDDEN),
        Property("LinkList", "Contacts", "Morph", "Contacts of all parts", mode=HIDDEN),
    )
    _cache: Any = None
    _outcome: Any = None

    def __init__(self, obj):
        """Make `obj` a deformation that is notified of changes of its sources."""
        super().__init__(obj)
        watcher.watch()

    def onDocumentRestored(self, obj) -> None:
        """Watch the sources of a restored deformation."""
        super().onDocumentRestored(obj)
        watcher.watch()

    def cache(self):
        """Return the solver cache, which persists between recomputes; create it if necessary."""
        if self._cache is None:
            self._cache = doors.new_solver()
        return self._cache

    @property
    def fault(self):
        """Fault of the last recompute, empty if it succeeded; None before the first one."""
        return self._outcome.failure if self._outcome is not None else None

    @property
    def warnings(self):
        """The warnings of the last recompute, as Faults."""
        return self._outcome.findings.sentences if self._outcome is not None else ()

    execute = Execution()

    def computed(self, obj) -> MorphError | None:
        """Solve all parts; return a single error for all of them, or None.

        After an error FreeCAD leaves the parts and their dependants unchanged, so the parts are
        touched.
        """
        self._outcome = self.cache().recomputed(assembly_of(obj))
        if self._outcome.failure:
            for part in obj.InList:
                if kind(part) == PART:
                    part.touch()
            return MorphError(self._outcome.failure)
        return None

    def mesh_of(self, obj, part):
        """Return the deformed mesh of `part`, a FreeCAD mesh seen where its source is seen.

        Raises MorphError with the sentence the user reads at the part.
        """
        if self._outcome is None:
            self.execute(obj)
        return self.cache().mesh(self._outcome, part)
