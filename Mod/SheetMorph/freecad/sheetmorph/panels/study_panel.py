# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a study: its parameters and the table of results."""

import FreeCADGui as Gui

from freecad.sheetmorph import actions, api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.api import studies
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects.study import kept_parameters, kept_results
from freecad.sheetmorph.panels import study_table
from freecad.sheetmorph.panels.base import Panel, say, say_error
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate
from freecad.sheetmorph.tools.studies import ANGLE, LENGTH, METHODS, unused

HEIGHTS = {"parameters": 88, "results": 220}  # px: least height of the tables
LOOK = 200  # ms between two checks of the process
AROUND = {LENGTH: 10.0, ANGLE: 10.0}  # range of a new parameter around a length or an angle
SHARE = 0.2  # range around any other number, as a share of it


def open_panel(assembly, study=None):
    """Open the panel of a study, or of a new one for None, and return it."""
    session = EditingSession(assembly.Document, [assembly], goes_with_undo=True)
    return StudyPanel.opened(session, assembly, study)


class StudyPanel(Panel):
    """The panel of a study; OK and Run store the settings.

    Results and an applied variant are separate undo steps. During a run the document must not
    change: an undo, a deletion or the end of the panel stops the processes.
    """

    width = 480  # for tables

    def __init__(self, session, assembly, study):
        super().__init__(session, "study", "Study", "Study")
        self._assembly, self._document = assembly, assembly.Document
        self._name = study.Name if study is not None else ""
        self._variables = []
        self._chosen = []  # a variable for each row of the parameters
        self._running = None
        self._run = None
        self._look = QtCore.QTimer(self.form, interval=LOOK)
        connect(self._look, "timeout()", self._watch)
        session.ending.connect(self._look.stop)
        session.at_end(self._end_run)
        session.changed.connect(self._follow)
        self._prepare_widgets()
        self._fill()

    def keep(self) -> bool:
        """Store new settings in one undo step; return False during a run."""
        if self._run is not None:
            say(
                self.form.message,
                translate(
                    "SheetMorph_panels", "Variants are still being computed. Wait, or stop them."
                ),
            )
            return False
        return self._kept()

    @property
    def _study(self):
        """The study, None before it is first stored."""
        return self._document.getObject(self._name) if self._name else None

    # -- changes by the user

    def _kept(self) -> bool:
        """Store the settings in the document; return False after reporting an error."""
        try:
            settings = self._settings()
            studies.check(self._assembly, settings)
            if self._study is None or self._differs(settings):
                self._put(settings)
        except actions.FAULTS as error:
            say_error(self.form.message, error)
            return False
        say(self.form.message, "")
        return True

    def _put(self, settings: dict) -> None:
        texts = {key: repr(value) for key, value in settings.items() if key != "parameters"}
        entries = [
            f"({told!r}, {name(owner)}, {number!r}, {low!r}, {high!r})"
            for told, owner, number, low, high in settings["parameters"]
        ]
        texts["parameters"] = f"[{', '.join(entries)}]"
        is_new = self._study is None
        before = {study.Name for study in studies.model.studies(self._assembly)}
        owner = self._assembly if is_new else self._study
        line = call("add_study" if is_new else "set_study", name(owner), **texts)
        actions.run("Study", line, document=self._document)
        now = {study.Name for study in studies.model.studies(self._assembly)}
        self._name = next(iter(now - before), self._name)

    def _settings(self) -> dict:
        """Return the settings for `set_study`.

        Raises ValueError if one is invalid.
        """
        form = self.form
        rows = study_table.parameters_in(form.parameters, self._chosen)
        return {
            "parameters": [(told, one.owner, one.number, a, b) for told, one, a, b in rows],
            "sampling": METHODS[form.sampling.currentIndex()],
            "count": form.count.value(),
            "seed": form.seed.value(),
            "criteria": form.criteria.text().strip(),
            "folder": form.folder.text().strip(),
        }

    def _differs(self, settings: dict) -> bool:
        study = self._study
        kept = [(p.name, p.owner, p.number, p.low, p.high) for p in kept_parameters(study)]
        told = [(n, owner.Name, number, a, b) for n, owner, number, a, b in settings["parameters"]]
        others = studies.SETTINGS.items()
        return kept != told or any(getattr(study, at) != settings[key] for key, at in others)

    def _add(self, *_) -> None:
        """Add a parameter with a range around its present value."""
        if not self._variables:
            return
        variable = self._variables[self.form.variable.currentIndex()]
        try:
            value = studies.value_of(variable)
            rows = study_table.parameters_in(self.form.parameters, self._chosen)
        except actions.FAULTS as error:
            say_error(self.form.message, error)
            return
        around = AROUND.get(variable.unit, 0.0)
        if variable.number == "Size" or not around:
            around = SHARE * abs(value) or 1.0
        told = unused(variable.label, [row[0] for row in rows])
        self._show_parameters([*rows, (told, variable, value - around, value + around)])

    def _remove(self, *_) -> None:
        chosen = {index.row() for index in self.form.parameters.selectedIndexes()}
        self._chosen = [one for row, one in enumerate(self._chosen) if row not in chosen]
        for row in sorted(chosen, reverse=True):
            self.form.parameters.removeRow(row)

    def _choose_folder(self, *_) -> None:
        window, text = Gui.getMainWindow(), translate(
            "SheetMorph_panels", "Folder for the Variants"
        )
        folder = QtWidgets.QFileDialog.getExistingDirectory(window, text)
        if folder:
            self.form.folder.setText(folder)

    # -- the run

    def _start(self, *_) -> None:
        """Store the settings, and compute the variants in separate processes."""
        if self._run is not None or not self._kept():
            return
        running = studies.begun(self._study)
        try:
            with actions.waiting():
                self._run = running.__enter__()
        except actions.FAULTS as error:
            say_error(self.form.message, error)
            return
        self._running = running
        self._look.start()
        self._show_running()

    def _stop(self, *_) -> None:
        """Stop the run; the finished variants become the table."""
        if self._run is not None:
            self._run.cancel()
            self.form.stop.setEnabled(False)

    def _watch(self) -> None:
        """Show the progress, and take the results at the end."""
        if self._run is None or self.session.is_ending or self.session.is_busy():
            return
        study = self._study
        if study is None:
            return  # the study was deleted, and the panel will follow
        self.form.progress.setMaximum(max(1, study.Count))
        self.form.progress.setValue(min(self._run.done, study.Count))
        if self._run.is_over:
            self._take_results()

    def _take_results(self) -> None:
        """Store the results in one undo step, with a macro line."""
        study = self._study
        try:
            with transactions.step(self._document, "Study Results"):
                studies.keep_results(study, self._run)
            actions.note(call("run_study", name(study)))
        except actions.FAULTS as error:
            say_error(self.form.message, error)
        self._end_run()
        self._show_running()
        self._show_results()
        self._bring_results()

    def _bring_results(self) -> None:
        """Scroll the panel to the table."""
        for area in Gui.getMainWindow().findChildren(QtWidgets.QScrollArea):
            if area.isAncestorOf(self.form):
                area.ensureWidgetVisible(self.form.results)

    def _end_run(self) -> None:
        """End the processes and remove temporary files."""
        self._look.stop()
        running, self._running, self._run = self._running, None, None
        if running is not None:
            running.__exit__(None, None, None)

    def _apply(self, row: int, *_) -> None:
        """Apply the numbers of a double-clicked variant in one undo step."""
        if self._run is not None or self._study is None:
            return
        run = study_table.run_in(self.form.results, row)
        line = call("apply_variant", name(self._study), repr(run))
        actions.attempt("Apply Variant", line, document=self._document)

    # -- the display

    def _follow(self) -> None:
        """Stop the run after an undo, a redo or a deletion, which make it outdated."""
        if self._run is not None:
            self._end_run()
            say(
                self.form.message,
                translate("SheetMorph_panels", "Stopped: the document has changed."),
            )
        if self._name and self._study is None:
            self.session.end()
            return
        self._fill()

    def _fill(self) -> None:
        """Show the study of the document."""
        form, study = self.form, self._study
        self._variables = api.variables(self._assembly)
        form.variable.clear()
        form.variable.addItems([one.label for one in self._variables])
        if study is not None:
            form.sampling.setCurrentIndex(METHODS.index(study.Sampling))
            form.count.setValue(study.Count)
            form.seed.setValue(study.Seed)
            form.criteria.setText(study.Criteria)
            form.folder.setText(study.Folder)
            known = {(one.owner.Name, one.number): one for one in self._variables}
            kept = [(p, known.get((p.owner, p.number))) for p in kept_parameters(study)]
            self._show_parameters([(p.name, one, p.low, p.high) for p, one in kept if one])
        elif not self._chosen and self._variables:
            self._show_parameters([])
        self._show_running()
        self._show_results()

    def _show_parameters(self, rows) -> None:
        self._chosen = [variable for _, variable, _, _ in rows]
        study_table.fill_parameters(self.form.parameters, rows)

    def _show_running(self) -> None:
        """Enable the buttons that apply now."""
        is_running = self._run is not None
        form = self.form
        for widget in (form.variable, form.add, form.remove, form.variants_box, form.run):
            widget.setEnabled(not is_running)
        study_table.lock(form.parameters, is_running)
        form.stop.setEnabled(is_running)
        form.progress.setVisible(is_running)

    def _show_results(self) -> None:
        results = {} if self._study is None else kept_results(self._study)
        study_table.fill_results(self.form.results, results)
        text = translate("SheetMorph_panels", "No variants yet.")
        if results:
            hint = translate("SheetMorph_panels", "{0}. Double-click a row to apply the variant.")
            text = hint.format(study_table.counted(results))
        say(self.form.counts, text)

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        heads = [translate("SheetMorph_panels", head) for head in study_table.HEADS]
        study_table.prepare(form.parameters, heads, study_table.WHAT)
        for table, height in HEIGHTS.items():
            reserve(getattr(form, table), height)
        connect(form.add, "clicked()", self._add)
        connect(form.remove, "clicked()", self._remove)
        connect(form.browse, "clicked()", self._choose_folder)
        connect(form.run, "clicked()", self._start)
        connect(form.stop, "clicked()", self._stop)
        connect(form.results, "cellDoubleClicked(int,int)", self._apply)
        say(form.message, "")


def reserve(widget, height: int) -> None:
    """Reserve a height (px) for a widget, whose own minimum a style sheet may override."""
    column, row = widget.parentWidget().layout(), QtWidgets.QHBoxLayout()
    place = column.indexOf(widget)
    row.addStrut(height)
    row.addWidget(widget)
    column.insertLayout(place, row)
