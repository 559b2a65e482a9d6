# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document observer for changes that FreeCAD does not report to morphs."""

from functools import lru_cache

import FreeCAD

from freecad.sheetmorph.kinds import ASSEMBLY, DEFORMATION, kind
from freecad.sheetmorph.objects import shape_source


class SourceWatcher:
    """Document observer that touches morphs with changed sources and reports edited shapes.

    Two changes would otherwise go unnoticed. FreeCAD treats a mesh as an output, so that an edited
    mesh requests no recompute. A container, such as App::Part, moves its content without
    notification. A link to the container would create a cycle as soon as the user drags the morph
    into the same container.
    """

    def slotChangedObject(self, obj, name: str) -> None:
        """Handle the change of a property."""
        if name == "Mesh":
            touch_deformations_of(obj)
        elif name == "Shape":
            shape_source.note_change(obj)
        elif name == "Placement" and obj.hasExtension("App::GeoFeatureGroupExtension"):
            for inner in obj.OutListRecursive:
                if inner.isDerivedFrom("Mesh::Feature"):
                    touch_deformations_of(inner)

    def slotDeletedObject(self, obj) -> None:
        """Handle an object before its deletion.

        A deletion outside an undo step, as by a line of a macro, is final. But groups in earlier
        steps still contain the object, and FreeCAD would crash at the next undo. Therefore those
        steps are cleared.
        """
        document = obj.Document
        is_in_step = document.HasPendingTransaction or document.Transacting
        if not is_in_step and any(kind(group) == ASSEMBLY for group in obj.InList):
            document.clearUndos()


@lru_cache(maxsize=1)
def watch() -> None:
    """Start the observer with the first morph, so that other documents have no overhead."""
    FreeCAD.addDocumentObserver(SourceWatcher())


def is_watching() -> bool:
    """Return whether there was a morph since the program started."""
    return watch.cache_info().currsize > 0


def touch_deformations_of(source) -> None:
    """Touch the deformations that use this mesh at rest."""
    if source.Document.Restoring:
        return
    for user in source.InList:
        if kind(user) == DEFORMATION:
            user.touch()
