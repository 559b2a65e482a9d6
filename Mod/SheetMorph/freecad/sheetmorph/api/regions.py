# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions: fixed vertices, handles, form features and followers."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence

import numpy as np

from freecad.sheetmorph.api.checks import indices, require_kind, require_part_of, vertex_count
from freecad.sheetmorph.api.motions import rest_centroid, set_rotation
from freecad.sheetmorph.bridge import kernel, selecting
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import FIXED, FOLLOWER, FORM_FEATURE, HANDLE, RegionProxy


def add_fixed(assembly, part, vertices: Iterable[int] | dict, label: str = "Fixed"):
    """Add a fixed region to `part` and return it: its vertices stay at rest.

    `vertices` are indices into the mesh of the part, at least one, or a selector (see `select`).
    Raises ValueError.
    """
    return add_region(assembly, part, vertices, (FIXED, label))


def add_handle(assembly, part, vertices: Iterable[int] | dict, label: str = "Handle"):
    """Add a handle to `part` and return it: `set_motion` moves its vertices.

    `vertices` are indices into the mesh of the part, at least one, or a selector (see `select`).
    Raises ValueError.
    """
    return add_region(assembly, part, vertices, (HANDLE, label))


def add_feature(
    assembly,
    part,
    vertices: Iterable[int] | dict,
    label: str = "Feature",
    *,
    rotation: str | Sequence = "free",
):
    """Add a form feature to `part` and return it: its vertices keep their exact shape.

    Parameters
    ----------
    assembly, part : object
        The assembly and the part.
    vertices : iterable of int or selector
        Indices into the mesh of the part, at least one, or a selector (see `select`).
    label : str
        Label of the region.
    rotation : str or tuple
        "free" (as a rigid body in an elastic sheet), "interpolated" (as the handles around it) or
        `(axis (3,), degrees)`.

    Raises
    ------
    ValueError
        For missing or unknown vertices, or another rotation.
    """
    region = add_region(assembly, part, vertices, (FORM_FEATURE, label))
    try:
        set_rotation(region, rotation)
    except ValueError:
        region.Document.removeObject(region.Name)
        raise
    return region


def add_follower(assembly, part, vertices: Iterable[int] | dict, label: str = "Follower"):
    """Add a follower to `part` and return it: a control mesh drives its vertices.

    It is for parts other than the primary, where more than their contacts should follow closely.
    `vertices` are indices into the mesh of the part, at least one, or a selector (see `select`).
    Raises ValueError.
    """
    return add_region(assembly, part, vertices, (FOLLOWER, label))


def add_region(assembly, part, vertices: Iterable[int] | dict, role_and_label: tuple[str, str]):
    """Add a region of any role, for `add_fixed`, `add_handle` and the others."""
    require_part_of(assembly, part)
    checked, where = vertices_and_words(part, vertices)
    role, label = role_and_label
    region = assembly.Document.addObject("App::FeaturePython", "Region")
    RegionProxy(region)
    region.Label = label
    region.Role = role
    region.Part = part
    model.set_vertices(region, checked, where)
    region.Pivot = rest_centroid(region)
    assembly.addObject(region)
    return region


def vertices_and_words(part, given) -> tuple[np.ndarray, str]:
    """Return the given vertices (k,), and the selector as JSON if it was one.

    Raises ValueError if it selects nothing or a vertex does not exist.
    """
    if not selecting.is_selector(given):
        return indices(given, vertex_count(part), "vertex"), ""
    vertex_count(part)  # checks that the part has a mesh
    found = selecting.select(part, given)
    return np.asarray(found, dtype=np.int64), json.dumps(given)


def select(part, where) -> list[int]:
    """Return the sorted vertices of a recipe selector on a part.

    Its coordinates are those of the part's file, mm. Raises ValueError if it is invalid or selects
    nothing.
    """
    require_kind(part, model.PART, "part")
    return vertices_and_words(part, where if selecting.is_selector(where) else [where])[0].tolist()


def where(owner, side: str = ""):
    """Return the selector of a region, or of side "a" or "b" of a contact; None without one."""
    if side in ("a", "b"):
        require_kind(owner, model.CONTACT, "contact")
    else:
        require_kind(owner, model.REGION, "region")
    return selecting.sentence_of(owner, side)


def set_vertices(region, vertices: Iterable[int] | dict) -> None:
    """Set the vertices of a region: indices into the mesh of its part, or a selector."""
    require_kind(region, model.REGION, "region")
    if region.Part is None:
        raise ValueError(f"Region '{region.Label}' has lost its part; delete the region.")
    model.set_vertices(region, *vertices_and_words(region.Part, vertices))
    if region.PivotAtCentroid:
        model.set_where_new(region, "Pivot", rest_centroid(region))


def take_out(region, other) -> None:
    """Remove from a region the vertices that it shares with another region on the same part.

    Raises ValueError if no vertex would remain.
    """
    for each in (region, other):
        require_kind(each, model.REGION, "region")
    if region.Part is None or region.Part != other.Part:
        raise ValueError(
            f"'{region.Label}' and '{other.Label}' are on different parts; pass two "
            "regions of one part."
        )
    left = np.setdiff1d(model.vertices(region), model.vertices(other))
    if len(left) == 0:
        raise ValueError(
            f"'{other.Label}' contains all vertices of '{region.Label}'; delete one of them."
        )
    set_vertices(region, left.tolist())


def hold_loose_pieces(part, label: str = "At rest"):
    """Fix the pieces of a part without prescribed vertices or contacts; return the new region.

    Raises ValueError if there are none.
    """
    require_kind(part, model.PART, "part")
    loose = loose_vertices(part)
    if len(loose) == 0:
        raise ValueError(
            f"Every piece of '{part.Label}' is already constrained; there is nothing to fix."
        )
    return add_fixed(model.assembly_of(part), part, loose.tolist(), label)


def loose_vertices(part) -> np.ndarray:
    """Return the vertices (k,) of the pieces without prescribed vertices or contacts."""
    assembly, rest, core = model.assembly_of(part), read_rest(part), kernel.core()
    piece = np.asarray(core.components(core.TriangleMesh(rest.points, rest.triangles)))
    regions = [r for r in model.regions(assembly, part) if r.Role in (FIXED, HANDLE)]
    held = [model.vertices(region) for region in regions]
    for contact in model.contacts(assembly, part):
        sides = (("a", contact.PartA), ("b", contact.PartB))
        held += [model.contact_vertices(contact, side) for side, owner in sides if owner == part]
    known = np.concatenate([np.zeros(0, dtype=np.int64), *held])
    known = known[known < len(piece)]
    return np.flatnonzero((piece >= 0) & ~np.isin(piece, piece[known]))


def vertices(region) -> list[int]:
    """Return the sorted vertex indices of a region in the mesh of its part."""
    require_kind(region, model.REGION, "region")
    return model.vertices(region).tolist()
