# SPDX-License-Identifier: LGPL-2.1-or-later
"""A relation: form features that move as one body, or keep a common axis or their distance."""

from __future__ import annotations

from freecad.sheetmorph.objects.model import RELATION
from freecad.sheetmorph.objects.orphans import MemberProxy
from freecad.sheetmorph.objects.properties import Property

GROUP, COAXIAL, DISTANCE = "group", "coaxial", "distance"
RELATIONS = [GROUP, COAXIAL, DISTANCE]
RELATION_DOC = (
    "Group: the form features move as one rigid body. Coaxial: two share "
    "an axis, and each may move along and about it. Distance: the centres "
    "of two keep their distance"
)


class RelationProxy(MemberProxy):
    """Proxy of a relation, which applies while all its form features exist."""

    Type = RELATION
    PROPERTIES = (
        Property("Enumeration", "Type", "Relation", RELATION_DOC, RELATIONS),
        Property("LinkList", "Features", "Relation", "The form features"),
    )
