# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propagation: the motion of the primary part reaches the others."""

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
    level: int  # contacts from the primary; -1 if not reached
    contacts: list  # contacts that drive the part; it follows the other part of each


def set_mode(part, mode: int | str) -> None:
    """Set the mode in which a part follows: 1, 2 or 3 of the paper, 0 for automatic, or a name.

    In mode 1 the control mesh drives all vertices. In mode 2 it drives contacts and followers, and
    the rest bends as a sheet with exact form features. Mode 3 is mode 2 with the free edges inside
    the control meshes driven as well.
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
    """Set the propagation to the other parts; omitted arguments stay unchanged.

    Parameters
    ----------
    assembly : object
        The assembly.
    kind : str
        "local" (along contacts), "single" (one control mesh for all) or "whole" (one solve for all
        parts, in which contacts stay closed and fixed regions of every part count).
    levels : int, optional
        Subdivision levels of control meshes, 1 to 5.
    smoothness : float, optional
        Smoothness of their fit, above 0.

    Raises
    ------
    ValueError
        For invalid values.
    """
    require_assembly(assembly)
    if kind not in PROPAGATIONS:
        names = ", ".join(PROPAGATIONS)
        raise ValueError(f"The propagation '{kind}' does not exist; choose one of {names}.")
    if levels is not None and not (isinstance(levels, int) and 1 <= levels <= 5):
        raise ValueError(f"A control mesh has 1 to 5 levels, not {levels}; try 3.")
    weight = None if smoothness is None else number(smoothness, "smoothness")
    if weight is not None and weight <= 0.0:
        raise ValueError(f"The smoothness is {weight}; pass a number above 0, such as 0.05.")
    assembly.Propagation = kind
    if levels is not None:
        assembly.Levels = levels
    if weight is not None:
        assembly.Smoothness = weight


def propagation(assembly) -> list[Step]:
    """Return the path of the motion as a list of `Step`: primary first, unreached parts last.

    A `Step` is `(part, level, contacts)`. The list is empty without a fixed region or a handle.
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

    The pose is that of the document. Without `contact` it is the single one around all parts. The
    result is None for a tied, rigid or inactive contact, or for another propagation. Raises
    freecad.sheetmorph.objects.errors.MorphError, a ValueError, with one sentence.
    """
    require_assembly(assembly)
    if contact is not None:
        require_kind(contact, model.CONTACT, "contact")
        if assembly_of(contact) != assembly:
            raise ValueError(f"Contact '{contact.Label}' is not in '{assembly.Label}'.")
    return solving.control_mesh(assembly, contact)
