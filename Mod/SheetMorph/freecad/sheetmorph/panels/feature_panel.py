# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a form feature: its rotation, motion, size and relations."""

from freecad.sheetmorph import actions, api, reporting
from freecad.sheetmorph.bridge import live_session, solving
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.editing.session import EditingSession
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.properties import number_of, vector_of
from freecad.sheetmorph.objects.region import AXIS, FORM_FEATURE, LINE, MOTIONS, PLANE
from freecad.sheetmorph.objects.region import PRESCRIBED, ROTATIONS
from freecad.sheetmorph.panels import keeping
from freecad.sheetmorph.panels.base import Panel, say, say_error
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.interaction.live_scene import LiveScene
from freecad.sheetmorph.qt import QtCore, QtWidgets, connect, translate
from freecad.sheetmorph.tools import words

RELATE = ("", "group", "coaxial", "keep_distance")
"""The API functions that relate form features, in the order of the combo box."""

PAUSE = 300
"""ms without a change until the view shows the choice."""

Change = tuple[str, tuple, dict]
"""An API call: function, arguments, keywords."""


def line_of(function: str, arguments: tuple, keywords: dict) -> str:
    """Return the macro line of an API call."""
    texts = {key: repr(value) for key, value in keywords.items()}
    return call(function, *[text_of(argument) for argument in arguments], **texts)


def text_of(argument) -> str:
    """Return a document object, a list of them, or a value as source text."""
    if isinstance(argument, list):
        return f"[{', '.join(text_of(entry) for entry in argument)}]"
    return name(argument) if hasattr(argument, "Name") else repr(argument)


def open_panel(feature):
    """Open the panel of a form feature, and return it."""
    assembly = model.assembly_of(feature)
    session = EditingSession(feature.Document, [assembly, *assembly.Group])
    return FeaturePanel.opened(session, feature)


class FeaturePanel(Panel):
    """The settings of a form feature; the view shows them at once, OK stores them."""

    def __init__(self, session, feature):
        super().__init__(session, "feature", "FeatureSettings", "Form Feature")
        self._feature = feature
        self._assembly = model.assembly_of(feature)
        self._shape = api.shape_of(feature)
        self._others = [
            other
            for other in model.regions(self._assembly)
            if other.Role == FORM_FEATURE and other != feature and other.Part is not None
        ]
        self._shown = None
        self._pause = QtCore.QTimer(self.form, singleShot=True, interval=PAUSE)
        connect(self._pause, "timeout()", lambda: session.when_free(self._show_changes))
        session.at_end(self._end_drawing)
        session.at_end(self._pause.stop)
        self._worker = FrameWorker(self._compute, self)
        session.at_end(self._worker.stop)
        self._prepare_widgets()
        self._show_values()
        self._refresh()
        self._watch()

    # -- the buttons of the task view

    def keep(self) -> bool:
        """Store the settings in one undo step; return False after reporting an error."""
        try:
            changes = self._changes()
            if changes:
                self._pause.stop()
                self._end_drawing()
                lines = [line_of(*change) for change in changes]
                keeping.keep("Form Feature", *lines, document=self._feature.Document)
        except actions.FAULTS as error:
            say_error(self.form.message, error)
            return False
        return True

    # -- the preview

    def _watch(self) -> None:
        form = self.form
        vectors = [f"{of}_{axis}" for of in ("rotation", "direction", "point") for axis in "xyz"]
        for name_of in ("angle", "feature_size", *vectors):
            connect(getattr(form, name_of), "valueChanged(double)", self._await)
        for box in (form.rotation, form.motion):
            connect(box, "currentIndexChanged(int)", self._await)
        connect(form.has_size, "toggled(bool)", self._await)

    def _await(self, *_) -> None:
        self._pause.start()

    def _show_changes(self) -> None:
        """Draw the result of OK, or show the error."""
        try:
            changes = [change for change in self._settings() if change is not None]
            self._end_drawing()
            if changes:
                self._try(changes)
            say(self.form.message, "")
        except actions.FAULTS as error:
            say_error(self.form.message, error)

    def _end_drawing(self) -> None:
        if self._shown is not None:
            self._shown.remove()
        self._shown = None

    def _try(self, changes: list[Change]) -> None:
        """Start to draw the changes; raise an error if they are invalid.

        The document stays as it is.
        """
        with transactions.trial(self._feature.Document, "Form Feature"):
            for function, arguments, keywords in changes:
                getattr(api, function)(*arguments, **keywords)
            morph = solving.read_morph(self._assembly)
        self._worker.ask((morph, solving.cache_of(self._assembly)))

    # -- called by the worker

    def _compute(self, question):
        """Return the solution and its frame, which OK reuses; runs in the worker thread."""
        morph, cache = question
        with reporting.told_to(self._goes_on):
            live = live_session.LiveSession(None, morph, cache)
            asked = live_session.Question(morph.pose, (), True)
            return live, live.answer(asked, self._goes_on)

    def _goes_on(self, _fraction: float, _task: str) -> bool:
        return self._worker.is_free

    def on_answer(self, answer) -> None:
        """Draw the result of OK."""
        live, frame = answer
        self._end_drawing()
        self._shown = LiveScene(self._assembly, live, None)
        self._shown.show(frame, None, None)
        say(self.form.message, "")

    def on_fault(self, text: str) -> None:
        """Show an error."""
        say(self.form.message, text, True)

    def on_progress(self, _task: str) -> None:
        """Ignore the progress."""

    def _changes(self) -> list[Change]:
        """Return the API calls for all changes."""
        made = [*self._settings(), self._relation()]
        return [change for change in made if change is not None]

    def _settings(self) -> list[Change | None]:
        """Return the changes of the form feature; a relation would be a new object."""
        return [self._rotation(), self._motion(), self._size()]

    def _rotation(self) -> Change | None:
        feature, chosen = self._feature, ROTATIONS[self.form.rotation.currentIndex()]
        axis, degrees = self._vector("rotation"), self.form.angle.value()
        if chosen != PRESCRIBED:
            is_same, wanted = chosen == feature.Rotation, chosen
        else:
            before = (
                feature.Rotation,
                vector_of(feature, "RotationAxis"),
                number_of(feature, "RotationAngle"),
            )
            is_same, wanted = before == (chosen, axis, degrees), (axis, degrees)
        return None if is_same else ("set_rotation", (feature, wanted), {})

    def _motion(self) -> Change | None:
        feature, chosen = self._feature, MOTIONS[self.form.motion.currentIndex()]
        given = {}
        if chosen in (PLANE, LINE, AXIS) and self._vector("direction") != self._given[0]:
            given["direction"] = self._vector("direction")
        if chosen == AXIS and self._vector("point") != self._given[1]:
            given["point"] = self._vector("point")
        if chosen == feature.Motion and not given:
            return None
        return "set_feature_motion", (feature, chosen), given

    def _size(self) -> Change | None:
        if self._shape is None:
            return None
        size = self.form.feature_size.value() if self.form.has_size.isChecked() else 0.0
        is_same = size == number_of(self._feature, "Size")
        return None if is_same else ("set_size", (self._feature, size or None), {})

    def _relation(self) -> Change | None:
        function, chosen = RELATE[self.form.relation.currentIndex()], self._ticked()
        if not function:
            return None
        if not chosen:
            raise ValueError(
                translate(
                    "SheetMorph_panels",
                    "Tick the related form features, or choose “No new relation”.",
                )
            )
        members = [self._feature, *chosen]
        if function == "group":
            return function, (self._assembly, members), {}
        if len(chosen) > 1:
            raise ValueError(
                translate("SheetMorph_panels", "A pair has two form features: tick one other.")
            )
        return function, (self._assembly, *members), {}

    # -- the widgets

    def _prepare_widgets(self) -> None:
        form = self.form
        text = translate("SheetMorph_panels", "<b>{0}</b> on {1}")
        form.part.setText(text.format(self._feature.Label, self._feature.Part.Label))
        form.feature_size.setMinimum(0.0)
        form.angle.measure("deg")
        for other in self._others:
            item = QtWidgets.QListWidgetItem(f"{other.Label} on {other.Part.Label}", form.others)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Unchecked)
        form.relation.setEnabled(bool(self._others))
        for box in (form.rotation, form.motion, form.relation):
            connect(box, "currentIndexChanged(int)", self._refresh)
        connect(form.has_size, "toggled(bool)", self._refresh)
        related = model.relations(self._assembly, self._feature)
        text = ", ".join(f"{relation.Label} ({relation.Type})" for relation in related)
        title = translate("SheetMorph_panels", "Relations: {0}")
        say(form.related, title.format(text) if text else "")
        say(form.message, "")

    def _show_values(self) -> None:
        form, feature, shape = self.form, self._feature, self._shape
        form.rotation.setCurrentIndex(ROTATIONS.index(feature.Rotation))
        form.motion.setCurrentIndex(MOTIONS.index(feature.Motion))
        self._show("rotation", vector_of(feature, "RotationAxis"))
        self._show("direction", vector_of(feature, "MotionDirection"))
        self._show("point", vector_of(feature, "MotionPoint"))
        self._given = self._vector("direction"), self._vector("point")
        form.angle.setValue(number_of(feature, "RotationAngle"))
        form.has_size.setEnabled(shape is not None)
        form.has_size.setChecked(shape is not None and number_of(feature, "Size") > 0.0)
        if shape is None:
            text = translate(
                "SheetMorph_panels", "Not a hole, slot or cylinder: it has no size to set."
            )
            form.size_text.setText(text)
            return
        form.feature_size.setValue(number_of(feature, "Size") or shape.size)
        size = words.length(shape.size, 6)
        form.size_text.setText(f"{shape.kind.capitalize()}, {shape.measure} {size}.")

    def _refresh(self, *_) -> None:
        """Show the fields that apply now."""
        form = self.form
        motion = MOTIONS[form.motion.currentIndex()]
        is_turned = ROTATIONS[form.rotation.currentIndex()] == PRESCRIBED
        self._show_row(("rotation_axis_label", "rotation_x", "rotation_y", "rotation_z"), is_turned)
        self._show_row(("angle_label", "angle"), is_turned)
        has_direction = motion in (PLANE, LINE, AXIS)
        rows = ("direction_label", "direction_x", "direction_y", "direction_z")
        self._show_row(rows, has_direction)
        form.direction_label.setText({PLANE: "Normal", AXIS: "Axis"}.get(motion, "Direction"))
        self._show_row(("point_label", "point_x", "point_y", "point_z"), motion == AXIS)
        form.feature_size.setEnabled(form.has_size.isChecked())
        form.others.setVisible(form.relation.currentIndex() > 0)
        say(form.message, "")

    def _show_row(self, widgets, is_shown: bool) -> None:
        for widget in widgets:
            getattr(self.form, widget).setVisible(is_shown)

    def _show(self, prefix: str, vector) -> None:
        for axis, value in zip("xyz", vector):
            getattr(self.form, f"{prefix}_{axis}").setValue(value)

    def _vector(self, prefix: str) -> tuple[float, float, float]:
        return tuple(getattr(self.form, f"{prefix}_{axis}").value() for axis in "xyz")

    def _ticked(self) -> list:
        """Return the other form features that are checked."""
        states = [self.form.others.item(row).checkState() for row in range(len(self._others))]
        return [o for o, state in zip(self._others, states) if state == QtCore.Qt.Checked]
