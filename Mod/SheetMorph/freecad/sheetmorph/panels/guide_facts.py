# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facts about the active document for the guide."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.bridge import recipes
from freecad.sheetmorph.bridge.faults import at_fault
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import motion_of
from freecad.sheetmorph.tools.guide import Facts

HIGHLIGHTED = (model.REGION, model.CONTACT)


def read():
    """Return the facts about the active document, and the objects that a failure names."""
    owner = subject.assembly()
    if owner is None:
        return Facts(morphs=len(subject.assemblies())), []
    roles = [region.Role for region in model.regions(owner)]
    failure = model.failure_of(owner)
    faulty = [obj for obj in at_fault(owner, failure) if model.kind(obj) in HIGHLIGHTED]
    primary, joining = recipes.primary_of(owner), recipes.used_contacts(owner)
    names = recipes.names_of(owner)  # labels, made unique
    facts = Facts(
        morphs=1,
        parts=tuple(names[part.Name] for part in model.parts(owner)),
        primary=names[primary.Name] if primary else "",
        edited=edited_in(owner),
        joined=tuple((names[c.PartA.Name], names[c.PartB.Name]) for c in joining),
        is_single=owner.Propagation == "single",
        fixed=roles.count("fixed"),
        features=roles.count("form feature"),
        handles=roles.count("handle"),
        is_moved=any(is_moved(r) for r in model.regions(owner) if r.Role == "handle"),
        failure=failure,
        faulty_role=role_of(faulty[0]) if faulty else "",
    )
    return facts, faulty


def edited_in(owner) -> tuple[str, str]:
    """Return the labels of the first edited source shape and of its part."""
    parts = model.parts(owner)
    changed = (part for part in parts if part.SourceChanged and part.ShapeSource)
    return next(((part.ShapeSource.Label, part.Label) for part in changed), ("", ""))


def role_of(obj) -> str:
    """Return the role of a region, "contact" for a contact."""
    return getattr(obj, "Role", "contact")


def is_moved(handle) -> bool:
    """Return whether a handle is not at rest."""
    return not motion_of(handle).is_rest()
