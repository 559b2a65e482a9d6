# SPDX-License-Identifier: LGPL-2.1-or-later
"""Queries of the document objects of a morph; this module imports no proxy."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freecad.sheetmorph.kinds import ASSEMBLY, CONTACT, DECK, DEFORMATION, PART, POSE, REGION
from freecad.sheetmorph.kinds import RELATION, STUDY, kind
from freecad.sheetmorph.objects.errors import Fault


def assembly_of(obj):
    """Return the assembly that contains `obj`, one of our objects, or None."""
    if kind(obj) == ASSEMBLY:
        return obj
    return next((parent for parent in obj.InList if is_member(obj, parent)), None)


def is_member(obj, assembly) -> bool:
    """Return whether `obj` lies in the group `assembly`, an object of any kind that links to it.

    Besides its members a group links to its primary part. The membership test is slow for a large
    group, so only the primary needs it.
    """
    return kind(assembly) == ASSEMBLY and (obj != assembly.Primary or obj in assembly.Group)


class Members:
    """The members of an assembly by kind, in the order of its group, read once.

    FreeCAD takes milliseconds to list a group of a thousand objects.
    """

    def __init__(self, assembly):
        self.assembly, self.group = assembly, assembly.Group
        self._lists: dict[str, list] = {}
        for obj in self.group:
            self._lists.setdefault(kind(obj), []).append(obj)
        self.parts, self.regions = self._of(PART), self._of(REGION)
        self.contacts, self.relations = self._of(CONTACT), self._of(RELATION)

    @classmethod
    def of(cls, assembly) -> Members:
        """Return the members of an assembly, or `assembly` if it is a Members object already."""
        return assembly if isinstance(assembly, cls) else cls(assembly)

    def _of(self, wanted: str) -> list:
        return self._lists.get(wanted, [])


def parts(assembly) -> list:
    """Return the parts of an assembly in the order of its group."""
    return [obj for obj in assembly.Group if kind(obj) == PART]


def regions(assembly, part=None) -> list:
    """Return the regions of an assembly, or those on one of its parts.

    A region whose part was deleted belongs to no part.
    """
    mine = [obj for obj in assembly.Group if kind(obj) == REGION]
    return [obj for obj in mine if part is None or obj.Part == part]


def contacts(assembly, part=None) -> list:
    """Return the contacts of an assembly, or those of one of its parts."""
    mine = [obj for obj in assembly.Group if kind(obj) == CONTACT]
    return [obj for obj in mine if part is None or part in (obj.PartA, obj.PartB)]


def relations(assembly, feature=None) -> list:
    """Return the groups and pairs of form features, or those with one feature."""
    mine = [obj for obj in assembly.Group if kind(obj) == RELATION]
    return [obj for obj in mine if feature is None or feature in obj.Features]


def poses(assembly) -> list:
    """Return the poses of an assembly in the order of its group."""
    return [obj for obj in assembly.Group if kind(obj) == POSE]


def decks(assembly) -> list:
    """Return the decks of an assembly in the order of its group."""
    return [obj for obj in assembly.Group if kind(obj) == DECK]


def studies(assembly) -> list:
    """Return the studies of an assembly in the order of its group."""
    return [obj for obj in assembly.Group if kind(obj) == STUDY]


def deformation_of(assembly):
    """Return the hidden deformation object of `assembly`, or None."""
    return next((obj for obj in assembly.Group if kind(obj) == DEFORMATION), None)


def failure_of(assembly) -> Fault:
    """Return the fault of the last recompute, empty if it succeeded."""
    concerned = [obj for obj in (deformation_of(assembly), *parts(assembly)) if obj is not None]
    failed = [obj for obj in concerned if "Invalid" in obj.State]
    if not failed:
        return Fault("")
    known = failed[0].Proxy.fault
    return known if isinstance(known, Fault) and known else Fault(failed[0].getStatusString())


def warnings_of(assembly) -> list[Fault]:
    """Return the warnings of the last recompute; in a reopened document they have no objects."""
    deformation = deformation_of(assembly)
    known = deformation.Proxy.warnings if deformation is not None else ()
    return list(known or map(Fault, assembly.Warnings))


def vertices(region) -> np.ndarray:
    """Return the vertices (k,) int64 of a region: indices into the rest mesh of its part."""
    return to_ids(region.Vertices)


def contact_vertices(contact, side: str) -> np.ndarray:
    """Return the vertices (k,) int64 of side "a" or "b" of a contact, indices into its part."""
    return to_ids(contact.VerticesA if side == "a" else contact.VerticesB)


def set_vertices(region, ids: Iterable[int], where: str = "") -> None:
    """Store the vertex indices of a region, sorted and unique, and its selector.

    `where` is a selector as JSON, or empty. Equal vertices change nothing, so that no shape is
    recomputed.
    """
    set_where_new(region, "Vertices", to_numbers(ids))
    set_where_new(region, "Where", where)


def set_contact_vertices(contact, side: str, ids: Iterable[int], where: str = "") -> None:
    """Store the vertex indices and the selector of side "a" or "b"; see `set_vertices`."""
    set_where_new(contact, f"Vertices{side.upper()}", to_numbers(ids))
    set_where_new(contact, f"Where{side.upper()}", where)


def set_where_new(obj, name: str, value) -> None:
    """Set a property only if it differs.

    FreeCAD treats every assignment as a change, recomputes the dependants and adds it to the undo
    step.
    """
    if getattr(obj, name) != value:
        setattr(obj, name, value)


def to_numbers(ids: Iterable[int]) -> list[float]:
    """Return sorted unique indices in the form stored by a document.

    FreeCAD saves a list of floats in binary form, but a list of integers as XML, which is slow
    above 100,000.
    """
    return np.unique(np.asarray(list(ids), dtype=np.int64)).astype(float).tolist()


def to_ids(numbers: list[float]) -> np.ndarray:
    """Return indices (k,) int64 from the result of `to_numbers`.

    Invalid numbers, as in a damaged document, become -1.
    """
    found = np.asarray(numbers, dtype=float)
    is_index = (found >= 0.0) & (found < 2.0**53)
    return np.where(is_index, found, -1.0).astype(np.int64)
