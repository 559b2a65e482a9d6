# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands need: how they find it, and what the user must do first without it."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from freecad.sheetmorph import subject
from freecad.sheetmorph.kinds import CONTACT
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP


MOMENT = 0.005  # s; Chosen: longer than FreeCAD takes to ask all commands, shorter than it rests
_answers: dict[Need, tuple[float, str]] = {}  # with the time until which they hold, s


@dataclass(frozen=True, eq=False)
class Need:
    """A target of commands; `find` returns it, or something false. `before` is needed first."""

    words: str
    find: Callable[[], Any]
    before: Need | None = None

    def lacks(self) -> str:
        """Return what the user must do first, empty for nothing."""
        if self.find():
            return ""
        return (self.before.lacks_now() if self.before else "") or self.words

    def lacks_now(self) -> str:
        """Return what `lacks` does, at most a moment old, because many commands share a need.

        Only the words of a disabled command depend on it, not whether it is available.
        """
        now = time.monotonic()
        end, words = _answers.get(self, (0.0, ""))
        if now > end:
            words = self.lacks()
            _answers[self] = now + MOMENT, words
        return words


def features() -> list:
    """Return the selected form features."""
    return [region for region in subject.selected(subject.REGION) if region.Role == "form feature"]


def some(least: int, most: int, find: Callable[[], list]) -> Callable[[], list]:
    """Return a function that finds `least` to `most` objects, else an empty list."""

    def found() -> list:
        every = find()
        return every if least <= len(every) <= most else []

    return found


def one(kind: str) -> Callable[[], Any]:
    """Return a function that finds the one selected object of a kind, else None."""

    def found():
        every = subject.selected(kind)
        return every[0] if len(every) == 1 else None

    return found


def morph_with(kind: str, least: int = 1) -> Callable[[], Any]:
    """Return a function that finds the morph if it has at least `least` objects of a kind."""
    return lambda: subject.assembly() if subject.has(kind, least) else None


def morph_to_move():
    """Return the morph if it has a handle, else None."""
    return subject.assembly() if subject.handle() is not None else None


def morph_to_extend():
    """Return the morph if a mesh or shape is selected, else None."""
    return subject.assembly() if subject.may_become_parts() else None


def is_target_clear() -> bool:
    """Return whether an import has one target: the morph, or a new one without any."""
    return subject.assembly() is not None or not subject.assemblies()


def follower():
    """Return the one selected part if it is not the primary part, else None."""
    part = one(subject.PART)()
    owner = part and subject.assembly_of(part)
    return part if owner and owner.Primary != part else None


def shaped_part():
    """Return the part if it was made from a shape of the document, else None."""
    part = subject.part()
    return part if part is not None and part.ShapeSource is not None else None


def part_with_faces():
    """Return the part if it knows the faces of a CAD shape, else None."""
    part = subject.part()
    return part if part is not None and part.ShapeData else None


NOTHING = Need("", lambda: True)
ANY_MORPH = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Create a morph or import a part first."),
    subject.assemblies,
)
CLEAR_MORPH = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select one of the morphs first."), is_target_clear
)
MORPH = Need(CLEAR_MORPH.words, subject.assembly, ANY_MORPH)
SOURCES = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a mesh or a shape first."), morph_to_extend, MORPH
)
PART = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Add a part to the morph first."), subject.part, MORPH
)
PARTED_MORPH = Need(PART.words, morph_with(subject.PART), MORPH)
TWO_PARTS = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Add a second part to the morph first."),
    morph_with(subject.PART, 2),
    PART,
)
FOLLOWING_PART = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a part other than the primary part first."),
    follower,
    PART,
)
SHAPED_PART = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a part made from a shape of the document first."),
    shaped_part,
    PART,
)
PART_WITH_FACES = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a part made from a CAD shape first."),
    part_with_faces,
    PART,
)
REGION = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a region first."), one(subject.REGION), PART
)
FEATURE = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a form feature first."),
    lambda: next(iter(some(1, 1, features)()), None),
    PART,
)
TWO_FEATURES = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select two form features first."),
    some(2, 2, features),
    PART,
)
FEATURES = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select two or more form features first."),
    some(2, 10000, features),
    PART,
)
CONTACT_PAIR = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a contact first."), one(CONTACT), TWO_PARTS
)
CONTACTS = Need(CONTACT_PAIR.words, lambda: subject.selected(CONTACT), TWO_PARTS)
HANDLE = Need(QT_TRANSLATE_NOOP("SheetMorph_needs", "Mark a handle first."), subject.handle, PART)
MOVING_MORPH = Need(HANDLE.words, morph_to_move, PART)
POSED_MORPH = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Save a pose first."),
    morph_with(subject.POSE),
    MOVING_MORPH,
)
POSE = Need(
    QT_TRANSLATE_NOOP("SheetMorph_needs", "Select a pose first."), one(subject.POSE), POSED_MORPH
)
