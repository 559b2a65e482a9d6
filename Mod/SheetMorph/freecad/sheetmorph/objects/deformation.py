# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hidden object that solves once per recompute for all parts of an assembly."""

from __future__ import annotations

from freecad.sheetmorph import findings
from freecad.sheetmorph.objects.model import DEFORMATION, assembly_of
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.objects.proxy import ObjectProxy
from freecad.sheetmorph.rest import MorphError
from freecad.sheetmorph.session import Outcome, SessionCache


ORPHANED = "The morph of this part was deleted: undo that, or delete the part too."


class DeformationProxy(ObjectProxy):
    """Proxy of the deformation; results are kept in memory only, always from rest."""

    Type = DEFORMATION
    PROPERTIES = (
        Property("LinkListGlobal", "Sources", "Morph", "Rest meshes", mode=HIDDEN),
        Property("LinkList", "Regions", "Morph", "Regions of all parts", mode=HIDDEN),
        Property("LinkList", "Relations", "Morph", "Relations of form features", mode=HIDDEN),
        Property("LinkList", "Contacts", "Morph", "Contacts of all parts", mode=HIDDEN),
    )
    _cache: SessionCache | None = None
    _outcome: Outcome | None = None

    def cache(self) -> SessionCache:
        """Return what is kept between two recomputes; a restored proxy starts without it."""
        if self._cache is None:
            self._cache = SessionCache()
        return self._cache

    def execute(self, obj) -> None:
        """Solve for all parts. A failure is kept: every part then reports it as its own.

        Raising it here would only make FreeCAD skip the parts without a word.
        """
        assembly = assembly_of(obj)
        if assembly is None:
            self._outcome = Outcome(failure=ORPHANED)
            return
        self._outcome = self.cache().solve(assembly)
        findings.show(assembly, self._outcome)

    def mesh_of(self, obj, part):
        """Return the deformed mesh of `part`, a FreeCAD mesh seen where its source is seen.

        Raises MorphError with the sentence the user reads at the part.
        """
        if self._outcome is None:
            self.execute(obj)
        if self._outcome.failure:
            raise MorphError(self._outcome.failure)
        return self.cache().mesh(self._outcome, part)
