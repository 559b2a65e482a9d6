# SPDX-License-Identifier: LGPL-2.1-or-later
"""The control meshes to show."""

from freecad.sheetmorph.objects import model


def collect(assembly, ask, chosen=()) -> list:
    """Return the control meshes (vertices, triangles) of chosen contacts, else of all.

    A morph with a single control mesh gives that one. `ask(contact or None)` answers as
    `api.control_mesh`.
    """
    if assembly.Propagation == "single":
        wanted = [None]
    else:
        wanted = list(chosen) or model.contacts(assembly)
    found = [ask(contact) for contact in wanted]
    return [mesh for mesh in found if mesh is not None]
