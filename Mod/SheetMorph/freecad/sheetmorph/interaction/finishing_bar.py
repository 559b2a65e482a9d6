# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line in FreeCAD's status bar that names the shape being computed, with a stop button."""

import FreeCADGui as Gui

from freecad.sheetmorph.qt import QtWidgets, connect, translate

WIDTH = 120  # px of the bar


class FinishingBar:
    """The line in the status bar until `remove`."""

    def __init__(self, stop):
        """Show the line; the button calls `stop()`."""
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
                "Stops the computation. Recompute the document to get the shape.",
            )
        )
        connect(self._button, "clicked()", stop)
        for widget in (self._text, self._bar, self._button):
            row.addWidget(widget)
        Gui.getMainWindow().statusBar().addPermanentWidget(self._row)
        self._row.show()

    def tell(self, label: str, task: str, percent: int) -> None:
        """Show the name of a morph, its present task and the progress."""
        text = translate("SheetMorph_panels", "Computing the final shape of {0}").format(label)
        self._text.setText(f"{text}: {task}" if task else text)
        if percent != self._percent:  # setValue repaints the whole window at once
            self._percent = percent
            self._bar.setRange(0, 100 if percent else 0)
            self._bar.setValue(percent)

    def remove(self) -> None:
        """Remove the line from the status bar."""
        Gui.getMainWindow().statusBar().removeWidget(self._row)
        self._row.deleteLater()
