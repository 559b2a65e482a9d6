# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the package as parts of an assembly."""

from __future__ import annotations

import os

from freecad.sheetmorph.api.assemblies import add_part
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.bridge.rest import write_rest_data


def add_mesh(assembly, mesh, label: str, features: list[dict] = (), *, of_deck: dict | None = None):
    """Add a sheetmorph.PartMesh as a part that keeps its double precision.

    `features` are its exact features, see `exact_features`. `of_deck` has its vertices in a deck
    and its elements, see `import_deck`.
    """
    origin = conversion.near_origin(mesh.points)
    source = assembly.Document.addObject("Mesh::Feature", "Rest")
    source.Label = f"{label} at rest"
    source.Mesh = conversion.MeshWriter(mesh.triangles).mesh(
        mesh.points - origin, conversion.shift(origin)
    )
    part = add_part(assembly, source, label)
    with conversion.temporary_folder() as folder:
        stored = os.path.join(folder, "rest.npz")
        write_rest_data(stored, mesh, origin, features, **(of_deck or {}))
        part.RestData = stored
    return part
