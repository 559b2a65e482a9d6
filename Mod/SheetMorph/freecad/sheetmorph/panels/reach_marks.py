# SPDX-License-Identifier: LGPL-2.1-or-later
"""The possible range of the changed value as a scale in the Move Handle panel."""

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels.base import say
from freecad.sheetmorph.qt import QtCore, QtGui, connect, translate
from freecad.sheetmorph.tools import studies, words
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP
from freecad.sheetmorph.tools.motion import Motion
from freecad.sheetmorph.tools.reach_scale import scale_for

CALM = 300  # ms without a change until the search, and between two attempts to start it
HEIGHT, GROOVE = 18, 6  # px
POSSIBLE, BEYOND = "#2e9e5b", "#d64545"  # on any theme
NUMBERS = ("X", "Y", "Z", QT_TRANSLATE_NOOP("SheetMorph_panels", "Angle"))
HINT = QT_TRANSLATE_NOOP("SheetMorph_panels", "Change one value to see its admissible range.")
SEARCHING = QT_TRANSLATE_NOOP("SheetMorph_panels", "Searching the admissible range…")
FLIPS = QT_TRANSLATE_NOOP("SheetMorph_panels", "{0}; beyond this, triangles flip")


def criteria_of(assembly) -> dict:
    """Return the criteria of a morph's last study; flipped triangles always fail."""
    for study in reversed(model.studies(assembly)):
        try:
            return studies.criteria_in(study.Criteria)
        except ValueError:
            continue
    return {}


class ReachMarks(QtCore.QObject):
    """A scale of the number that changed last, red where a value is impossible.

    `ask(number, criteria)` requests the range and returns False if that has to wait. `on_reached`
    receives the answer.
    """

    def __init__(self, form, criteria: dict, ask):
        super().__init__()
        self._form, self._criteria, self._ask = form, criteria, ask
        self._number, self._value, self._reached = None, 0.0, None
        self._calm = QtCore.QTimer(self, singleShot=True, interval=CALM)
        connect(self._calm, "timeout()", self._look)
        form.reach_text.setFixedHeight(2 * form.fontMetrics().lineSpacing())
        form.reach_text.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop)
        self._show()

    def follow(self, moving, before: Motion | None) -> None:
        """Handle a changed value, and remove the marks of another value, handle or pose.

        The range is that of a global number, so there is none along other axes.
        """
        if before is None or not moving.is_global:
            self.forget()
            return
        now = moving.motion
        pairs = zip((*before.translation, before.angle), (*now.translation, now.angle))
        changed = [k for k, (old, new) in enumerate(pairs) if old != new]
        is_one = len(changed) == 1 and (before.axis, before.pivot) == (now.axis, now.pivot)
        number = changed[0] if is_one else None
        if number is None or number != self._number:
            self._reached = None
        self._number = number
        if number is not None:
            self._value = (*now.translation, now.angle)[number]
            if self._reached is None:
                self._calm.start()
        self._show()

    def forget(self) -> None:
        """Remove the marks, because the handle or the pose has changed."""
        self.stop()
        self._number = self._reached = None
        self._show()

    def stop(self) -> None:
        """Request nothing until the next change."""
        self._calm.stop()

    def on_reached(self, reached) -> None:
        """Show the range; None means that another question came first, so search again."""
        if reached is None:
            self._calm.start()
        elif reached.question.number == self._number:
            self._reached = reached
            self._show()

    def _look(self) -> None:
        is_due = self._number is not None and self._reached is None
        if is_due and not self._ask(self._number, self._criteria):
            self._calm.start()

    def _show(self) -> None:
        form = self._form
        if self._number is None or self._reached is None or not self._reached.ends:
            form.reach.setPixmap(QtGui.QPixmap())
            is_due = self._number is not None and self._reached is None
            hint = SEARCHING if is_due else HINT
            say(form.reach_text, translate("SheetMorph_panels", hint))
            return
        form.reach.setPixmap(self._picture())
        say(form.reach_text, self._text())

    def _text(self) -> str:
        """Return the range, and what fails at the value or beyond the nearer end."""
        (low, high), whys = self._reached.ends, self._reached.whys
        unit = "°" if self._number == len(NUMBERS) - 1 else " mm"
        number = translate("SheetMorph_panels", NUMBERS[self._number])
        values = number, words.plain(low), words.plain(high), unit
        is_upper = abs(high - self._value) < abs(low - self._value)
        why = whys[is_upper] or whys[not is_upper]
        if not why:
            return translate("SheetMorph_panels", "{0}: at least {1} to {2}{3}").format(*values)
        text = translate("SheetMorph_panels", "{0}: {1} to {2}{3}").format(*values)
        if getattr(why, "code", "") == "flipped":
            return translate("SheetMorph_panels", FLIPS).format(text)
        return translate("SheetMorph_panels", "{0}; beyond this: {1}").format(text, why)

    def _picture(self):
        """Return the scale as a QPixmap as wide as its label."""
        ends, whys = self._reached.ends, self._reached.whys
        ratio = self._form.reach.devicePixelRatioF()
        width = max(60, self._form.reach.width())
        picture = QtGui.QPixmap(round(width * ratio), round(HEIGHT * ratio))
        picture.setDevicePixelRatio(ratio)
        picture.fill(QtCore.Qt.transparent)
        scale = scale_for(ends, (bool(whys[0]), bool(whys[1])), self._value)
        low, high, zero, here = (
            round(scale.place(value) * (width - 9)) + 4 for value in (*ends, 0.0, self._value)
        )
        painter = QtGui.QPainter(picture)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        text = self._form.palette().color(QtGui.QPalette.WindowText)
        top = HEIGHT - GROOVE - 2
        painter.fillRect(4, top, width - 9, GROOVE, QtGui.QColor(BEYOND))
        painter.fillRect(low, top, high - low, GROOVE, QtGui.QColor(POSSIBLE))
        painter.fillRect(zero, top - 2, 1, GROOVE + 4, text)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(text)
        corners = ((here - 5, 1), (here + 5, 1), (here, top))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in corners]))
        painter.end()
        return picture
