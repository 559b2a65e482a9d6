# SPDX-License-Identifier: LGPL-2.1-or-later
"""The types of a contact and the modes of a part, in a designer's words."""

from freecad.sheetmorph.qt import QtCore

TYPES = ("control mesh", "tied", "rigid")
TYPE_NAMES = ("Control mesh", "Tied", "Rigid")
TYPE_TEXTS = (
    "The other part bends along smoothly. Right for most flanges and weld seams.",
    "Every vertex keeps its place over the facing triangle. For glued faces and mesh ties.",
    "Both sides move as one stiff body. For bolts, rivets and spot welds.",
)
MODE_NAMES = ("Automatic", "1 Whole part", "2 Contacts lead", "3 Contacts and edges lead")
MODE_TEXTS = (
    "SheetMorph chooses by contacts and form features.",
    "The control mesh moves every vertex; form features would lose their shape.",
    "Contacts and followers go with the control mesh, the rest bends like sheet; form features "
    "keep their shape.",
    "As 2, and free edges inside the control mesh go with it too.",
)


def fill(combo, names, texts) -> None:
    """Fills a combo box with names, each with its text as tooltip."""
    for index, (shown, text) in enumerate(zip(names, texts)):
        combo.addItem(shown)
        combo.setItemData(index, text, QtCore.Qt.ToolTipRole)
