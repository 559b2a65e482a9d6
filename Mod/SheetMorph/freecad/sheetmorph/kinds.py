# SPDX-License-Identifier: LGPL-2.1-or-later
"""The types of document objects, without imports, so that start-up may use them."""

ASSEMBLY = "SheetMorph::Assembly"
CONTACT = "SheetMorph::Contact"
DECK = "SheetMorph::Deck"
DEFORMATION = "SheetMorph::Deformation"
PART = "SheetMorph::Part"
POSE = "SheetMorph::Pose"
REGION = "SheetMorph::Region"
RELATION = "SheetMorph::Relation"
SHELLS = "SheetMorph::Shells"
STUDY = "SheetMorph::Study"
ALL = (ASSEMBLY, CONTACT, DECK, DEFORMATION, PART, POSE, REGION, RELATION, SHELLS, STUDY)


def kind(obj) -> str:
    """Return the type of a SheetMorph object, an empty string for any other."""
    found = str(getattr(getattr(obj, "Proxy", None), "Type", ""))
    return found if found in ALL else ""
