# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distance between two points that the user clicks on the deformed parts."""

from freecad.sheetmorph.interaction.near_mouse import NearMouse
from freecad.sheetmorph.scene.distance_mark import DistanceMark
from freecad.sheetmorph.scene.viewport import Listener, Viewport
from freecad.sheetmorph.tools import places


class Measuring(Listener):
    """The two points, which move with the material and follow every frame, until `remove`.

    A third click starts again. `on_change()` is called when the distance or the mode changes.
    """

    def __init__(self, view, words, on_change):
        """Measure in a view; `words(distance)` returns the text at the line."""
        self._view, self._words, self._on_change = view, words, on_change
        self._viewport = self._mark = self._live = None
        self._near, self._clicks = NearMouse(self._pick), []
        self._places = []
        self.distance = None

    def connect(self, live) -> None:
        """Follow the frames of a LiveUpdate."""
        self._live = live
        if not all(place.is_on(live.at_rest()) for place in self._places):
            self._places = []
        live.drawn.connect(self._follow)
        self._follow()

    @property
    def is_on(self) -> bool:
        """Whether clicks pick points."""
        return self._viewport is not None

    @property
    def is_begun(self) -> bool:
        """Whether one point is picked."""
        return len(self._places) == 1

    def use(self, is_on: bool) -> None:
        """Start to pick points, or remove those that are picked."""
        if is_on == self.is_on:
            return
        if is_on:
            self._viewport, self._mark = Viewport(self._view, self), DistanceMark(self._view)
        else:
            self._clear()
        self._on_change()

    def remove(self) -> None:
        """Remove the mark and release the mouse; the view may be closed already."""
        if self.is_on:
            self._clear()
        self._near.remove()
        self._live = self._on_change = None

    def on_click(self, pointer) -> None:
        """Pick the vertex or mid-point near the mouse, else the point of the surface under it."""
        if self._live is not None:
            self._clicks.append((self._viewport.camera(), pointer.place))
            self._near.look_at(self._live.displayed())

    def _pick(self) -> None:
        """Take the places of the clicks, as soon as the search is ready."""
        clicks, self._clicks = self._clicks, []
        for click in clicks:
            place = self._near.at(*click)
            if place is not None:
                self._places = [*self._places, place] if self.is_begun else [place]
        self._near.forget()
        self._follow()

    def on_escape(self) -> None:
        """End the measurement."""
        self.use(False)

    def on_enter(self) -> bool:
        """Leave the key to the panel."""
        return False

    def _follow(self) -> None:
        """Show the points where the displayed shape has them."""
        if not self.is_on or self._live is None:
            return
        shown = self._live.displayed()
        ends = [place.at(shown[place.part][0]) for place in self._places]
        self.distance = None
        if len(ends) == 2:
            self.distance = places.distance(self._places, self._live.at_rest(), shown)
        self._mark.show(ends, "" if self.distance is None else self._words(self.distance))
        self._on_change()

    def _clear(self) -> None:
        self._viewport.remove()
        self._mark.remove()
        self._viewport = self._mark = self.distance = None
        self._places, self._clicks = [], []
