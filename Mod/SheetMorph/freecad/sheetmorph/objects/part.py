# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part: the deformed mesh of a source mesh that never changes."""

from __future__ import annotations

from freecad.sheetmorph.objects.errors import Fault, MorphError
from freecad.sheetmorph.objects.model import PART
from freecad.sheetmorph.objects.properties import HIDDEN, READ_ONLY, SHOWN, Property
from freecad.sheetmorph.objects.proxy import Execution, ObjectProxy, make_due


MODES = ["automatic", "1 all by control mesh", "2 regions", "3 boundaries"]
MODE_DOC = (
    "How a part other than the primary part follows. Automatic: chosen "
    "from its contacts and form features. 1: the control mesh drives every "
    "vertex; form features would lose their shape. 2: it drives contacts "
    "and followers; the rest bends like sheet metal, and form features "
    "stay exact. 3: as 2, with the free edges inside the control meshes"
)


THIN_NO, THIN_AUTOMATIC, THIN_GIVEN = THIN = ("no", "automatic", "of given thickness")
THIN_DOC = (
    "Treats a closed mesh as a thin solid: it is solved once as a sheet, "
    "and both skins keep the thickness. Automatic: if it is recognised as "
    "one"
)
SHEET_DOC = (
    "Sheet thickness for the energy steel. 0: that of the deck or the thin "
    "solid, or a hundredth of the size"
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
        Property("Length", "Thickness", "Part", "Thickness of a thin solid, if it is given"),
        Property("Length", "SheetThickness", "Part", SHEET_DOC),
        Property("Float", "Poisson", "Part", "Poisson's ratio for the energy steel", 0.3),
        Property("Link", "Deformation", "Part", "Object that computes the mesh", mode=HIDDEN),
        Property("String", "FileName", "Part", "File the part was read from", "", READ_ONLY),
        Property(
            "FileIncluded", "RestData", "Part", "Rest positions in double precision", mode=HIDDEN
        ),
        Property("LinkGlobal", "Original", "Part", "The mesh before its preparation", mode=HIDDEN),
        Property(
            "FileIncluded",
            "OriginalData",
            "Part",
            "Positions of the original mesh in double precision",
            mode=HIDDEN,
        ),
        Property("String", "Preparation", "Part", "Preparation of the mesh", "", HIDDEN),
        Property("String", "Differences", "Part", "Differences to the previous file", "{}", HIDDEN),
        Property("FileIncluded", "FileData", "Part", "Content of the file", mode=HIDDEN),
        Property("FileIncluded", "ShapeData", "Part", "The meshed CAD shape", mode=HIDDEN),
        Property(
            "LinkHidden",
            "ShapeSource",
            "Part",
            "The shape that the part was made from",
            mode=READ_ONLY,
        ),
        Property("String", "ShapeRead", "Part", "How the shape was read", "", HIDDEN),
        Property(
            "Bool", "SourceChanged", "Part", "Whether the shape has changed", False, HIDDEN, True
        ),
        Property("LinkHidden", "Deck", "Part", "The deck of the part", mode=READ_ONLY),
        Property("String", "DeckPart", "Part", "Name in the deck", "", HIDDEN),
        Property(
            "LinkListHidden", "Shells", "Part", "Properties of the deck in this part", mode=HIDDEN
        ),
        Property(
            "LinkHidden", "DeformedShape", "Part", "The deformed shape of the part", mode=READ_ONLY
        ),
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
            f"Part '{part.Label}' has lost its source mesh: undo that, or delete the part.", part
        )
    if part.Deformation is None:
        raise MorphError(
            f"Part '{part.Label}' is not in a morph: delete it and add its source to a morph.",
            part,
        )
    return part.Deformation.Proxy.mesh_of(part.Deformation, part)


def show_thickness(obj) -> None:
    """Show the thickness property only if the thickness is given."""
    if "Thickness" in obj.PropertiesList:
        obj.setEditorMode("Thickness", SHOWN if obj.Thin == THIN_GIVEN else HIDDEN)


def protect_placement(obj) -> None:
    """Make the placement read-only, because it follows the source."""
    obj.setEditorMode("Placement", READ_ONLY)
