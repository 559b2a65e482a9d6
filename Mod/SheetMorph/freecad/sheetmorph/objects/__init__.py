# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects of a morph, and functions to navigate between them.

An assembly (a group) contains parts (results), regions, contacts, relations of form features and
one hidden deformation. Dependencies run from source meshes, regions, contacts and relations to the
deformation, and from there to the parts. The group and the links of regions and contacts to their
parts are not dependencies, so there are no cycles.
"""

from freecad.sheetmorph.objects.model import (
    assembly_of,
    contact_vertices,
    contacts,
    deformation_of,
    kind,
    parts,
    regions,
    relations,
    set_contact_vertices,
    set_vertices,
    vertices,
)

__all__ = [
    "assembly_of",
    "contact_vertices",
    "contacts",
    "deformation_of",
    "kind",
    "parts",
    "regions",
    "relations",
    "set_contact_vertices",
    "set_vertices",
    "vertices",
]
