# SPDX-License-Identifier: LGPL-2.1-or-later
"""The assembly: the visible group, with the properties of all parts together."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

import FreeCAD

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
    "How the sheet bends. Natural: free edges are free. Neumann: free edges keep their slope. "
    "Paper: as Masuda 2007 prints it; the shape depends on how fine the mesh is. Steel: a thin "
    "shell that hardly stretches; while dragging, Neumann is shown"
)
OPERATORS = ["cotangent", "intrinsic"]
OPERATOR_DOC = (
    "Which triangles the energy sees. Cotangent: those of the mesh. Intrinsic: Delaunay triangles "
    "within the same sheet, for meshes with slivers"
)
LOCAL, SINGLE, WHOLE = "local", "single", "whole"
PROPAGATIONS = [LOCAL, SINGLE, WHOLE]
PROPAGATION_DOC = (
    "How the other parts follow the primary. Local: along the contacts, from part to part, each "
    "contact with a control mesh of its own. Single: one control mesh around everything moves "
    "all parts at once; contacts are ignored. Whole: all parts in one solve; contacts stay closed, "
    "and what is held on any part holds"
)
LEVELS_DOC = (
    "How often control meshes are subdivided: more follows finer bends, at the cost of speed "
    "(3 is right for most sheets)"
)
SMOOTHNESS_DOC = (
    "How smooth control meshes stay: small follows the source closely, large evens out its "
    "details (default 0.05)"
)
SYMMETRY_DOC = (
    "What one side of the plane is told, the other does mirrored: handles, sizes and prescribed "
    "rotations act on both sides"
)
REFINE_DOC = "Refine large rotations: slower and nearer to the true bending; off by default"
UNHELD = ["rest", "along", "refuse"]
UNHELD_DOC = (
    "What becomes of pieces of a part that nothing holds, while others of it move. Rest: they "
    "stay. Along: each goes rigidly along with the nearest place that is held. Refuse: the "
    "morph fails"
)
REPAIR_DOC = (
    "Criteria until which nodes of decks slide in their sheet where the exported recipe is run: "
    "standard, crash, static, or a file beside it; nothing: they do not. FreeCAD itself repairs "
    "nothing"
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
            "Parts that no contact connects with the primary; they stay where they are",
            mode=READ_ONLY,
            is_output=True,
        ),
        Property(
            "String",
            "Status",
            "Morph",
            "How the last recompute went",
            "",
            READ_ONLY,
            is_output=True,
        ),
        Property(
            "StringList",
            "Warnings",
            "Morph",
            "What the pose does that is likely not wanted, and what to do",
            mode=READ_ONLY,
            is_output=True,
        ),
        Property(
            "String", "Extras", "Morph", "What a recipe held beyond regions, as JSON", "", HIDDEN
        ),
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
            assembly = None
            if document in FreeCAD.listDocuments():
                assembly = FreeCAD.getDocument(document).getObject(name)
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
