# SPDX-License-Identifier: LGPL-2.1-or-later
"""The types of a contact and the modes of a part in a designer's words."""

from freecad.sheetmorph.qt import QtCore, translate
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

TYPES = ("control mesh", "tied", "rigid")
TYPE_NAMES = (
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Control mesh"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Tied"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Rigid"),
)
TYPE_TEXTS = (
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels",
        "The other part bends smoothly with it. Suits most flanges and weld " "seams.",
    ),
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels",
        "Every vertex keeps its position relative to the facing triangle. Suits "
        "glued faces and tied meshes.",
    ),
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels",
        "Both sides move as one rigid body. Suits bolts, rivets and spot welds.",
    ),
)
MODE_NAMES = (
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Automatic"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "1 Whole part driven"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "2 Contacts driven"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "3 Contacts and edges driven"),
)
MODE_TEXTS = (
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels", "SheetMorph chooses from the contacts and form features."
    ),
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels",
        "The control mesh drives every vertex; form features would lose their " "shape.",
    ),
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels",
        "The control mesh drives contacts and followers; the rest bends like "
        "sheet metal, and form features keep their shape.",
    ),
    QT_TRANSLATE_NOOP(
        "SheetMorph_panels", "As 2, and the control mesh also drives free edges inside it."
    ),
)


def fill(combo, names, texts) -> None:
    """Fill a combo box with names, each with its text as tooltip."""
    for index, (shown, text) in enumerate(zip(names, texts)):
        combo.addItem(translate("SheetMorph_panels", shown))
        combo.setItemData(index, translate("SheetMorph_panels", text), QtCore.Qt.ToolTipRole)
