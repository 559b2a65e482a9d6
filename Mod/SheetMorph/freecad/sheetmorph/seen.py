# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts as they are seen now, for picking."""

from freecad.sheetmorph.api.picking import mesh_as_seen
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools.part_mesh import PartMesh


def part_meshes(assembly) -> dict[str, PartMesh]:
    """What can be picked, for every part of a morph, by object name."""
    return {part.Name: mesh_as_seen(part) for part in model.parts(assembly)}


def visible_meshes(assembly, part) -> dict[str, PartMesh]:
    """The same for those parts of a morph that are shown, and for one part in any case."""
    shown = [p for p in model.parts(assembly) if p == part or p.ViewObject.Visibility]
    return {each.Name: mesh_as_seen(each) for each in shown}


def triangles(part):
    """The triangles (m, 3) of a part as they are drawn."""
    return snapshot_of(part).triangles
