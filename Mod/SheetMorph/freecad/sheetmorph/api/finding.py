# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form features and contacts that are found on the parts; nothing changes until they are added."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.api.cad import known_features
from freecad.sheetmorph.api.checks import require_assembly, require_part_of
from freecad.sheetmorph.api.contacts import add_contact
from freecad.sheetmorph.api.picking import rest_mesh
from freecad.sheetmorph.api.regions import add_feature
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.assembly import together
from freecad.sheetmorph.objects.region import FORM_FEATURE

HOLES = ("round hole", "slotted hole", "rectangular hole", "hole")
Vector = tuple[float, float, float]


@dataclass(frozen=True)
class FoundFeature:
    """A feature on a part at rest; global, mm.

    radius: of a circle or curved surface, the inner one of a bend, half the width of a slot, else
    0; size: the diameter, or the longer extent; residual: largest distance of a vertex from the
    fitted form; vertices: of its rims and walls; washer: rings of vertices around, the inner first;
    is_marked: it is a form feature of the document already; angle: how far a bend turns, degrees;
    unsettled: why its vertices are not certain, in words, empty if they are.
    """

    part: Any
    name: str
    kind: str
    center: Vector
    axis: Vector
    radius: float
    size: float
    residual: float
    vertices: list[int]
    washer: list[list[int]]
    is_marked: bool
    angle: float = 0.0
    unsettled: str = ""


@dataclass(frozen=True)
class FoundContact:
    """A place where two parts touch; global, mm.

    kind: "bolt", "weld", "flange", "face" or "edge"; type: the contact type proposed; distance:
    between both sides, median; size: diagonal of the box around both; is_marked: a contact of the
    document is there already.
    """

    part_a: Any
    part_b: Any
    name: str
    kind: str
    type: str
    a: list[int]
    b: list[int]
    distance: float
    size: float
    center: Vector
    is_marked: bool


def find_features(
    assembly, *, parts: Iterable | None = None, kinds: Iterable[str] | None = HOLES, **options
) -> list[FoundFeature]:
    """Return the features found on the parts of a morph, at rest; nothing is added.

    `parts`: only on these; `kinds`: only of these kinds ("round hole", "slotted hole",
    "rectangular hole", "hole", "round edge", "plane", "cylinder", "cone", "sphere", "flange",
    "bead", "emboss", "bend"), None for all. `options`: rings, smallest_radius, largest_radius,
    roundness, crease_angle (degrees) and others, see `finding.md`. Raises ValueError.
    """
    chosen = _parts(assembly, parts)
    found = _find(chosen, {"kinds": kinds, **options}, contacts=False)
    marked = {part.Name: _marked_vertices(assembly, part) for part in chosen}
    by_name = {part.Name: part for part in chosen}
    return [_feature(by_name[entry["part"]], entry, marked) for entry in found.features]


def find_contacts(assembly, *, parts: Iterable | None = None, **options) -> list[FoundContact]:
    """Return the contacts found between the parts of a morph, at rest; nothing is added.

    `parts`: only between these; of one alone, between it and all others. `options`: gap (largest
    distance, mm; proposed if left out), facing_angle (degrees), smallest (vertices of a side),
    one_per_pair and others, see `finding.md`. Raises ValueError.
    """
    chosen = _parts(assembly, parts)
    alone = chosen if len(chosen) == 1 else []
    chosen = model.parts(assembly) if alone else chosen
    if len(chosen) < 2:
        raise ValueError("Contacts are between parts; the morph needs two or more.")
    found = _find(chosen, options, contacts=True)
    by_name = {part.Name: part for part in chosen}
    marked = [_sides_of(contact) for contact in model.contacts(assembly)]
    every = [_contact(by_name, entry, marked) for entry in found.contacts]
    return [one for one in every if not alone or alone[0] in (one.part_a, one.part_b)]


@together()
def add_found_features(assembly, found: Iterable[FoundFeature], *, rings: int = 0) -> list:
    """Add form features for what was found, and return them; those marked already are left out.

    `rings`: how many of the washer rings belong to a feature too.
    """
    new = [feature for feature in found if not feature.is_marked]
    return [
        add_feature(assembly, feature.part, vertices, feature.name)
        for feature, vertices in zip(new, with_washers(assembly, new, rings))
    ]


@together()
def add_found_contacts(assembly, found: Iterable[FoundContact]) -> list:
    """Add contacts for what was found, and return them; those marked already are left out."""
    return [
        add_contact(
            assembly, (one.part_a, one.a), (one.part_b, one.b), label=one.name, type=one.type
        )
        for one in found
        if not one.is_marked
    ]


def with_washers(assembly, found: list[FoundFeature], rings: int) -> list[list[int]]:
    """Return for each feature its vertices and those of so many rings around it, sorted.

    A ring that touches another of the features or a region of the document is left out, with those
    outside it: two features cannot share vertices.
    """
    taken: dict[str, set[int]] = {one.part.Name: set() for one in found}
    for one in found:
        taken[one.part.Name].update(one.vertices)
    for region in model.regions(assembly):
        if region.Part is not None and region.Part.Name in taken:
            taken[region.Part.Name].update(model.vertices(region).tolist())
    result = []
    for one in found:
        vertices = set(one.vertices)
        for ring in one.washer[: max(0, int(rings))]:
            if taken[one.part.Name] & set(ring):
                break
            vertices.update(ring)
        taken[one.part.Name] |= vertices
        result.append(sorted(vertices))
    return result


def _parts(assembly, parts: Iterable | None) -> list:
    require_assembly(assembly)
    chosen = list(model.parts(assembly) if parts is None else parts)
    for part in chosen:
        require_part_of(assembly, part)
    return chosen


def _find(parts: list, options: dict, *, contacts: bool):
    """What the package finds; object names stand for parts."""
    kernel.core()  # says what is wrong with it in words
    from sheetmorph import PartMesh
    from sheetmorph.finding import FindOptions, FindPart, find
    from sheetmorph.finding.options import KINDS

    kinds = options.get("kinds")
    values = {**options, "kinds": list(KINDS if kinds is None else kinds)}
    unknown = [kind for kind in values["kinds"] if kind not in KINDS]
    if unknown:
        raise ValueError(f"There is no kind '{unknown[0]}'; choose {', '.join(KINDS)}.")
    try:
        wanted = FindOptions().changed(values)
    except TypeError as error:
        raise ValueError(f"{error}; options are told in finding.md.") from None
    for what, todo in wanted.faults():
        raise ValueError(f"{what}; {todo}.")
    meshes = [
        FindPart(
            part.Name, PartMesh(*rest_mesh(part)), exact=known_features(part), kept=kept_of(part)
        )
        for part in parts
    ]
    return reporting.waited_for(
        lambda told: find(meshes, wanted, progress=told, with_contacts=contacts)
    )


def kept_of(part) -> dict:
    """What was found on the mesh that a part rests on, for the next search; empty at first."""
    return snapshot_of(part.Source).derived("found features", read_rest(part).digest, dict)


def _feature(part, entry: dict, marked: dict[str, set[int]]) -> FoundFeature:
    radius = entry.get("radius", 0.0)
    return FoundFeature(
        part=part,
        name=entry["name"].replace(part.Name, part.Label, 1),
        kind=entry["kind"],
        center=tuple(entry["center"]),
        axis=tuple(entry["axis"]),
        radius=radius,
        size=entry.get("length", 2.0 * radius),
        residual=entry["residual"],
        vertices=entry["vertices"],
        washer=entry.get("washer", []),
        is_marked=bool(marked[part.Name] & set(entry["vertices"])),
        angle=math.degrees(entry["angle"]) if entry["kind"] == "bend" else 0.0,
        unsettled=entry.get("unsettled", ""),
    )


def _contact(parts: dict, entry: dict, marked: list) -> FoundContact:
    a, b = parts[entry["a"]["part"]], parts[entry["b"]["part"]]
    sides = {a.Name: set(entry["a"]["vertices"]), b.Name: set(entry["b"]["vertices"])}
    is_marked = any(
        set(known) == set(sides) and all(known[name] & sides[name] for name in sides)
        for known in marked
    )
    number = entry["name"].rsplit(" ", 1)[1]
    return FoundContact(
        part_a=a,
        part_b=b,
        name=f"{a.Label} - {b.Label}: {entry['kind']} {number}",
        kind=entry["kind"],
        type=entry["type"],
        a=entry["a"]["vertices"],
        b=entry["b"]["vertices"],
        distance=entry["distance"],
        size=entry["size"],
        center=tuple(entry["center"]),
        is_marked=is_marked,
    )


def _marked_vertices(assembly, part) -> set[int]:
    """The vertices of a part that are in form features already."""
    found: set[int] = set()
    for region in model.regions(assembly, part):
        if region.Role == FORM_FEATURE:
            found.update(model.vertices(region).tolist())
    return found


def _sides_of(contact) -> dict[str, set[int]]:
    sides = (("a", contact.PartA), ("b", contact.PartB))
    return {
        part.Name: set(model.contact_vertices(contact, side).tolist())
        for side, part in sides
        if part is not None
    }
