# SPDX-License-Identifier: LGPL-2.1-or-later
"""The location of a fault, and the repair that a button offers."""

import numpy as np

from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.actions import FAULTS, call, name
from freecad.sheetmorph.api.regions import loose_vertices
from freecad.sheetmorph.bridge.faults import at_fault
from freecad.sheetmorph.kinds import CONTACT, PART, REGION, RELATION, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import OVERLAP, TORN, UNHELD
from freecad.sheetmorph.qt import translate


def places(assembly, fault) -> list:
    """Return the parts and vertices (k,) of a fault."""
    found = [place for obj in at_fault(assembly, fault) for place in places_of(obj, fault)]
    return [(part, vertices) for part, vertices in found if len(vertices)]


def places_of(obj, fault) -> list:
    """Return the parts and vertices (k,) of a fault at one object."""
    if kind(obj) == RELATION:
        return [place for feature in obj.Features for place in seen.places_of(feature)]
    if kind(obj) != PART:
        return seen.places_of(obj)
    if fault.code == UNHELD:
        return [(obj, seen.as_drawn(obj, loose_on(obj)))]
    return [(obj, np.unique(seen.triangles(obj)))] if obj.Source is not None else []


def cure_of(assembly, fault):
    """Return the title and API line of the repair for a fault, None without one."""
    found = at_fault(assembly, fault)
    regions = [obj for obj in found if kind(obj) == REGION]
    for other, region in pairs(regions) if fault.code in (OVERLAP, TORN) else ():
        if shares_some(region, other):
            title = translate("SheetMorph_panels", "Remove from “{0}”").format(region.Label)
            return title, call("take_out", name(region), name(other))
    for contact in [obj for obj in found if kind(obj) == CONTACT and obj.Active]:
        title = translate("SheetMorph_panels", "Do not use “{0}”").format(contact.Label)
        return title, call("set_active", name(contact), "False")
    for part in [obj for obj in found if kind(obj) == PART and fault.code == UNHELD]:
        if len(loose_on(part)):
            title = translate("SheetMorph_panels", "Leave at rest")
            return title, call("hold_loose_pieces", name(part))
    return None


def pairs(regions: list) -> list:
    """Return pairs of regions, of which the second gives way: a form feature or the later."""
    found = [(a, b) for k, a in enumerate(regions) for b in regions[k + 1 :]]
    return [(b, a) if a.Role == "form feature" else (a, b) for a, b in found]


def shares_some(region, other) -> bool:
    """Return whether a region shares some of its vertices with another one, but not all."""
    mine = model.vertices(region)
    common = np.intersect1d(mine, model.vertices(other))
    return region.Part == other.Part and 0 < len(common) < len(mine)


def loose_on(part) -> np.ndarray:
    """Return the vertices of the pieces of a part that no region or contact constrains."""
    try:
        return loose_vertices(part)
    except FAULTS:
        return np.zeros(0, dtype=np.int64)  # the part has no mesh, which is the fault to report
