# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line in FreeCAD's status bar that says which shape is computed, with a button to stop it."""

import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets, connect, translate

WIDTH = 120  # px of the bar


class FinishingBar:
    """Shown until ``remove`` is called."""

    def __init__(self, stop):
        """``stop()`` is called when the user does not want to wait."""
        self._row = QtWidgets.QWidget()
        self._row.setObjectName("SheetMorphFinishing")
        row = QtWidgets.QHBoxLayout(self._row)
        row.setContentsMargins(0, 0, 0, 0)
        self._text = QtWidgets.QLabel(self._row)
        self._bar = QtWidgets.QProgressBar(self._row)
        self._bar.setMaximumWidth(WIDTH)
        self._bar.setRange(0, 0)
        self._percent = 0
        self._button = QtWidgets.QPushButton(translate("SheetMorph_panels", "Stop"), self._row)
        self._button.setObjectName("stop_finishing")
        self._button.setToolTip(
            translate(
                "SheetMorph_panels",
                "Stops computing; a recompute of the document computes the shape.",
            )
        )
        connect(self._button, "clicked()", stop)
        for widget in (self._text, self._bar, self._button):
            row.addWidget(widget)
        Gui.getMainWindow().statusBar().addPermanentWidget(self._row)
        self._row.show()

    def tell(self, label: str, task: str, percent: int) -> None:
        """Shows the name of a morph, what is under way and how much of it is done."""
        text = translate("SheetMorph_panels", "Computing the final shape of {0}").format(label)
        self._text.setText(f"{text}: {task}" if task else text)
        if percent != self._percent:  # setValue repaints the whole window at once
            self._percent = percent
            self._bar.setRange(0, 100 if percent else 0)
            self._bar.setValue(percent)

    def remove(self) -> None:
        """Takes it out of the status bar."""
        Gui.getMainWindow().statusBar().removeWidget(self._row)
        self._row.deleteLater()
