# SPDX-License-Identifier: LGPL-2.1-or-later
"""A contact: a weld, bolt or adhesive joint of two parts, through which one follows the other."""

from __future__ import annotations

from freecad.sheetmorph.objects.assembly import join_assembly
from freecad.sheetmorph.objects.migrations import ADVANCED
from freecad.sheetmorph.objects.model import CONTACT
from freecad.sheetmorph.objects.orphans import MemberProxy
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, Property

CONTROL_MESH, TIED, RIGID = "control mesh", "tied", "rigid"
TYPES = [CONTROL_MESH, TIED, RIGID]
TYPE_DOC = (
    "Control mesh: the follower's side bends smoothly with the other side. "
    "Tied: every vertex keeps its place relative to the nearest triangle "
    "of the other side, as *TIE in simulation codes. Rigid: both sides "
    "move as one rigid body, as at a bolt or a spot weld"
)
WHERE_DOC = "Selector of the side; empty if only its vertices are stored"
ACTIVE_DOC = "Off: the contact stays in the document but transfers no motion"
GAP_DOC = "Largest change of the gap between the two sides at the last recompute"
DEVIATION_DOC = (
    "Largest distance of the follower's side from a rigid motion of the "
    "other side; bending shows here"
)
KEPT_DOC = (
    "How well the last recompute kept the contact: largest gap change, and "
    "largest distance of the follower's side from a rigid motion of the "
    "other side"
)
WARNING_DOC = (
    "Why the contact opens or closes too far, and what to do; empty if the contact is fine"
)


class ContactProxy(MemberProxy):
    """Proxy of a contact between vertices of two parts; its direction is automatic."""

    Type = CONTACT
    PROPERTIES = (
        Property("Enumeration", "Type", "Contact", TYPE_DOC, TYPES),
        Property("Bool", "Active", "Contact", ACTIVE_DOC, True),
        Property("LinkHidden", "PartA", "Contact", "Part of the first side", mode=READ_ONLY),
        Property("LinkHidden", "PartB", "Contact", "Part of the second side", mode=READ_ONLY),
        Property("FloatList", "VerticesA", "Contact", "Vertices of the first side", mode=HIDDEN),
        Property("FloatList", "VerticesB", "Contact", "Vertices of the second side", mode=HIDDEN),
        Property("String", "WhereA", ADVANCED, WHERE_DOC, mode=READ_ONLY),
        Property("String", "WhereB", ADVANCED, WHERE_DOC, mode=READ_ONLY),
        Property("String", "Kept", "Result", KEPT_DOC, None, READ_ONLY, is_output=True),
        Property("Distance", "GapChange", "Result", GAP_DOC, None, HIDDEN, is_output=True),
        Property("Distance", "Deviation", "Result", DEVIATION_DOC, None, HIDDEN, is_output=True),
        Property("String", "Warning", "Result", WARNING_DOC, None, READ_ONLY, is_output=True),
    )

    def restore(self, obj) -> None:
        """Add the contact to the morph of its first part."""
        join_assembly(obj, obj.PartA)
