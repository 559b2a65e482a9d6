# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sentence about a morph is about, where that is seen, and what a button may do about it."""

import numpy as np

from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.actions import FAULTS, call, name
from freecad.sheetmorph.api.regions import loose_vertices
from freecad.sheetmorph.bridge.faults import named_by, parts_named_by
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import translate


def places(assembly, sentence: str) -> list:
    """The parts and vertices (k,) that a sentence is about."""
    found = [place for obj in named_by(assembly, sentence) for place in seen.places_of(obj)]
    if not found:
        named = parts_named_by(assembly, sentence)
        found = [(part, seen.as_drawn(part, loose_on(part))) for part in named]
    return [(part, vertices) for part, vertices in found if len(vertices)]


def cure_of(assembly, sentence: str):
    """What a button may do about it: its title and the line of the API; None for nothing."""
    named = named_by(assembly, sentence)
    for other, region in pairs([obj for obj in named if model.kind(obj) == model.REGION]):
        if shares_some(region, other):
            title = translate("SheetMorph_panels", "Take out of “{0}”").format(region.Label)
            return title, call("take_out", name(region), name(other))
    for contact in [obj for obj in named if model.kind(obj) == model.CONTACT and obj.Active]:
        title = translate("SheetMorph_panels", "Do not use “{0}”").format(contact.Label)
        return title, call("set_active", name(contact), "False")
    for part in parts_named_by(assembly, sentence):
        if not named and len(loose_on(part)):
            return translate("SheetMorph_panels", "Leave at rest"), call(
                "hold_loose_pieces", name(part)
            )
    return None


def pairs(regions: list) -> list:
    """Pairs of regions; the second of each gives way: a form feature, or the one named later."""
    found = [(a, b) for k, a in enumerate(regions) for b in regions[k + 1 :]]
    return [(b, a) if a.Role == "form feature" else (a, b) for a, b in found]


def shares_some(region, other) -> bool:
    """Whether a region has vertices of another one, and others besides."""
    mine = model.vertices(region)
    common = np.intersect1d(mine, model.vertices(other))
    return region.Part == other.Part and 0 < len(common) < len(mine)


def loose_on(part) -> np.ndarray:
    """The vertices of the pieces of a part that nothing holds."""
    try:
        return loose_vertices(part)
    except FAULTS:
        return np.zeros(0, dtype=np.int64)  # it has no mesh: that is what is wrong
