# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a recompute besides positions: propagation order and contact fidelity."""

from __future__ import annotations

from dataclasses import dataclass, field

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.faults import Names, warning_of
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import Fault
from freecad.sheetmorph.objects.model import set_where_new
from freecad.sheetmorph.objects.properties import number_of
from freecad.sheetmorph.tools import words

NO_FIDELITY = (0.0, 0.0)
UNREACHED = -1
Step = tuple[str, int, list[str]]
"""Object name of a part, its level, and object names of the contacts that drive it."""


@dataclass(frozen=True)
class Findings:
    """The results that the document shows; empty if nothing was solved."""

    order: tuple[str, ...] = ()  # part names in the order of deformation
    unreached: tuple[str, ...] = ()  # names of parts that no motion reaches
    fidelity: dict[str, tuple[float, float]] = field(default_factory=dict)
    """Change of the gap and deviation, mm, by object name of a contact."""
    warnings: dict[str, str] = field(default_factory=dict)
    """Warning by object name of a contact whose gap changes too much."""
    sentences: tuple[Fault, ...] = ()  # all warnings, including those of contacts
    unsettled: str = ""  # sentences on solves that did not converge


def findings_of(session, result, objects: Names) -> Findings:
    """Return the findings of a session and its result; `objects` are those of its recipe."""
    contacts = {name: found for (of, name), found in objects.items() if of == "contact"}
    fidelity = {
        contacts[found.name]: (found.gap_change, found.deviation) for found in result.contacts
    }
    opened = kernel.load().open_contacts(result)
    warnings = {contacts[name]: text for name, text in opened.items()}
    order, unreached = tuple(session.order), tuple(session.unreached)
    sentences = tuple(warning_of(caution, objects) for caution in result.warnings())
    return Findings(order, unreached, fidelity, warnings, sentences)


def steps_of(session, parts: dict[str, str], contacts: dict[str, str]) -> list[Step]:
    """Return all parts in the order of propagation, unreached ones last.

    `parts` and `contacts` are object names by recipe name.
    """
    levels = session.levels
    driving: dict[str, list[str]] = {}
    for contact, _source, target in session.directions:
        driving.setdefault(target, []).append(contacts[contact])
    steps = [(parts[name], levels[name], driving.get(name, [])) for name in session.order]
    return steps + [(parts[name], UNREACHED, []) for name in session.unreached]


def show(assembly, outcome) -> None:
    """Set the read-only properties of an assembly and its contacts if they differ."""
    found = outcome.findings
    set_where_new(assembly, "Status", outcome.status)
    set_where_new(assembly, "Order", list(found.order))
    set_where_new(assembly, "Unreached", list(found.unreached))
    set_where_new(assembly, "Warnings", list(map(str, found.sentences)))
    for contact in model.contacts(assembly):
        gap, deviation = found.fidelity.get(contact.Name, NO_FIDELITY)
        set_length(contact, "GapChange", gap)
        set_length(contact, "Deviation", deviation)
        set_where_new(
            contact, "Kept", f"gap {words.length(gap)}, deviation {words.length(deviation)}"
        )
        set_where_new(contact, "Warning", found.warnings.get(contact.Name, ""))


def set_length(obj, name: str, value: float) -> None:
    """Set a length, mm, if it differs."""
    if number_of(obj, name) != value:
        setattr(obj, name, value)
