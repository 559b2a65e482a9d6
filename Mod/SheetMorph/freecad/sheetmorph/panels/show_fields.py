# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown while handles are moved, as the Move Handle panel lets the user choose it."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.panels.scale import gradient


class ShowFields:
    """Connects the widgets with a LiveUpdate ; choices are remembered."""

    def __init__(self, form, view_legend):
        """``view_legend``: the scene.legend.ViewLegend of the 3D view."""
        self._form, self._live, self._view_legend = form, None, view_legend
        self._boxes = {
            "ShowOriginal": form.original,
            "ShowFeatures": form.feature_motions,
            "ShowControlMeshes": form.control_meshes,
        }
        for entry, box in self._boxes.items():
            box.setChecked(preferences.get(entry))
            box.toggled.connect(lambda is_on, of=entry: self._toggle(of, is_on))
        form.colours.setCurrentIndex(preferences.get("ShowColours"))
        form.colours.currentIndexChanged.connect(self._colour)
        form.scale.setPixmap(gradient())
        self.tell()

    def connect(self, live) -> None:
        """Shows what is chosen in a LiveUpdate, also one that takes the place of another."""
        self._live = live
        for entry, box in self._boxes.items():
            if box.isChecked():
                self._use(entry, True)
        if self._form.colours.currentIndex():
            live.use_colours(self._form.colours.currentIndex())

    def tell(self) -> None:
        """Shows the legend of the last frame."""
        legend = self._live and self._live.legend
        self._form.scale.setVisible(legend is not None)
        self._form.scale_text.setVisible(legend is not None)
        if legend is not None:
            low, high = legend.span
            ends = f"{low:g} to {high:g}"
            self._form.scale_text.setText(f"{ends}; {self._live.worst}")
            self._view_legend.show_values(gradient(), f"{ends}\n{self._live.worst}")
        else:
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
