# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the guide has to know about the active document."""

from freecad.sheetmorph import subject
from freecad.sheetmorph.bridge import recipes
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools.guide import Facts, named_in


def read():
    """The facts about the active document, and the regions or contacts that a failure names."""
    owner = subject.assembly()
    if owner is None:
        return Facts(morphs=len(subject.assemblies())), []
    roles = [region.Role for region in model.regions(owner)]
    failure = failure_of(owner)
    faulty = named_by(owner, failure)
    primary = recipes.primary_of(owner)
    facts = Facts(
        morphs=1,
        parts=tuple(part.Label for part in model.parts(owner)),
        primary=primary.Label if primary else "",
        joined=tuple((c.PartA.Label, c.PartB.Label) for c in recipes.used_contacts(owner)),
        is_single=owner.Propagation == "single",
        fixed=roles.count("fixed"),
        features=roles.count("form feature"),
        handles=roles.count("handle"),
        is_moved=any(is_moved(r) for r in model.regions(owner) if r.Role == "handle"),
        failure=failure,
        faulty_role=role_of(faulty[0]) if faulty else "",
    )
    return facts, faulty


def failure_of(owner) -> str:
    """What the last recompute said if it failed."""
    failed = [part for part in model.parts(owner) if "Invalid" in part.State]
    return failed[0].getStatusString() if failed else ""


def named_by(owner, failure: str) -> list:
    """The regions and contacts of a morph that a sentence names."""
    found = {obj.Label: obj for obj in [*model.regions(owner), *model.contacts(owner)]}
    return [found[label] for label in named_in(failure, found)]


def role_of(obj) -> str:
    """The role of a region; a contact has none."""
    return getattr(obj, "Role", "contact")


def is_moved(handle) -> bool:
    """Whether a handle is not at rest."""
    return any(recipes.motion_of(handle)["translation"]) or handle.Angle.Value != 0.0
