# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphs follow what FreeCAD does not tell them of: changed source meshes, deletions in no step."""

from functools import lru_cache

import FreeCAD

from freecad.sheetmorph.kinds import ASSEMBLY, DEFORMATION, kind
from freecad.sheetmorph.objects import shape_source


class SourceWatcher:
    """Document observer that makes morphs due whose sources look different, and tells when the
    shape that a part was made from was edited.

    Two changes go unnoticed otherwise: FreeCAD counts a mesh as an output, so an edited mesh
    asks for no recompute; and a container, such as App::Part, moves what is in it without a
    word. A link to the container would help, but would make a cycle as soon as somebody drags
    the morph into the same container.
    """

    def slotChangedObject(self, obj, name: str) -> None:
        """FreeCAD calls this after every change of a property."""
        if name == "Mesh":
            touch_deformations_of(obj)
        elif name == "Shape":
            shape_source.note_change(obj)
        elif name == "Placement" and obj.hasExtension("App::GeoFeatureGroupExtension"):
            for inner in obj.OutListRecursive:
                if inner.isDerivedFrom("Mesh::Feature"):
                    touch_deformations_of(inner)

    def slotDeletedObject(self, obj) -> None:
        """FreeCAD calls this before an object goes.

        What goes in no undo step, as by a line of a macro, is gone for good, but the groups of
        earlier steps still hold it: FreeCAD would die of the next undo. So those steps go too.
        """
        document = obj.Document
        is_in_step = document.HasPendingTransaction or document.Transacting
        if not is_in_step and any(kind(group) == ASSEMBLY for group in obj.InList):
            document.clearUndos()


@lru_cache(maxsize=1)
def watch() -> None:
    """Begin to watch: called by every morph, so that nobody pays for it who has none."""
    FreeCAD.addDocumentObserver(SourceWatcher())


def is_watching() -> bool:
    """Whether there has been a morph since the program began."""
    return watch.cache_info().currsize > 0


def touch_deformations_of(source) -> None:
    """Make the deformations due that use this mesh at rest."""
    if source.Document.Restoring:
        return
    for user in source.InList:
        if kind(user) == DEFORMATION:
            user.touch()
