# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphs follow their source meshes where FreeCAD's dependencies do not tell of a change."""

from functools import lru_cache

import FreeCAD

from freecad.sheetmorph.kinds import DEFORMATION, kind


class SourceWatcher:
    """Document observer that makes morphs due whose sources look different.

    Two changes go unnoticed otherwise: FreeCAD counts a mesh as an output, so an edited mesh
    asks for no recompute; and a container, such as App::Part, moves what is in it without a
    word. A link to the container would help, but would make a cycle as soon as somebody drags
    the morph into the same container.
    """

    def slotChangedObject(self, obj, name: str) -> None:
        """FreeCAD calls this after every change of a property."""
        if name == "Mesh":
            touch_deformations_of(obj)
        elif name == "Placement" and obj.hasExtension("App::GeoFeatureGroupExtension"):
            for inner in obj.OutListRecursive:
                if inner.isDerivedFrom("Mesh::Feature"):
                    touch_deformations_of(inner)


@lru_cache(maxsize=1)
def watch() -> None:
    """Begin to watch: called by every morph, so that nobody pays for it who has none."""
    FreeCAD.addDocumentObserver(SourceWatcher())


def touch_deformations_of(source) -> None:
    """Make the deformations due that use this mesh at rest."""
    if source.Document.Restoring:
        return
    for user in source.InList:
        if kind(user) == DEFORMATION:
            user.touch()
