# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps that a morph still needs, derived from facts about its document."""

from __future__ import annotations

from dataclasses import dataclass, field

from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

DONE, NEXT, AFTER, OPEN = "done", "next", "after", "open"
OPTIONAL, FAULTY = "optional", "faulty"
PARTS, FIXED, FEATURES, CONTACTS, HANDLE, DRAG = STEPS = (
    "parts",
    "fixed",
    "features",
    "contacts",
    "handle",
    "drag",
)
STEP_OF_ROLE = {"fixed": FIXED, "form feature": FEATURES, "handle": HANDLE, "follower": CONTACTS}

NO_DOCUMENT = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide",
    "Import a mesh or CAD file, or select meshes in the tree and create a morph.",
)
MANY_MORPHS = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "This document has several morphs: select one in the tree."
)
NO_PARTS = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "The morph has no part yet: import a file or add a mesh."
)
SOME_PARTS = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Parts: {count}; “{primary}” is deformed first.")
EDITED = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "“{source}” was edited: use Follow Shape to update “{part}”."
)
NO_FIXED = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "Nothing is fixed yet: mark a region that stays in place."
)
SOME_FIXED = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Fixed regions: {count}.")
NO_FEATURES = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide",
    "No hole keeps its shape yet: find all holes, mark the important ones, " "or skip this step.",
)
SOME_FEATURES = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "Form features that keep their exact shape: {count}."
)
ONE_PART = QT_TRANSLATE_NOOP("SheetMorph_Guide", "There is only one part: no contact is needed.")
ONE_FOR_ALL = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "A single control mesh around everything moves all parts."
)
UNREACHED = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide",
    "These parts are not connected to “{primary}” and will not follow: " "{parts}.",
)
SOME_CONTACTS = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Contacts: {count}; they connect all parts.")
NO_HANDLE = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "There is no handle yet: mark a region that you want to move."
)
SOME_HANDLES = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Handles: {count}.")
NOT_READY = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide", "Available after you mark a fixed region and a handle."
)
NOT_MOVED = QT_TRANSLATE_NOOP("SheetMorph_Guide", "Everything is ready: move the handle.")
MOVED = QT_TRANSLATE_NOOP(
    "SheetMorph_Guide",
    "The handle has moved. Move it further, export the parts, save a pose, " "or run a study.",
)


@dataclass(frozen=True)
class Facts:
    """The facts of a document about one morph; the default is an empty document."""

    morphs: int = 0
    parts: tuple[str, ...] = ()  # unique names
    primary: str = ""
    edited: tuple[str, str] = ("", "")  # labels of an edited shape and of the part made from it
    joined: tuple[tuple[str, str], ...] = ()  # names of parts joined by an active contact
    is_single: bool = False  # one control mesh for all parts
    fixed: int = 0
    features: int = 0
    handles: int = 0
    is_moved: bool = False
    failure: str = ""  # the error message of the last recompute if it failed
    faulty_role: str = ""  # role of the region that the failure names, "contact", or empty


@dataclass(frozen=True)
class Step:
    """One step with its state, and its text with gaps for values."""

    key: str
    state: str
    text: str
    values: dict = field(default_factory=dict)


def steps(facts: Facts) -> list[Step]:
    """Return all steps in order; at most one is NEXT, and one AFTER it."""
    found = [
        parts_step(facts),
        counted(FIXED, facts.fixed, NO_FIXED, SOME_FIXED),
        features_step(facts),
        contacts_step(facts),
        counted(HANDLE, facts.handles, NO_HANDLE, SOME_HANDLES),
        drag_step(facts),
    ]
    if facts.failure:
        wrong = STEP_OF_ROLE.get(facts.faulty_role, faulty_step(facts))
        found = [with_failure(step, facts) if step.key == wrong else step for step in found]
    return with_next(found)


def parts_step(facts: Facts) -> Step:
    """Return the step for the parts; it is optional when a source shape has changed."""
    if all(facts.edited):
        return Step(PARTS, OPTIONAL, EDITED, dict(zip(("source", "part"), facts.edited)))
    if facts.parts:
        values = {"count": len(facts.parts), "primary": facts.primary}
        return Step(PARTS, DONE, SOME_PARTS, values)
    if facts.morphs > 1:
        return Step(PARTS, OPEN, MANY_MORPHS)
    return Step(PARTS, OPEN, NO_PARTS if facts.morphs else NO_DOCUMENT)


def counted(key: str, count: int, none: str, some: str) -> Step:
    """Return a step that is done as soon as one object exists."""
    return Step(key, DONE, some, {"count": count}) if count else Step(key, OPEN, none)


def features_step(facts: Facts) -> Step:
    """Return the step for form features, which is optional since a sheet may have no holes."""
    step = counted(FEATURES, facts.features, NO_FEATURES, SOME_FEATURES)
    return step if facts.features else Step(FEATURES, OPTIONAL, step.text)


def contacts_step(facts: Facts) -> Step:
    """Return the step for contacts, done when they connect every part with the primary."""
    if len(facts.parts) < 2:
        return Step(CONTACTS, DONE if facts.parts else OPEN, ONE_PART if facts.parts else NOT_READY)
    if facts.is_single:
        return Step(CONTACTS, DONE, ONE_FOR_ALL)
    lost = unreached(facts)
    if lost:
        values = {"primary": facts.primary, "parts": ", ".join(lost)}
        return Step(CONTACTS, OPTIONAL, UNREACHED, values)
    return Step(CONTACTS, DONE, SOME_CONTACTS, {"count": len(facts.joined)})


def drag_step(facts: Facts) -> Step:
    """Return the step for moving a handle."""
    if not (facts.fixed and facts.handles):
        return Step(DRAG, OPEN, NOT_READY)
    return Step(DRAG, DONE, MOVED) if facts.is_moved else Step(DRAG, OPEN, NOT_MOVED)


def unreached(facts: Facts) -> list[str]:
    """Return the labels of the parts that no chain of contacts connects with the primary."""
    reached, due = {facts.primary}, [facts.primary]
    while due:
        here = due.pop()
        for a, b in facts.joined:
            for near, far in ((a, b), (b, a)):
                if near == here and far not in reached:
                    reached.add(far)
                    due.append(far)
    return [label for label in facts.parts if label not in reached]


def faulty_step(facts: Facts) -> str:
    """Return the step of a failure that names no region."""
    return CONTACTS if facts.faulty_role == "contact" else DRAG


def with_failure(step: Step, facts: Facts) -> Step:
    """Return the step as faulty, with the error message of the recompute."""
    return Step(step.key, FAULTY, "{failure}", {"failure": facts.failure})


def with_next(found: list[Step]) -> list[Step]:
    """Mark the first step that is not done as NEXT.

    If that step is optional, the first required one is AFTER, and the user may continue there. An
    optional step is passed over when a later step is done.
    """
    if any(step.state == FAULTY for step in found):
        return found
    needed = [step.key for step in found if step.state == OPEN][:1]
    has_next = False
    for k, step in enumerate(found):
        is_passed = any(later.state == DONE and later.values for later in found[k + 1 :])
        is_open = step.key in needed or (step.state == OPTIONAL and not is_passed)
        if is_open and (not has_next or step.key in needed):
            state = AFTER if has_next else NEXT
            found[k] = Step(step.key, state, step.text, step.values)
            has_next = True
        if step.key in needed:
            break
    return found
