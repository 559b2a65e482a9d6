# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts as they are seen now, for picking."""

from freecad.sheetmorph import api, conversion, kernel
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools.part_mesh import PartMesh


def part_mesh(part) -> PartMesh:
    """What can be picked on a part where it is seen now, deformed and placed, global mm."""
    rotation, base = api.global_frame(part)
    local = conversion.read_mesh(part.Mesh)[0].astype(float)
    return PartMesh(kernel.core(), api.rest_mesh(part), local @ rotation.T + base)


def part_meshes(assembly) -> dict[str, PartMesh]:
    """The same for every part of a morph, by object name."""
    return {part.Name: part_mesh(part) for part in model.parts(assembly)}


def triangles(part):
    """The triangles (m, 3) of a part as they are drawn."""
    return conversion.read_mesh(part.Mesh)[1]
