# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of a morph: a sentence for the user, and the objects at fault."""

from __future__ import annotations

OTHER = "other"
UNHELD, OVERLAP, TORN = "unheld", "overlap", "torn"
"""Kernel codes of the faults that a button can cure."""

UNREACHED, OPEN_CONTACT = "unreached", "open contact"
"""Codes of the warnings that a panel shows separately."""

FLIPPED = "flipped"
"""Code of the warning about triangles that flip, which the view marks."""


class Fault(str):
    """A sentence (where, what, what to do) with its objects and its kind.

    `objects` has the document object names of the parts, regions, contacts and relations at fault.
    `code` is the kind of fault. Neither can be derived from the sentence, because it contains
    labels of the user.
    """

    objects: tuple[str, ...]
    code: str

    def __new__(cls, sentence: str, *objects: str, code: str = OTHER) -> Fault:
        found = super().__new__(cls, sentence)
        found.objects, found.code = objects, code
        return found

    def is_same(self, other: Fault) -> bool:
        """Return whether another fault has the same text and objects; labels need not be unique."""
        return (self, self.objects, self.code) == (other, other.objects, other.code)


class _Named(type):
    def __str__(cls) -> str:
        """Return the text that FreeCAD writes before the sentence in place of the type."""
        return "SheetMorph"


class MorphError(ValueError, metaclass=_Named):
    """A morph that cannot be computed; `fault` has the reason and the objects at fault."""

    def __init__(self, sentence: str, *objects):
        """Store a Fault, or make one from a sentence and document objects."""
        is_whole = isinstance(sentence, Fault) and not objects
        names = (obj.Name for obj in objects)
        self.fault = sentence if is_whole else Fault(sentence, *names)
        super().__init__(str(sentence))
