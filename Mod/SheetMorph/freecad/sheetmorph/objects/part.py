# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part: the deformed mesh of a source mesh that never changes."""

from __future__ import annotations

from freecad.sheetmorph.objects.errors import Fault, MorphError
from freecad.sheetmorph.objects.model import PART
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, SHOWN, Property
from freecad.sheetmorph.objects.proxy import Execution, ObjectProxy, make_due


MODES = ["automatic", "1 all by control mesh", "2 regions", "3 boundaries"]
MODE_DOC = (
    "How a part other than the primary follows. Automatic: chosen from its contacts and form "
    "features. 1: every vertex goes with the control mesh; form features would lose their shape. "
    "2: contacts and followers go with it, the rest bends like sheet and form features stay "
    "exact. 3: as 2, with the free edges inside the control meshes"
)


THIN_NO, THIN_AUTOMATIC, THIN_GIVEN = THIN = ("no", "automatic", "of given thickness")
THIN_DOC = (
    "Whether a closed mesh is a thin solid: solved once as a sheet, both skins and the walls "
    "follow and keep the thickness. Automatic: if it is recognised as one"
)
SHEET_DOC = (
    "How thick the sheet is where the energy is steel; 0: as the deck or the thin solid, or a "
    "hundredth of the size"
)
DECISIVE = ("Mode", "Thin", "Thickness", "SheetThickness", "Poisson")
"""Properties on which the deformation depends."""


class PartProxy(ObjectProxy):
    """Proxy of a part; its mesh lies exactly over the source, whatever contains either."""

    Type = PART
    PROPERTIES = (
        Property("LinkGlobal", "Source", "Part", "The mesh at rest, never changed", mode=READ_ONLY),
        Property("Enumeration", "Mode", "Part", MODE_DOC, MODES),
        Property("Enumeration", "Thin", "Part", THIN_DOC, list(THIN)),
        Property("Length", "Thickness", "Part", "Of a thin solid whose thickness is given"),
        Property("Length", "SheetThickness", "Part", SHEET_DOC),
        Property(
            "Float", "Poisson", "Part", "Poisson's ratio, read where the energy is steel", 0.3
        ),
        Property("Link", "Deformation", "Part", "What the mesh depends on", mode=HIDDEN),
        Property("String", "FileName", "Part", "File the part was read from", "", READ_ONLY),
        Property("FileIncluded", "RestData", "Part", "Rest positions in double", mode=HIDDEN),
        Property("LinkGlobal", "Original", "Part", "The mesh before it was prepared", mode=HIDDEN),
        Property("FileIncluded", "OriginalData", "Part", "Its positions in double", mode=HIDDEN),
        Property("String", "Preparation", "Part", "What was done to the mesh", "", HIDDEN),
        Property("String", "Differences", "Part", "What another file changed", "{}", HIDDEN),
        Property("FileIncluded", "FileData", "Part", "The file as it was read", mode=HIDDEN),
        Property("FileIncluded", "ShapeData", "Part", "The CAD shape that was meshed", mode=HIDDEN),
        Property("LinkHidden", "ShapeSource", "Part", "The shape it was made from", mode=READ_ONLY),
        Property("String", "ShapeRead", "Part", "How that was read", "", HIDDEN),
        Property("Bool", "SourceChanged", "Part", "It is another one now", False, HIDDEN, True),
        Property("LinkHidden", "Deck", "Part", "The deck that it is in", mode=READ_ONLY),
        Property("String", "DeckPart", "Part", "What the deck calls it", "", HIDDEN),
        Property("LinkListHidden", "Shells", "Part", "Its properties", mode=HIDDEN),
        Property("LinkHidden", "DeformedShape", "Part", "Its shape, deformed", mode=READ_ONLY),
    )

    def __init__(self, obj):
        super().__init__(obj)
        protect_placement(obj)
        show_thickness(obj)

    def onDocumentRestored(self, obj) -> None:
        super().onDocumentRestored(obj)
        protect_placement(obj)
        show_thickness(obj)

    def onChanged(self, obj, name: str) -> None:
        """Pass a change on to the deformation, which does not depend on its parts."""
        if name == "Thin":
            show_thickness(obj)
        if name in DECISIVE and "Deformation" in obj.PropertiesList and not obj.Document.Restoring:
            make_due(obj.Deformation)

    execute = Execution()
    fault: Fault | None = None

    def computed(self, obj) -> MorphError | None:
        """Take the deformed mesh; after an error the last mesh stays."""
        self.fault = None
        try:
            obj.Mesh = deformed_mesh(obj)
        except MorphError as error:
            self.fault = error.fault
            return error.with_traceback(None)
        return None


def deformed_mesh(part):
    """Return the mesh of a part in the pose of its morph. Raises MorphError."""
    if part.Source is None:
        raise MorphError(
            f"Part '{part.Label}' has lost its source mesh: undo that or delete the part.", part
        )
    if part.Deformation is None:
        raise MorphError(
            f"Part '{part.Label}' is in no morph: delete it and add its source to a morph.", part
        )
    return part.Deformation.Proxy.mesh_of(part.Deformation, part)


def show_thickness(obj) -> None:
    """Show the thickness property only if the thickness is given."""
    if "Thickness" in obj.PropertiesList:
        obj.setEditorMode("Thickness", SHOWN if obj.Thin == THIN_GIVEN else HIDDEN)


def protect_placement(obj) -> None:
    """Make the placement read-only, because it follows the source."""
    obj.setEditorMode("Placement", READ_ONLY)
