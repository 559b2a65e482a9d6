# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propagation: how the motion of the primary part reaches the others."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from freecad.sheetmorph.bridge import solving
from freecad.sheetmorph.api.checks import number, require_assembly, require_kind
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.objects.assembly import PROPAGATIONS
from freecad.sheetmorph.objects.part import MODES


class Step(NamedTuple):
    """One part on the way of the motion."""

    part: Any
    level: int  # contacts from the primary; -1: not reached
    contacts: list  # that drive it; the other part of each is the one it follows


def set_mode(part, mode: int | str) -> None:
    """Say how a part follows: 1, 2 or 3 of the paper, 0 to let SheetMorph choose; or its name.

    1: all vertices by the control mesh; 2: contacts and followers by it, the rest bends as a
    sheet with exact form features; 3: as 2 with the free edges inside the control meshes.
    """
    require_kind(part, model.PART, "part")
    if isinstance(mode, str) and mode in MODES:
        part.Mode = mode
    elif isinstance(mode, int) and 0 <= mode < len(MODES):
        part.Mode = MODES[mode]
    else:
        raise ValueError(f"The mode '{mode}' does not exist; pass 1, 2, 3, or 0 for automatic.")


def set_propagation(
    assembly, kind: str, *, levels: int | None = None, smoothness: float | None = None
) -> None:
    """Choose how parts follow: "local" (along contacts), "single" (one control mesh for all) or
    "whole" (all in one solve: contacts stay closed, and what is held on any part holds).

    `levels`: subdivisions of control meshes, 1 to 5; `smoothness`: of their fit, more than 0.
    What is left out stays as it is. Raises ValueError.
    """
    require_assembly(assembly)
    if kind not in PROPAGATIONS:
        names = ", ".join(PROPAGATIONS)
        raise ValueError(f"The propagation '{kind}' does not exist; choose one of {names}.")
    if levels is not None and not (isinstance(levels, int) and 1 <= levels <= 5):
        raise ValueError(f"There are 1 to 5 levels of a control mesh, not {levels}; try 3.")
    weight = None if smoothness is None else number(smoothness, "smoothness")
    if weight is not None and weight <= 0.0:
        raise ValueError(f"The smoothness is {weight}; pass a number above 0, such as 0.05.")
    assembly.Propagation = kind
    if levels is not None:
        assembly.Levels = levels
    if weight is not None:
        assembly.Smoothness = weight


def propagation(assembly) -> list[Step]:
    """Return how the motion goes through the parts: the primary first, unreached parts last.

    A `Step` is `(part, level, contacts)`. Empty as long as nothing is fixed or moved.
    Raises freecad.sheetmorph.objects.errors.MorphError, a ValueError, with one sentence.
    """
    require_assembly(assembly)
    named = assembly.Document.getObject
    return [
        Step(named(part), level, [named(contact) for contact in contacts])
        for part, level, contacts in solving.steps(assembly)
    ]


def control_mesh(assembly, contact=None) -> tuple[np.ndarray, np.ndarray] | None:
    """Return the control mesh of a contact: vertices (m, 3) mm, global, and triangles (t, 3).

    In the pose of the document. Without `contact`: the single one around everything. None if
    there is none: the contact is tied, rigid or not in use, or the propagation is another.
    Raises freecad.sheetmorph.objects.errors.MorphError, a ValueError, with one sentence.
    """
    require_assembly(assembly)
    if contact is not None:
        require_kind(contact, model.CONTACT, "contact")
        if assembly_of(contact) != assembly:
            raise ValueError(f"Contact '{contact.Label}' is not in '{assembly.Label}'.")
    return solving.control_mesh(assembly, contact)
