# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that prepares a mesh: its faults, the repairs and their preview."""

import html

import FreeCADGui as Gui

from freecad.sheetmorph import actions, api, reporting
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.bridge import seen, units
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import differences
from freecad.sheetmorph.panels.base import Panel, say, say_error
from freecad.sheetmorph.qt import connect, translate
from freecad.sheetmorph.scene.highlight import PartLight
from freecad.sheetmorph.scene.looking import look_at
from freecad.sheetmorph.scene.mesh_preview import MeshPreview
from freecad.sheetmorph.tools import cures, words


def open_panel(part):
    """Open the panel for a part, and return it."""
    with actions.waiting():
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(part)
        return PreparePanel.opened(EditingSession(part.Document, [part]), part)


def offer(parts: list) -> None:
    """Open the panel for the first of some new parts that needs a repair.

    Nothing changes until the user presses OK.
    """
    if Gui.Control.activeDialog():
        return
    try:
        with actions.followed(translate("SheetMorph_prepare", "Prepare Mesh")):
            looked = reporting.one_by_one(parts, "looking at the meshes")
            needy = next((p for p in looked if cures.is_needed(api.diagnose_original(p))), None)
    except actions.Cancelled:
        return
    if needy is not None:
        open_panel(needy)


class PreparePanel(Panel):
    """The panel for one part; OK is one undo step."""

    width = 420

    def __init__(self, session, part):
        super().__init__(session, "prepare", "PrepareMesh", "Prepare Mesh")
        self._part = part
        self._preview = None
        session.at_end(self._end_preview)
        self._found = api.diagnose_original(part)
        self._light = session.show(PartLight())
        self._show_part()
        self._prepare_widgets()
        self._offer()

    def keep(self) -> bool:
        """Repair the part."""
        if self._has_fault():
            return False
        lines = self._lines()
        if not lines:
            text = translate("SheetMorph_panels", "Nothing is chosen. Choose a repair, or cancel.")
            say(self.form.message, text, True)
            return False
        self._end_preview()
        try:
            actions.run("Prepare Mesh", *lines, document=self._part.Document)
        except actions.FAULTS as error:
            say_error(self.form.message, error)
            return False
        if not self._wish().is_split:  # splitting removes the part
            differences.tell(self._part.Document, api.preparation_of(self._part))
        return True

    def _show_part(self) -> None:
        """Tint the part and move the camera to it, if the morph has several."""
        part = self._part
        if len(model.parts(model.assembly_of(part))) > 1:
            triangles = seen.triangles(part)
            self._light.show(part.Name, part.ViewObject, triangles)
            look_at(self.session.view, seen.corners(part))

    # -- the diagnosis

    def _offer(self) -> None:
        """Check the repairs that the diagnosis offers."""
        form, wish = self.form, cures.offered(self._found)
        form.unit.setCurrentText(cures.unit_of(self._found))
        form.scale.setChecked(wish.scale != 1.0)
        form.weld.setChecked(wish.weld is not None)
        form.remesh.setChecked(wish.edge is not None)
        form.thin.setChecked(self._part.Thin != "no" or wish.is_thin)
        form.split.setVisible(wish.is_split)
        form.split.setEnabled(not self._is_marked())
        form.split.setChecked(wish.is_split and form.split.isEnabled())
        text = translate("SheetMorph_panels", "Split into its {} pieces")
        form.split.setText(text.format(cures.pieces(self._found)))
        self._tell()

    def _is_marked(self) -> bool:
        """Return whether the part has a region or a contact."""
        owner = model.assembly_of(self._part)
        return bool(model.regions(owner, self._part) or model.contacts(owner, self._part))

    def _tell(self, *_) -> None:
        """Show the diagnosis, and propose lengths in the chosen unit."""
        form, found, scale = self.form, self._found, self._wish().scale
        if scale != 1.0:
            with actions.waiting():
                found = cures.with_unit_of(api.diagnose_original(self._part, scale), found)
        name_of_part = html.escape(self._part.Label)
        form.findings.setText(f"<b>{name_of_part}</b><br>{cures.as_text(found)}")
        form.tolerance.setText(words.exact_length(cures.tolerance_of(found)))
        suggested = (found["suggested_edge"] or 1.0) / found["unit"]["scale"]
        form.edge.setValue(suggested)
        self._refresh()

    # -- the chosen repairs

    def _wish(self) -> cures.Wish:
        form = self.form
        return cures.Wish(
            units.number_in(form.tolerance.text(), "mm") if form.weld.isChecked() else None,
            form.edge.value() if form.remesh.isChecked() else None,
            ("polygon", "circle")[form.rims.currentIndex()],
            form.unit.currentData() if form.scale.isChecked() else 1.0,
            form.thin.isChecked(),
            form.split.isChecked(),
        )

    def _has_fault(self) -> bool:
        """Return whether the tolerance is invalid, after reporting it."""
        form = self.form
        given = units.number_in(form.tolerance.text(), "mm")
        text = translate(
            "SheetMorph_panels", "Enter a distance for merging vertices, such as 0.01 mm."
        )
        is_wrong = form.weld.isChecked() and (given is None or given < 0.0)
        say(form.message, text if is_wrong else "", is_wrong)
        return is_wrong

    def _lines(self) -> list[str]:
        """Return the API calls for the chosen repairs."""
        wish, part = self._wish(), name(self._part)
        lines = []
        if wish.changes_mesh():
            arguments = {key: repr(value) for key, value in wish.arguments().items()}
            lines.append(call("prepare", part, **arguments))
        if wish.is_thin != (self._part.Thin != "no"):
            lines.append(call("set_thin", part, repr("auto" if wish.is_thin else False)))
        if wish.is_split:
            lines.append(call("split_part", part))
        return lines

    # -- the preview

    def _show_preview(self) -> None:
        """Compute the new mesh and draw it in place of the part."""
        self._end_preview()
        if self._has_fault():
            return
        wish = self._wish()
        if not wish.changes_mesh():
            say(self.form.message, translate("SheetMorph_panels", "Choose a repair first."), True)
            return
        try:
            with actions.followed(translate("SheetMorph_prepare", "Preview")):
                made = api.preparation(self._part, **wish.arguments())
                places = api.places_of(self._part, made)
        except actions.FAULTS as error:
            self._tell_fault(error)
            return
        if self.session.is_over:  # the session may have ended during the computation
            return
        self._light.show()
        view = self.session.view
        self._preview = MeshPreview(view, self._part.ViewObject, places, made.triangles)
        say(self.form.message, cures.summary(made))
        if wish.scale != 1.0:
            Gui.SendMsgToActiveView("ViewFit")

    def _tell_fault(self, error) -> None:
        if not self.session.is_over:
            say_error(self.form.message, error)

    def _end_preview(self, *_) -> None:
        if self._preview is not None:
            self._preview.remove()
        self._preview = None

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        say(form.message, "")
        for unit, scale in cures.units().items():
            form.unit.addItem(unit, scale)
        connect(form.scale, "clicked()", self._tell)
        connect(form.unit, "activated(int)", self._tell)
        for box in (form.weld, form.remesh):
            connect(box, "toggled(bool)", self._refresh)
        connect(form.tolerance, "textEdited(QString)", self._refresh)
        connect(form.preview, "clicked()", self._show_preview)

    def _refresh(self, *_) -> None:
        """Disable the fields without effect, and remove an outdated preview."""
        form = self.form
        form.tolerance.setEnabled(form.weld.isChecked())
        form.unit.setEnabled(form.scale.isChecked())
        for widget in (form.edge, form.rims):
            widget.setEnabled(form.remesh.isChecked())
        say(form.message, "")
        self._end_preview()
