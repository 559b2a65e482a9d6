# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hidden object that solves once per recompute for all parts of an assembly."""

from __future__ import annotations

from typing import Any

from freecad.sheetmorph import doors
from freecad.sheetmorph.objects import watcher
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.objects.model import DEFORMATION, PART, assembly_of, kind
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.objects.proxy import Execution, ObjectProxy


class DeformationProxy(ObjectProxy):
    """Proxy of the deformation; results are kept in memory only, always from rest."""

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
        """Make `obj` a deformation that hears of changes of its sources."""
        super().__init__(obj)
        watcher.watch()

    def onDocumentRestored(self, obj) -> None:
        """As a new one."""
        super().onDocumentRestored(obj)
        watcher.watch()

    def cache(self):
        """Return what solves and is kept between two recomputes; a restored proxy has none yet."""
        if self._cache is None:
            self._cache = doors.new_solver()
        return self._cache

    @property
    def fault(self):
        """What the last recompute could not do; None if it has not failed."""
        return self._outcome.failure if self._outcome is not None else None

    @property
    def warnings(self):
        """The warnings of the last recompute, as Faults."""
        return self._outcome.findings.sentences if self._outcome is not None else ()

    execute = Execution()

    def computed(self, obj) -> MorphError | None:
        """Solve for all parts; return what cannot be solved, once for all of them.

        FreeCAD then leaves the parts, and what others have made of them, as they were; they are
        due.
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
