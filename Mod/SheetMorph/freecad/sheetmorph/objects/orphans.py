# SPDX-License-Identifier: LGPL-2.1-or-later
"""Detection of regions, contacts, relations, poses and studies outside a morph, as after a copy."""

from __future__ import annotations

import FreeCAD

from freecad.sheetmorph.kinds import CONTACT, DEFORMATION, POSE, REGION, RELATION, STUDY, kind
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.objects.model import assembly_of
from freecad.sheetmorph.objects.proxy import Execution, ObjectProxy

WORDS = {REGION: "Region", CONTACT: "Contact", RELATION: "Relation"}
WORDS |= {POSE: "Pose", STUDY: "Study"}
PARTS = {REGION: ("Part",), CONTACT: ("PartA", "PartB")}


def fault_of(obj) -> str:
    """Return why an object has no effect, in one sentence; empty if it is in a morph."""
    # the deformation reports its own faults
    is_used = any(kind(user) == DEFORMATION for user in obj.InList)
    if is_used or assembly_of(obj) is not None:
        return ""
    what = f"{WORDS[kind(obj)]} '{obj.Label}'"
    if any(getattr(obj, name, None) is None for name in PARTS.get(kind(obj), ())):
        return (
            f"{what} was copied without its part and does nothing: delete it, then "
            "copy the whole morph or mark it here."
        )
    return f"{what} is not in a morph and does nothing: drag it onto its morph, or delete it."


class MemberProxy(ObjectProxy):
    """Proxy of an object that has an effect only in a morph; elsewhere FreeCAD marks it."""

    execute = Execution()

    def computed(self, obj) -> MorphError | None:
        """Return the fault of an object outside a morph; inside, the morph reads the object."""
        fault = fault_of(obj)
        return MorphError(fault, obj) if fault else None

    def onDocumentRestored(self, obj) -> None:
        """Update an object, and warn at once if it was pasted without its morph."""
        super().onDocumentRestored(obj)
        self.restore(obj)
        fault = fault_of(obj)
        if fault:
            FreeCAD.Console.PrintWarning(f"SheetMorph: {fault}\n")
            obj.touch()

    def restore(self, obj) -> None:
        """Do additional work for an opened or pasted object."""
