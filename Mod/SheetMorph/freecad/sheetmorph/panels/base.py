# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of task panels."""

import FreeCADGui as Gui

from freecad.sheetmorph import paths
from freecad.sheetmorph.bridge.faults import fault_of
from freecad.sheetmorph.interaction.finishing import finishing
from freecad.sheetmorph.panels.notices import Notices
from freecad.sheetmorph.panels.number_field import loaded
from freecad.sheetmorph.qt import QtCore, QtWidgets, forget, icon_of, number, translate, widen
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

LEGEND = {
    "fixed": QT_TRANSLATE_NOOP("SheetMorph_panels", "Fixed"),
    "handle": QT_TRANSLATE_NOOP("SheetMorph_panels", "Handle"),
    "form feature": QT_TRANSLATE_NOOP("SheetMorph_panels", "Form feature"),
    "follower": QT_TRANSLATE_NOOP("SheetMorph_panels", "Follower"),
}
WIDTH = 340  # px at which a panel is readable
# on any theme
FAULT_STYLE = "color: #8f1d1d; background: #fde7e7; padding: 3px; border-radius: 3px;"
# Has its own frame and ground: Qt caches every drawing of a button with only a colour of its own.
CHOSEN = (
    "QToolButton:checked, QPushButton:checked { border: 2px solid #4a90d9; border-radius: 3px;"
    " background: rgba(74, 144, 217, 70); }"
)
MARGINS = 110  # px of the task view around a panel, with its scroll bar


class Panel:
    """A task panel with OK and Cancel; subclasses define `keep` and the widgets.

    Its editing session owns what the panel shows and changes. However the panel closes, the session
    ends; however the session ends, the panel closes.
    """

    width = WIDTH
    lines = 3  # of text in the strip at the top

    def __init__(self, session, widgets: str, icon: str, title: str):
        self.session = session
        self._form = loaded(paths.panel(widgets))
        self.form.setWindowTitle(translate(f"SheetMorph_{widgets}", title))
        self.form.setWindowIcon(icon_of(paths.icon(icon)))
        self.notices = None
        if hasattr(self.form, "message"):
            self.notices = Notices(self.form, self.lines)
        for name, widget in vars(self.form).items():
            if isinstance(widget, QtWidgets.QWidget) and not name.startswith("_"):
                widget.setWhatsThis(widget.whatsThis() or widget.toolTip())
                widget.setStatusTip(widget.statusTip() or widget.toolTip())

    @classmethod
    def opened(cls, session, *arguments):
        """Show a new panel in a session and return it; end the session if that fails.

        Returns None if the session has ended already, because a slow search handles events.
        """
        try:
            panel = cls(session, *arguments)
            if session.is_ending:
                session.end()
                return None
            panel.present()
        except BaseException:
            session.end()
            raise
        return panel

    @property
    def form(self):
        """The widgets, None as soon as the panel is closed."""
        return self._form

    @form.setter
    def form(self, form) -> None:
        """Release the widgets; FreeCAD sets the form to None before it deletes them."""
        taken, self._form = self._form, form
        if taken is not None and form is None:
            self.session.end()
            forget(taken)

    def present(self) -> None:
        """Show the panel, in a task view wide enough to read it.

        Where the selection has no meaning, its colour would hide other colours, so it is put aside.
        """
        if not self.isAllowedAlterSelection():
            self.session.put_selection_aside()
        if hasattr(self.session, "document"):
            finishing().hold(self.session)
            self.session.over.connect(self._release)  # Qt would keep a plain function for ever
        self.session.ending.connect(self._fade)
        self.session.over.connect(self._close)
        Gui.Control.showDialog(self)
        QtCore.QTimer.singleShot(0, self._widen)

    def getStandardButtons(self) -> int:
        """Return OK and Cancel."""
        buttons = QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel
        return number(buttons)

    def isAllowedAlterSelection(self) -> bool:
        """Return False, because the selection has no meaning while a panel is open."""
        return False

    def isAllowedAlterDocument(self) -> bool:
        """Return False, because other commands would join the panel's transaction."""
        return False

    def isAllowedAlterView(self) -> bool:
        """Return True, so that the user can turn and zoom."""
        return True

    def accept(self) -> bool:
        """Handle OK: close the panel if `keep` succeeds."""
        if not self.session.is_over and not self.keep():
            return False
        self.session.end()
        return True

    def reject(self) -> bool:
        """Handle Cancel: end the session, which undoes pending changes."""
        self.session.end()
        return True

    def keep(self) -> bool:
        """Store the result in the document; return False after reporting what is missing."""
        return True

    def _fade(self) -> None:
        """Disable the widgets that are about to vanish."""
        if self.form is not None:
            self.form.setEnabled(False)

    def _release(self) -> None:
        """Allow new shapes in the document again."""
        finishing().release(self.session)

    def _close(self) -> None:
        if self.form is not None:
            Gui.Control.closeDialog()

    def _widen(self) -> None:
        """Widen the dock around the panel if it is too narrow."""
        for dock in Gui.getMainWindow().findChildren(QtWidgets.QDockWidget):
            if self.form and dock.isAncestorOf(self.form):
                wanted = max(self.width, self.form.minimumSizeHint().width() + MARGINS)
                self.session.at_end(widen(dock, wanted))


def say(label, text: str, is_error: bool = False) -> None:
    """Show a sentence in a label, an error on red; an empty one hides the label."""
    label.setText(text)
    label.setStyleSheet(FAULT_STYLE if is_error else "")
    label.setVisible(bool(text))


def say_error(label, error: Exception) -> None:
    """Show the fault of an error in a label."""
    say(label, fault_of(error), True)


def listed(texts: list[str]) -> str:
    """Return several sentences as a list with bullets."""
    return "\n".join(texts) if len(texts) < 2 else "\n".join(f"• {text}" for text in texts)


def vertices_said(count: int) -> str:
    """Return a number of vertices as text."""
    if count == 1:
        return translate("SheetMorph_panels", "1 vertex")
    return translate("SheetMorph_panels", "{0} vertices").format(count)


def legend(active: str) -> str:
    """Return the colours of the roles as rich text, the active role in bold."""
    chips = []
    for role, name in LEGEND.items():
        if role == "follower" and role != active:
            continue
        text = translate("SheetMorph_panels", name).replace(" ", "&nbsp;")
        shown = f"<b>{text}</b>" if role == active else text
        chips.append(f"{chip(colours.ROLES[role])}&nbsp;{shown}")
    return "&nbsp;&nbsp; ".join(chips)


def chip(colour) -> str:
    """Return a small coloured square as rich text."""
    return f'<span style="color:{colours.css(colour)}">&#9632;</span>'
