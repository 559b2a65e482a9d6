# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fault of a morph in a panel: one sentence, with buttons that show and repair it."""

import FreeCAD as App

from freecad.sheetmorph import actions, mending
from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.bridge.faults import fault_of
from freecad.sheetmorph.panels.base import say
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import Highlight
from freecad.sheetmorph.scene.looking import look_at


MOST_PAINTED = 50_000  # vertices that are painted without a question


class FaultBar(QtCore.QObject):
    """The fault in a panel's label `message`; `mended` is sent after a repair.

    With `paints`, the place of a new fault is red at once, unless it is too large to paint quickly.
    """

    mended = QtCore.Signal()

    def __init__(self, form, session, assembly, *, paints: bool = False):
        """Create the buttons next to the label."""
        super().__init__()
        self._paints = paints
        self._label, self._assembly, self._session = form.message, assembly, session
        self._fault, self._cure, self._text = None, None, ""
        self._highlight = session.show(Highlight())
        self._row = QtWidgets.QWidget(form)
        buttons = QtWidgets.QVBoxLayout(self._row)
        buttons.setContentsMargins(0, 0, 0, 0)
        buttons.setSpacing(2)
        self._show = self._button(
            "show_fault", translate("SheetMorph_panels", "Show"), self._show_it
        )
        self._mend = self._button("mend_fault", "", self._mend_it)
        beside = form.message.parentWidget().layout()
        beside.insertWidget(beside.indexOf(form.message) + 1, self._row)
        self.say("")

    def say(self, wrong) -> None:
        """Show a fault or an error, and write it to the report view once; empty hides it."""
        fault = fault_of(wrong)
        is_new = self._fault is None or not fault.is_same(self._fault)
        if is_new:
            self._text = str(fault)
            if isinstance(wrong, Exception):
                self._text = actions.reported(wrong)
            elif fault:
                App.Console.PrintError(f"SheetMorph: {fault}\n")
        say(self._label, self._text, bool(self._text))
        if not is_new:
            return
        self._fault = fault
        self._highlight.clear()
        self._cure = mending.cure_of(self._assembly, fault)
        self._mend.setText(self._cure[0] if self._cure else "")
        self._mend.setVisible(self._cure is not None)
        places = mending.places(self._assembly, fault)
        is_shown = bool(places)
        if self._paints and sum(len(vertices) for _, vertices in places) <= MOST_PAINTED:
            self._paint(places)
        self._show.setVisible(is_shown)
        self._row.setVisible(is_shown or self._cure is not None)

    def _show_it(self, *_) -> None:
        """Highlight the place of the fault, and move the camera to it."""
        places = mending.places(self._assembly, self._fault)
        self._paint(places)
        look_at(self._session.view, seen.positions(places))

    def _paint(self, places) -> None:
        self._highlight.clear()
        for part, vertices in places:
            shown = seen.triangles(part)
            self._highlight.paint(part.ViewObject, shown, colours.FAULT, vertices)

    def _mend_it(self, *_) -> None:
        """Repair after the click, because the repair may change this panel."""
        QtCore.QTimer.singleShot(0, self._mend_now)

    def _mend_now(self) -> None:
        title, line = self._cure
        with self._session.aside():
            is_done = actions.attempt(title, line, document=self._assembly.Document)
        if is_done:
            self.say("")
            self.mended.emit()

    def _button(self, object_name: str, text: str, action):
        button = QtWidgets.QPushButton(text, self._row)
        button.setObjectName(object_name)
        connect(button, "clicked()", action)
        self._row.layout().addWidget(button)
        return button
