# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects of a morph and how to find one's way between them.

Assembly (a group) holds parts (results), regions, contacts, relations of form features and one
hidden deformation. Dependencies run source meshes, regions, contacts and relations -> deformation
-> parts; the group and the links of regions and contacts to their parts are no dependencies, so
there are no cycles.
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
