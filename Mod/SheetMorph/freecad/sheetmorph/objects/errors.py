# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong with a morph: a sentence for the person, and the objects at fault."""

from __future__ import annotations

OTHER = "other"
UNHELD, OVERLAP, TORN = "unheld", "overlap", "torn"
"""Codes of the kernel for the faults that a button cures."""

UNREACHED, OPEN_CONTACT = "unreached", "open contact"
"""Codes of the warnings that a panel shows in a place of their own."""


class Fault(str):
    """A sentence (where, what, what to do) that knows what it is about.

    `objects`: document object names of the parts, regions, contacts and relations at fault;
    `code`: what kind of fault it is. The words say neither: they hold labels of the user.
    """

    objects: tuple[str, ...]
    code: str

    def __new__(cls, sentence: str, *objects: str, code: str = OTHER) -> Fault:
        found = super().__new__(cls, sentence)
        found.objects, found.code = objects, code
        return found

    def is_same(self, other: Fault) -> bool:
        """Whether another fault says the same of the same objects, which may share a label."""
        return (self, self.objects, self.code) == (other, other.objects, other.code)


class _Named(type):
    def __str__(cls) -> str:
        """Return what FreeCAD writes before the sentence, in place of the type."""
        return "SheetMorph"


class MorphError(ValueError, metaclass=_Named):
    """A morph that cannot be computed; `fault` says why, and which objects are to blame."""

    def __init__(self, sentence: str, *objects):
        """Take a Fault as it is; else `objects` are the document objects at fault."""
        is_whole = isinstance(sentence, Fault) and not objects
        names = (obj.Name for obj in objects)
        self.fault = sentence if is_whole else Fault(sentence, *names)
        super().__init__(str(sentence))
