# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that came into a document without the morph they belong to."""

from __future__ import annotations

import FreeCAD

from freecad.sheetmorph.kinds import CONTACT, DEFORMATION, POSE, REGION, RELATION, STUDY, kind
from freecad.sheetmorph.objects.errors import MorphError
from freecad.sheetmorph.objects.model import assembly_of

WORDS = {REGION: "Region", CONTACT: "Contact", RELATION: "Relation"}
WORDS |= {POSE: "Pose", STUDY: "Study"}
PARTS = {REGION: ("Part",), CONTACT: ("PartA", "PartB")}


def fault_of(obj) -> str:
    """Return why an object does nothing, one sentence; empty if it is in a morph."""
    is_used = any(kind(user) == DEFORMATION for user in obj.InList)  # which says what is wrong
    if is_used or assembly_of(obj) is not None:
        return ""
    what = f"{WORDS[kind(obj)]} '{obj.Label}'"
    if any(getattr(obj, name, None) is None for name in PARTS.get(kind(obj), ())):
        return (
            f"{what} came without its part and does nothing: delete it, and copy the whole morph "
            "or mark it here."
        )
    return f"{what} is in no morph and does nothing: drag it onto its morph, or delete it."


def require_morph(obj) -> None:
    """Raise MorphError for an object in no morph: FreeCAD marks it in the tree."""
    fault = fault_of(obj)
    if fault:
        raise MorphError(fault)


def tell(obj) -> None:
    """Say at once in the report view that an object was pasted without its morph."""
    fault = fault_of(obj)
    if fault:
        FreeCAD.Console.PrintWarning(f"SheetMorph: {fault}\n")
        obj.touch()
