# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display options in the Move Handle panel."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.panels.base import legend
from freecad.sheetmorph.panels.histogram import histogram_picture
from freecad.sheetmorph.panels.measure_fields import MeasureFields
from freecad.sheetmorph.panels.scale import gradient
from freecad.sheetmorph.panels.section import open_section_planes
from freecad.sheetmorph.panels.share_fields import ShareFields
from freecad.sheetmorph.qt import connect, translate
from freecad.sheetmorph.scene.legend import ViewLegend
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP


ELEMENTS = (
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: aspect"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: warpage"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: skew"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: taper"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: Jacobian"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: smallest angle"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: largest angle"),
    QT_TRANSLATE_NOOP("SheetMorph_panels", "Elements: shortest edge"),
)
"""The measures in the order of element_quality.MEASURES."""
FIRST_OF_ELEMENTS = 5  # in the list of colours


def beyond(histogram) -> str:
    """Return the number of elements beyond the limit as text, empty without a limit."""
    if histogram is None or histogram.limit is None:
        return ""
    text = translate("SheetMorph_panels", "; {0} of {1} elements beyond the limit of {2:g}")
    return text.format(histogram.failing, histogram.count, histogram.limit)


class ShowFields:
    """The link from the widgets to a LiveUpdate; the preferences store the choices."""

    def __init__(self, form, session, has_elements: bool = False):
        """Connect the widgets for the 3D view of an EditingSession.

        `has_elements` means that a part belongs to a deck, so that its elements can be measured.
        """
        self._form, self._live = form, None
        self._view_legend = session.show(ViewLegend(session.view))
        self._view_legend.show_roles(legend(""))
        self._boxes = {
            "ShowOriginal": form.original,
            "ShowFeatures": form.feature_motions,
            "ShowControlMeshes": form.control_meshes,
        }
        for entry, box in self._boxes.items():
            box.setChecked(preferences.get(entry))
            connect(box, "toggled(bool)", lambda is_on, of=entry: self._toggle(of, is_on))
        if has_elements:
            form.colours.addItems([translate("SheetMorph_panels", title) for title in ELEMENTS])
        form.colours.setCurrentIndex(preferences.get("ShowColours"))
        if form.colours.currentIndex() < 0:  # the stored choice applies to decks only
            form.colours.setCurrentIndex(0)
        connect(form.colours, "currentIndexChanged(int)", self._colour)
        self._share, self._measure = ShareFields(form), MeasureFields(form, session.view)
        session.show(self._measure)
        connect(form.section, "clicked()", open_section_planes)
        form.scale.setPixmap(gradient())
        form.scale_text.setFixedHeight(2 * form.fontMetrics().lineSpacing())
        self.tell()

    def connect(self, live) -> None:
        """Apply the choices to a new LiveUpdate."""
        self._live = live
        self._share.connect(live)
        self._measure.connect(live)
        for entry, box in self._boxes.items():
            if box.isChecked():
                self._use(entry, True)
        if self._form.colours.currentIndex():
            live.use_colours(self._form.colours.currentIndex())

    def leave_share(self) -> bool:
        """Show the full motion; return whether only a share of it was shown."""
        return self._share.leave()

    def tell(self) -> None:
        """Show the legend of the last frame."""
        values = self._live and self._live.legend
        chosen = self._form.colours.currentIndex()
        # The choice decides, not the frame: nothing may move while frames arrive.
        self._form.scale.setVisible(chosen > 0)
        self._form.scale_text.setVisible(chosen > 0)
        self._form.histogram.setVisible(chosen >= FIRST_OF_ELEMENTS)
        histogram = values and values.histogram
        if values is not None:
            low, high = values.span
            ends = f"{low:g}–{high:g} {self._live.unit}".strip()
            self._form.scale_text.setText(f"{ends}; {self._live.worst}{beyond(histogram)}")
            bars = None if histogram is None else histogram_picture(histogram)
            self._view_legend.show_values(gradient(), f"{ends}\n{self._live.worst}", bars)
            if bars is not None:
                self._form.histogram.setPixmap(bars)
        else:
            self._form.scale_text.setText("")
            self._view_legend.show_values()

    def _toggle(self, entry: str, is_on: bool) -> None:
        preferences.put(entry, is_on)
        if self._live is not None:
            self._use(entry, is_on)

    def _use(self, entry: str, is_on: bool) -> None:
        scene = self._live.scene
        use = {"ShowOriginal": scene.use_original, "ShowFeatures": scene.use_marks}
        use.get(entry, scene.use_wires)(is_on)
        self._live.refresh()

    def _colour(self, kind: int) -> None:
        preferences.put("ShowColours", kind)
        if self._live is not None:
            self._live.use_colours(kind)
        self.tell()
