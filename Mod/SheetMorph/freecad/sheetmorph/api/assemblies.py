# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies and their parts."""

from __future__ import annotations

from collections.abc import Sequence

from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.api.checks import (
    direction,
    refuse_link,
    require_assembly,
    require_part_of,
    vector,
)
from freecad.sheetmorph.objects import (
    assembly_of,
    contacts,
    deformation_of,
    kind,
    model,
    parts,
    regions,
    relations,
)
from freecad.sheetmorph.objects.assembly import (
    ENERGIES,
    OPERATORS,
    UNHELD,
    AssemblyProxy,
    follow_group,
)
from freecad.sheetmorph.objects.deformation import DeformationProxy
from freecad.sheetmorph.objects.part import PartProxy


def create_assembly(document, label: str = "Morph"):
    """Create an empty assembly in a document and return it, a group.

    Parameters
    ----------
    document : App.Document
        The document.
    label : str
        Label for the user; FreeCAD makes it unique.
    """
    assembly = document.addObject("App::DocumentObjectGroupPython", "Morph")
    AssemblyProxy(assembly)
    assembly.Label = label
    deformation = document.addObject("App::FeaturePython", "Deformation")
    DeformationProxy(deformation)
    # FreeCAD shows this label when it lists the consequences of a deletion
    deformation.Label = "Shapes of all parts"
    assembly.addObject(deformation)
    return assembly


def add_part(assembly, source, label: str | None = None):
    """Add a mesh to an assembly and return the part, the object that shows it deformed.

    The source is hidden and never changed. The first part becomes the primary.

    Parameters
    ----------
    assembly : object
        The assembly.
    source : Mesh::Feature
        A mesh of the same document.
    label : str, optional
        Label of the part; by default that of the source and "morphed".

    Raises
    ------
    ValueError
        If the source is not a mesh, is empty, is in another document, or is already in this
        assembly.
    """
    require_assembly(assembly)
    check_source(assembly, source)
    part = assembly.Document.addObject("Mesh::FeaturePython", "Part")
    PartProxy(part)
    part.Label = label or f"{source.Label} morphed"
    part.Source = source
    part.Deformation = deformation_of(assembly)
    assembly.addObject(part)
    if assembly.Primary is None:
        assembly.Primary = part
    part.Mesh = conversion.copy_at(source.Mesh, conversion.result_placement(part))
    source.Visibility = False
    follow_group(assembly)
    return part


def check_source(assembly, source) -> None:
    """Raise ValueError if `source` cannot become a part of `assembly`."""
    refuse_link(source)
    label = getattr(source, "Label", repr(source))
    if not (hasattr(source, "isDerivedFrom") and source.isDerivedFrom("Mesh::Feature")):
        todo = "add it with add_shape" if hasattr(source, "Shape") else "choose a mesh"
        raise ValueError(f"'{label}' is not a mesh; {todo}.")
    if source.Document != assembly.Document:
        raise ValueError(f"'{label}' is in another document; copy it into this one first.")
    if source.Mesh.CountFacets == 0:
        raise ValueError(f"The mesh '{label}' has no triangles; choose another one.")
    if any(source in (part, part.Source, part.Original) for part in parts(assembly)):
        raise ValueError(f"'{label}' is already in the morph '{assembly.Label}'.")
    if deformation_of(assembly) in source.OutListRecursive:
        raise ValueError(f"'{label}' depends on the morph '{assembly.Label}'; choose another mesh.")


def set_primary(assembly, part) -> None:
    """Make `part` the primary part of `assembly`, which handles move and the others follow."""
    require_part_of(assembly, part)
    assembly.Primary = part


def set_energy(assembly, energy: str) -> None:
    """Set the energy: `natural` (free edges are free), `neumann`, `paper` or `steel`."""
    require_assembly(assembly)
    if energy not in ENERGIES:
        raise ValueError(f"The energy '{energy}' does not exist; choose {' or '.join(ENERGIES)}.")
    assembly.Energy = energy


def set_operator(assembly, operator: str) -> None:
    """Set the triangles of the energy: `cotangent` (the mesh's) or `intrinsic` (Delaunay)."""
    require_assembly(assembly)
    if operator not in OPERATORS:
        choice = " or ".join(OPERATORS)
        raise ValueError(f"The operator '{operator}' does not exist; choose {choice}.")
    assembly.Operator = operator


def set_symmetry(
    assembly, normal: Sequence[float] | None, point: Sequence[float] = (0.0, 0.0, 0.0)
) -> None:
    """Set a plane of symmetry, across which every motion is mirrored.

    Parameters
    ----------
    assembly : object
        The assembly.
    normal : sequence of float or None
        Normal (3,) of the plane, global; None removes the symmetry.
    point : sequence of float
        Point (3,) on the plane, global, mm.

    Raises
    ------
    ValueError
        If the normal or the point is invalid.
    """
    require_assembly(assembly)
    if normal is None:
        assembly.Symmetry = False
        return
    across, place = direction(normal, "normal"), vector(point, "point")
    assembly.SymmetryNormal, assembly.SymmetryPoint = across, place
    assembly.Symmetry = True


def set_refine(assembly, refine: bool) -> None:
    """Switch the refinement of large rotations on or off.

    It is slower, and closer to the behaviour of sheet metal.
    """
    require_assembly(assembly)
    assembly.Refine = bool(refine)


def set_unheld(assembly, way: str) -> None:
    """Set the behaviour of pieces of a part without prescribed vertices while other pieces move.

    Parameters
    ----------
    assembly : object
        The assembly.
    way : str
        "rest" (they stay), "along" (each follows the nearest prescribed point rigidly) or "refuse"
        (the morph fails).

    Raises
    ------
    ValueError
        For another value.
    """
    require_assembly(assembly)
    if way not in UNHELD:
        raise ValueError(f"Unconstrained pieces cannot '{way}'; choose {', '.join(UNHELD)}.")
    assembly.Unheld = way


def remove(obj) -> None:
    """Delete a region, contact or relation, a part with everything on it, or a whole assembly.

    The source meshes stay and are shown again. Raises ValueError for any other object.
    """
    remove_dependents(obj)
    document, assembly = obj.Document, assembly_of(obj)
    deformation = obj.Deformation if kind(obj) == model.PART else None
    document.removeObject(obj.Name)
    if assembly is None and deformation is not None and not deformation.InList:
        document.removeObject(deformation.Name)


def remove_dependents(obj) -> None:
    """Delete the dependents of a SheetMorph object before the object is deleted.

    These are the regions and contacts of a part, the relations that a region leaves incomplete, and
    the whole content of an assembly. Source meshes are shown again. Raises ValueError for any other
    object.
    """
    what = kind(obj)
    if what == model.ASSEMBLY:
        for part in parts(obj):
            leave_part(part)
            obj.Document.removeObject(part.Name)
        for member in [each for each in obj.Group if kind(each)]:
            obj.Document.removeObject(member.Name)
    elif what == model.PART:
        leave_part(obj)
    elif what == model.REGION and assembly_of(obj) is not None:
        for relation in relations(assembly_of(obj), obj):
            if len(relation.Features) <= 2:
                obj.Document.removeObject(relation.Name)
    elif not what:
        raise ValueError(
            f"'{obj.Label}' is not an assembly, part, region or contact; delete it in the tree."
        )


def leave_part(part) -> None:
    """Delete the regions and contacts of a part, show its source, and choose another primary."""
    assembly, source = assembly_of(part), part.Original or part.Source
    prepared = part.Source if part.Original is not None else None
    others: list = []
    if assembly is not None:
        for member in regions(assembly, part) + contacts(assembly, part):
            remove_dependents(member)
            part.Document.removeObject(member.Name)
        others = [other for other in parts(assembly) if other != part]
        if assembly.Primary == part:
            assembly.Primary = others[0] if others else None
    for shells in part.Shells:
        part.Document.removeObject(shells.Name)
    if source is not None and all(kind(u) != model.PART or u == part for u in source.InList):
        source.Visibility = True
    if prepared is not None:
        part.Document.removeObject(prepared.Name)
    if part.Deck is not None and not any(other.Deck == part.Deck for other in others):
        part.Document.removeObject(part.Deck.Name)
