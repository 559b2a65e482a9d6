# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choice of axes in the Move Handle panel: those of the document, or the handle's own."""

from freecad.sheetmorph import preferences
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import connect
from freecad.sheetmorph.tools.local_axes import GLOBAL, local_axes


class AxesField:
    """The link from the list to a function `on_change()`; the preferences store the choice."""

    def __init__(self, form, on_change):
        self._combo, self._on_change = form.axes, on_change
        form.axes.setCurrentIndex(int(preferences.get("LocalAxes")))
        connect(form.axes, "currentIndexChanged(int)", self._choose)

    def of(self, handle):
        """Return the axes for a handle as columns (3, 3); expressions are about global ones."""
        is_driven = bool(handle.ExpressionEngine)
        self._combo.setEnabled(not is_driven)
        if self._combo.currentIndex() == 0 or is_driven or handle.Part is None:
            return GLOBAL
        rest = read_rest(handle.Part)
        return local_axes(rest.points, rest.triangles, model.vertices(handle))

    def _choose(self, index: int) -> None:
        preferences.put("LocalAxes", bool(index))
        self._on_change()
