# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for form features and contacts; it changes nothing until they are added."""

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

    Attributes
    ----------
    radius : float
        Radius of a circle or curved surface, inner radius of a bend, half the width of a slot, else
        0.
    size : float
        Diameter, or the larger extent.
    residual : float
        Largest distance of a vertex from the fitted shape.
    vertices : list of int
        Vertices of its rims and walls.
    washer : list of list of int
        Rings of vertices around it, the inner one first.
    is_marked : bool
        Whether the document already has a form feature there.
    angle : float
        Bend angle, degrees.
    unsettled : str
        Why its vertices are uncertain, or an empty text.
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
    """A location where two parts touch; global, mm.

    Attributes
    ----------
    kind : str
        "bolt", "weld", "flange", "face" or "edge".
    type : str
        The proposed contact type.
    distance : float
        Median distance of both sides.
    size : float
        Diagonal of the box around both sides.
    is_marked : bool
        Whether the document already has a contact there.
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
    """Return the features found on the parts of a morph at rest; nothing is added.

    Parameters
    ----------
    assembly : object
        The assembly.
    parts : iterable, optional
        Search only these parts.
    kinds : iterable of str or None
        Return only these kinds ("round hole", "slotted hole", "rectangular hole", "hole", "round
        edge", "plane", "cylinder", "cone", "sphere", "flange", "bead", "emboss", "bend"); None for
        all.
    **options
        rings, smallest_radius, largest_radius, roundness, crease_angle (degrees) and others, see
        `finding.md`.

    Raises
    ------
    ValueError
        For invalid options.
    """
    chosen = _parts(assembly, parts)
    found = _find(chosen, {"kinds": kinds, **options}, contacts=False)
    marked = {part.Name: _marked_vertices(assembly, part) for part in chosen}
    by_name = {part.Name: part for part in chosen}
    return [_feature(by_name[entry["part"]], entry, marked) for entry in found.features]


def find_contacts(assembly, *, parts: Iterable | None = None, **options) -> list[FoundContact]:
    """Return the contacts found between the parts of a morph at rest; nothing is added.

    Parameters
    ----------
    assembly : object
        The assembly.
    parts : iterable, optional
        Search only between these parts; for a single part, between it and all others.
    **options
        gap (largest distance, mm; proposed by default), facing_angle (degrees), smallest (vertices
        of a side), one_per_pair and others, see `finding.md`.

    Raises
    ------
    ValueError
        For invalid options, or for fewer than two parts.
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
    """Add form features for found ones without an existing feature, and return them.

    `rings` is the number of washer rings to include.
    """
    new = [feature for feature in found if not feature.is_marked]
    return [
        add_feature(assembly, feature.part, vertices, feature.name)
        for feature, vertices in zip(new, with_washers(assembly, new, rings))
    ]


@together()
def add_found_contacts(assembly, found: Iterable[FoundContact]) -> list:
    """Add contacts for found ones without an existing contact, and return them."""
    return [
        add_contact(
            assembly, (one.part_a, one.a), (one.part_b, one.b), label=one.name, type=one.type
        )
        for one in found
        if not one.is_marked
    ]


def with_washers(assembly, found: list[FoundFeature], rings: int) -> list[list[int]]:
    """Return for each feature its vertices with those of a number of rings, sorted.

    Two features must not share vertices. Therefore rings stop before one that touches another
    feature or a region of the document.
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
    """Return the search result of the package, with object names as part names."""
    kernel.core()  # raises an error with a remedy if the kernel is unusable
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
        raise ValueError(f"{error}; finding.md describes the options.") from None
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
    """Return the cache of features found on the rest mesh of a part."""
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
    """Return the vertices of a part that already belong to form features."""
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
