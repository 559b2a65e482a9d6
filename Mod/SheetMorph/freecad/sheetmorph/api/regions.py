# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions: vertices of a part that are fixed, moved by a handle, keep their shape, or follow."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from freecad.sheetmorph.api.checks import indices, require_kind, require_part_of, vertex_count
from freecad.sheetmorph.api.motions import rest_centroid, set_rotation
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import FIXED, FOLLOWER, FORM_FEATURE, HANDLE, RegionProxy


def add_fixed(assembly, part, vertices: Iterable[int], label: str = "Fixed"):
    """Add a fixed region to `part` and return it: its vertices stay where they are.

    `vertices`: indices into the mesh of the part, at least one. Raises ValueError.
    """
    return add_region(assembly, part, vertices, (FIXED, label))


def add_handle(assembly, part, vertices: Iterable[int], label: str = "Handle"):
    """Add a handle to `part` and return it: its vertices move as `set_motion` says.

    `vertices`: indices into the mesh of the part, at least one. Raises ValueError.
    """
    return add_region(assembly, part, vertices, (HANDLE, label))


def add_feature(
    assembly,
    part,
    vertices: Iterable[int],
    label: str = "Feature",
    *,
    rotation: str | Sequence = "free",
):
    """Add a form feature to `part` and return it: its vertices keep their shape exactly.

    `rotation`: "free" (turns as a rigid body in an elastic sheet), "interpolated" (as the handles
    around it turn) or `(axis (3,), degrees)`.
    Raises ValueError: no or unknown vertices, another rotation.
    """
    region = add_region(assembly, part, vertices, (FORM_FEATURE, label))
    try:
        set_rotation(region, rotation)
    except ValueError:
        region.Document.removeObject(region.Name)
        raise
    return region


def add_follower(assembly, part, vertices: Iterable[int], label: str = "Follower"):
    """Add a follower to `part` and return it: its vertices go where a control mesh takes them.

    For parts other than the primary, where more than their contacts should follow closely.
    `vertices`: indices into the mesh of the part, at least one. Raises ValueError.
    """
    return add_region(assembly, part, vertices, (FOLLOWER, label))


def add_region(assembly, part, vertices: Iterable[int], role_and_label: tuple[str, str]):
    """Add a region of any role; what `add_fixed`, `add_handle` and the others share."""
    require_part_of(assembly, part)
    checked = indices(vertices, vertex_count(part), "vertex")
    role, label = role_and_label
    region = assembly.Document.addObject("App::FeaturePython", "Region")
    RegionProxy(region)
    region.Label = label
    region.Role = role
    region.Part = part
    model.set_vertices(region, checked)
    region.Pivot = rest_centroid(region)
    assembly.addObject(region)
    return region


def set_vertices(region, vertices: Iterable[int]) -> None:
    """Give a region other vertices, indices into the mesh of its part, at least one."""
    require_kind(region, model.REGION, "region")
    if region.Part is None:
        raise ValueError(f"Region '{region.Label}' has lost its part; delete the region.")
    model.set_vertices(region, indices(vertices, vertex_count(region.Part), "vertex"))
    if region.PivotAtCentroid:
        region.Pivot = rest_centroid(region)


def vertices(region) -> list[int]:
    """Return the vertices of a region: sorted indices into the mesh of its part."""
    require_kind(region, model.REGION, "region")
    return model.vertices(region).tolist()
