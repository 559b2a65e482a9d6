# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts: connections between parts, through which one follows the other."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.api.checks import number, require_kind, require_part_of
from freecad.sheetmorph.api.picking import rest_mesh
from freecad.sheetmorph.api.regions import vertices_and_words
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.contact import CONTROL_MESH, TYPES, ContactProxy

Side = tuple[object, Iterable[int] | dict]
"""A part, and indices of its vertices or a selector (see `select`)."""


def add_contact(assembly, a: Side, b: Side, *, label: str = "Contact", type: str = CONTROL_MESH):
    """Add a contact between two parts and return it.

    The primary determines which part drives the other.

    Parameters
    ----------
    assembly : object
        The assembly.
    a, b : tuple
        The sides, each as (part, vertices) with at least one vertex, or with a selector.
    label : str
        Label of the contact.
    type : str
        "control mesh", "tied" or "rigid".

    Raises
    ------
    ValueError
        For an invalid side or type.
    """
    checked = [checked_side(assembly, side) for side in (a, b)]
    require_type(type)
    if a[0] == b[0]:
        raise ValueError(f"Both sides are on part '{a[0].Label}'; pass sides of two parts.")
    contact = assembly.Document.addObject("App::FeaturePython", "Contact")
    ContactProxy(contact)
    contact.Label = label
    contact.Type = type
    contact.PartA, contact.PartB = a[0], b[0]
    for side, vertices in zip("ab", checked):
        model.set_contact_vertices(contact, side, *vertices)
    assembly.addObject(contact)
    return contact


def checked_side(assembly, side: Side) -> tuple[np.ndarray, str]:
    """Return the vertices (k,) of a contact side and its selector, or raise ValueError."""
    part, vertices = side
    require_part_of(assembly, part)
    return vertices_and_words(part, vertices)


def require_type(type: str) -> None:
    """Raise ValueError unless `type` is a type of contact."""
    if type not in TYPES:
        raise ValueError(f"The contact type '{type}' does not exist; choose {', '.join(TYPES)}.")


def set_contact_type(contact, type: str) -> None:
    """Set the type of a contact: "control mesh", "tied" or "rigid". Raises ValueError."""
    require_kind(contact, model.CONTACT, "contact")
    require_type(type)
    contact.Type = type


def set_active(contact, active: bool) -> None:
    """Switch a contact on, or off as if the joint were open."""
    require_kind(contact, model.CONTACT, "contact")
    contact.Active = bool(active)


def contact_vertices(contact, side: str) -> list[int]:
    """Return the sorted vertex indices of side "a" or "b" of a contact in its part's mesh."""
    require_kind(contact, model.CONTACT, "contact")
    require_side(side)
    return model.contact_vertices(contact, side).tolist()


def set_contact_vertices(contact, side: str, vertices: Iterable[int] | dict) -> None:
    """Set the vertices of side "a" or "b" of a contact: at least one, or a selector."""
    require_kind(contact, model.CONTACT, "contact")
    require_side(side)
    part = contact.PartA if side == "a" else contact.PartB
    if part is None:
        raise ValueError(f"Contact '{contact.Label}' has lost a part; delete the contact.")
    model.set_contact_vertices(contact, side, *vertices_and_words(part, vertices))


def require_side(side: str) -> None:
    """Raise ValueError unless `side` names one side of a contact."""
    if side not in ("a", "b"):
        raise ValueError(f"A contact has no side '{side}'; pass 'a' or 'b'.")


def touching_vertices(part_a, part_b, distance: float) -> tuple[list[int], list[int]]:
    """Return the vertices of each part within `distance`, mm, of the other's surface.

    Both sorted lists refer to the placed parts at rest; they are empty if no vertex is close
    enough.
    """
    reach = number(distance, "distance")
    if reach < 0.0:
        raise ValueError(f"The distance is {reach} mm; pass zero or more.")
    if part_a == part_b:
        raise ValueError(f"Both sides are part '{part_a.Label}'; pass two parts.")
    mesh_a, mesh_b = rest_mesh(part_a), rest_mesh(part_b)
    return near(mesh_a[0], mesh_b, reach), near(mesh_b[0], mesh_a, reach)


def near(points: np.ndarray, mesh: tuple, reach: float) -> list[int]:
    """Return the indices of points (n, 3) within `reach`, mm, of a mesh (points, triangles)."""
    used = mesh[0][np.unique(mesh[1])]
    low, high = used.min(axis=0) - reach, used.max(axis=0) + reach
    candidates = np.flatnonzero(np.all((points >= low) & (points <= high), axis=1))
    tree = kernel.core().PickingTree(*mesh)
    return [int(v) for v in candidates if tree.nearest_point(points[v]).distance <= reach]
