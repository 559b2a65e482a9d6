# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly: the visible group, with the properties of all parts together."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

import FreeCAD

from freecad.sheetmorph import generations
from freecad.sheetmorph.objects.model import (
    ASSEMBLY,
    CONTACT,
    DEFORMATION,
    PART,
    REGION,
    RELATION,
    assembly_of,
    deformation_of,
    kind,
)
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, Property
from freecad.sheetmorph.objects.proxy import ObjectProxy, is_settled, make_due

ENERGIES = ["neumann", "natural", "paper", "steel"]
ENERGY_DOC = (
    "How the sheet bends. Neumann: quick; free edges keep their slope. "
    "Natural: free edges are free. Paper: as published by Masuda (2007); "
    "the shape depends on the mesh size. Steel: a thin shell that hardly "
    "stretches; while you drag, Neumann is shown"
)
OPERATORS = ["cotangent", "intrinsic"]
OPERATOR_DOC = (
    "Triangles that the energy uses. Cotangent: those of the mesh. "
    "Intrinsic: Delaunay triangles on the same sheet, for meshes with "
    "slivers"
)
LOCAL, SINGLE, WHOLE = "local", "single", "whole"
PROPAGATIONS = [LOCAL, SINGLE, WHOLE]
PROPAGATION_DOC = (
    "How the other parts follow the primary part. Local: from part to part "
    "along the contacts, each with its own control mesh. Single: one "
    "control mesh around everything moves all parts and ignores the "
    "contacts. Whole: all parts in one solve, which keeps contacts closed "
    "and constraints on every part"
)
LEVELS_DOC = (
    "Number of subdivisions of the control meshes. More follow finer bends "
    "but take longer; 3 suits most sheets"
)
SMOOTHNESS_DOC = (
    "Smoothness of the control meshes. Small values follow the driving "
    "part closely, large values even out its details (default 0.05)"
)
SYMMETRY_DOC = (
    "Mirrors all handles, sizes and prescribed rotations at the plane, so "
    "that they act on both sides"
)
REFINE_DOC = "Refines large rotations: slower, but closer to real bending; off by default"
UNHELD = ["rest", "along", "refuse"]
UNHELD_DOC = (
    "How unconstrained pieces of a part behave while others move. Rest: "
    "they stay. Along: each moves rigidly with the nearest constrained "
    "place. Refuse: the morph fails"
)
REPAIR_DOC = (
    "Criteria for repairing deck elements when the exported recipe runs: "
    "standard, crash, static, or a file next to it; nodes then slide in "
    "their sheet. Empty: no repair. FreeCAD itself repairs nothing"
)
INPUTS = ("Group", "Primary", "Energy", "Extras", "Propagation", "Levels", "Smoothness")
INPUTS += ("Operator", "Symmetry", "SymmetryPoint", "SymmetryNormal", "Refine", "Unheld")


class AssemblyProxy(ObjectProxy):
    """Proxy of the group; it keeps the links of the hidden deformation up to date."""

    Type = ASSEMBLY
    PROPERTIES = (
        Property("Link", "Primary", "Morph", "The part that is deformed first"),
        Property("Enumeration", "Energy", "Morph", ENERGY_DOC, ENERGIES),
        Property("Enumeration", "Operator", "Morph", OPERATOR_DOC, OPERATORS),
        Property("Enumeration", "Propagation", "Propagation", PROPAGATION_DOC, PROPAGATIONS),
        Property("Integer", "Levels", "Propagation", LEVELS_DOC, 3),
        Property("Float", "Smoothness", "Propagation", SMOOTHNESS_DOC, 0.05),
        Property("Bool", "Symmetry", "Symmetry", SYMMETRY_DOC),
        Property("Vector", "SymmetryPoint", "Symmetry", "A point of the plane, global"),
        Property(
            "Vector", "SymmetryNormal", "Symmetry", "Normal of the plane", FreeCAD.Vector(1, 0, 0)
        ),
        Property("Bool", "Refine", "Morph", REFINE_DOC),
        Property("Enumeration", "Unheld", "Morph", UNHELD_DOC, UNHELD),
        Property("String", "Repair", "Morph", REPAIR_DOC, ""),
        Property(
            "StringList",
            "Order",
            "Propagation",
            "Parts in the order in which they are deformed",
            mode=READ_ONLY,
            is_output=True,
        ),
        Property(
            "StringList",
            "Unreached",
            "Propagation",
            "Parts that no contact connects to the primary part; they stay at rest",
            mode=READ_ONLY,
            is_output=True,
        ),
        Property(
            "String",
            "Status",
            "Morph",
            "Result of the last recompute",
            "",
            READ_ONLY,
            is_output=True,
        ),
        Property(
            "StringList",
            "Warnings",
            "Morph",
            "Likely problems of the pose, and what to do about them",
            mode=READ_ONLY,
            is_output=True,
        ),
        Property("String", "Extras", "Morph", "Other entries of the recipe, as JSON", "", HIDDEN),
    )

    def onChanged(self, obj, name: str) -> None:
        """Pass changes of relevant properties on to the deformation."""
        if name in INPUTS and is_settled(obj):
            follow_group(obj)
        elif name in INPUTS and obj.Document.Transacting:
            make_due(deformation_of(obj))

    def execute(self, _obj) -> None:
        """Do nothing: a group has no result."""


_PUT_OFF: ContextVar[set[tuple[str, str]] | None] = ContextVar("put off", default=None)
"""Documents and names of the assemblies that `together` updates at its end; None outside of it."""


@contextmanager
def together() -> Iterator[None]:
    """Update the deformations once at the end of this context, for all changes of groups in it.

    Single updates take quadratic time in the number of changes. Nothing must recompute inside.
    """
    if _PUT_OFF.get() is not None:
        yield
        return
    changed: set[tuple[str, str]] = set()
    before = _PUT_OFF.set(changed)
    try:
        yield
    finally:
        _PUT_OFF.reset(before)
        for document, name in changed:
            found = generations.document_named(document)
            assembly = found and found.getObject(name)
            if assembly is not None:
                follow_group(assembly)


def follow_group(assembly) -> None:
    """Make the deformation of `assembly` depend on regions, contacts and sources in the group.

    The group cannot be a dependency, because it contains objects that depend on it.
    """
    put_off = _PUT_OFF.get()
    if put_off is not None:
        put_off.add((assembly.Document.Name, assembly.Name))
        return
    members: dict[str, list] = {}
    for obj in assembly.Group:  # read once, because it may be long
        members.setdefault(kind(obj), []).append(obj)
    for deformation in members.get(DEFORMATION, [])[:1]:
        update_links(deformation, "Regions", members.get(REGION, []))
        update_links(deformation, "Contacts", members.get(CONTACT, []))
        update_links(deformation, "Relations", members.get(RELATION, []))
        sources = [part.Source for part in members.get(PART, []) if part.Source is not None]
        update_links(deformation, "Sources", sources)
        deformation.touch()


def update_links(obj, name: str, wanted: list) -> None:
    """Set a list of links if it differs."""
    if list(getattr(obj, name)) != wanted:
        setattr(obj, name, wanted)


def join_assembly(obj, part) -> None:
    """Add a pasted object to the morph of its part, which may be None."""
    if part is None or assembly_of(obj) is not None:
        return
    assembly = assembly_of(part)
    if assembly is not None:
        assembly.addObject(obj)
        follow_group(assembly)
