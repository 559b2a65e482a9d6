# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels with proposals: a list with check boxes, filters and tolerances."""

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.bridge import seen
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import find_table, keeping
from freecad.sheetmorph.panels.base import Panel, say, say_error
from freecad.sheetmorph.panels.fault_bar import FaultBar
from freecad.sheetmorph.panels.find_kinds import CONTACTS, FEATURES
from freecad.sheetmorph.panels.folding import Folds
from freecad.sheetmorph.qt import QtCore, connect, translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.highlight import Highlight
from freecad.sheetmorph.scene.looking import look_at
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

ANY = QT_TRANSLATE_NOOP("SheetMorph_panels", "all kinds")


def open_features(assembly, parts=None):
    """Open the panel with features of a morph, or of some parts, and return it."""
    return _opened(assembly, FEATURES, parts)


def open_contacts(assembly, parts=None):
    """Open the panel with contacts of a morph, or of some parts, and return it."""
    return _opened(assembly, CONTACTS, parts)


def _opened(assembly, what, parts):
    session = EditingSession(assembly.Document, [assembly, *model.parts(assembly)])
    return FindPanel.opened(session, assembly, what, parts)


class FindPanel(Panel):
    """A list of proposals; OK adds the checked ones to the document."""

    width = 540  # for the columns of the list

    def __init__(self, session, assembly, what, parts=None):
        super().__init__(session, "find", what.icon, what.title)
        self._assembly, self._what = assembly, what
        self._parts = parts
        self._found = []
        self._meshes = {}
        self._highlight = session.show(Highlight())
        self._faults = FaultBar(self.form, session, assembly)
        Folds({self.form.tolerances: "OpenTolerances"})
        self._prepare_widgets()
        session.ending.connect(self._freeze)
        self.search()

    def _freeze(self) -> None:
        if self.form is not None:
            find_table.freeze(self.form.table)

    # -- the search and its list

    def search(self, *_) -> None:
        """Search again with the tolerances of the panel."""
        self._faults.say("")
        try:
            with actions.followed(self._what.title):
                options = {**self._what.options(self.form), "parts": self._parts}
                self._found = self._what.find(api, self._assembly, options)
        except actions.FAULTS as error:
            self._found = []
            say_error(self.form.message, error)
        self._fill_kinds()
        find_table.fill(self.form.table, [self._what.row(one) for one in self._found])
        self._filter()

    def _fill_kinds(self) -> None:
        combo, kept = self.form.kind, self.form.kind.currentText()
        combo.blockSignals(True)
        combo.clear()
        combo.addItems(
            [translate("SheetMorph_panels", ANY), *sorted({one.kind for one in self._found})]
        )
        combo.setCurrentIndex(max(0, combo.findText(kept)))
        combo.blockSignals(False)

    def _filter(self, *_) -> None:
        """Hide the rows that the filters exclude; OK does not add them either."""
        kind, any_kind = self.form.kind.currentText(), self.form.kind.currentIndex() <= 0
        low, high = self.form.smallest.value(), self.form.largest.value()
        table = self.form.table
        for row in range(table.rowCount()):
            one = self._found[find_table.number_in(table, row)]
            size = self._what.size(one)
            is_shown = (
                (any_kind or kind == one.kind) and size >= low and (high <= 0.0 or size <= high)
            )
            table.setRowHidden(row, not is_shown)
        self._count()

    def _check_all(self) -> None:
        find_table.set_checks(self.form.table, True)
        self._count()

    def _check_none(self) -> None:
        find_table.set_checks(self.form.table, False)
        self._count()

    def _chosen(self) -> list:
        return [self._found[number] for number in find_table.checked(self.form.table)]

    def _count(self, *_) -> None:
        marked = sum(one.is_marked for one in self._found)
        text = translate("SheetMorph_panels", "{0} of {1} checked")
        if marked:
            text = translate("SheetMorph_panels", "{0} of {1} checked, {2} already in the document")
        texts = [text.format(len(self._chosen()), len(self._found), marked)]
        unsettled = sum(bool(self._what.doubt(one)) for one in self._found)
        if unsettled:
            text = translate("SheetMorph_panels", "{0} uncertain (?): point at a row to read why")
            texts.append(text.format(unsettled))
        if self._parts:
            texts.append(translate("SheetMorph_panels", "selected parts only"))
        self.form.count.setText("; ".join(texts))

    # -- the 3D view

    def _light(self, row: int, *_) -> None:
        """Colour the proposal under the mouse."""
        self._highlight.clear()
        if row < 0:
            return
        one = self._found[find_table.number_in(self.form.table, row)]
        for part, vertices, colour in self._what.places(one, colours):
            if part.Name not in self._meshes:
                self._meshes[part.Name] = seen.triangles(part)
            self._highlight.paint(part.ViewObject, self._meshes[part.Name], colour, vertices)

    def _look(self, row: int, *_) -> None:
        """Move the camera to a proposal."""
        one = self._found[find_table.number_in(self.form.table, row)]
        places = [(part, ids) for part, ids, _ in self._what.places(one, colours)]
        look_at(self.session.view, seen.positions(places))

    # -- the buttons of the task view

    def keep(self) -> bool:
        """Add all checked proposals in one undo step."""
        chosen = [one for one in self._chosen() if not one.is_marked]
        if not chosen:
            text = translate("SheetMorph_panels", "Nothing is checked. Check proposals, or cancel.")
            say(self.form.message, text, True)
            return False
        lines = self._what.lines(self._assembly, chosen, self.form)
        try:
            keeping.keep(self._what.title, *lines, document=self._assembly.Document)
        except actions.FAULTS as error:
            self._faults.say(error)
            return False
        return True

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        columns = [translate("SheetMorph_find", title) for title in self._what.columns]
        find_table.prepare(form.table, columns)
        self._what.prepare(form)
        connect(form.kind, "currentIndexChanged(int)", self._filter)
        connect(form.smallest, "valueChanged(double)", self._filter)
        connect(form.largest, "valueChanged(double)", self._filter)
        connect(form.search, "clicked()", self.search)
        connect(form.all, "clicked()", self._check_all)
        connect(form.none, "clicked()", self._check_none)
        connect(form.table, "cellEntered(int,int)", self._light)
        connect(form.table, "cellDoubleClicked(int,int)", self._look)
        connect(form.table, "itemChanged(QTableWidgetItem*)", self._count)
        self._leaving = _Leaving(self._light)
        form.table.viewport().installEventFilter(self._leaving)
        self.session.at_end(self._leaving.deleteLater)


class _Leaving(QtCore.QObject):
    """A filter that reports when the mouse leaves a widget."""

    def __init__(self, told):
        super().__init__()
        self._told = told

    def eventFilter(self, _watched, event) -> bool:
        """Report the event without consuming it."""
        if event.type() == QtCore.QEvent.Leave:
            self._told(-1)
        return False
