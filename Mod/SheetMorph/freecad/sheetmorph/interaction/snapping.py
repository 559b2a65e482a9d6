# SPDX-License-Identifier: LGPL-2.1-or-later
"""Snapping of a drag: to steps of length and angle, and to points of the displayed parts."""

import numpy as np

from freecad.sheetmorph.interaction.near_mouse import NearMouse
from freecad.sheetmorph.qt import translate
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.drag_watch import DragWatch
from freecad.sheetmorph.scene.place_marks import PlaceMarks
from freecad.sheetmorph.scene.viewport import camera_of
from freecad.sheetmorph.tools import places, snapping

MARK = "SheetMorphSnapMark"


class Snapping:
    """What a drag snaps to, until `remove`.

    Ctrl reverses the choice of steps, and Shift that of points, as long as the user holds them.
    """

    def __init__(self, view, on_steps, again):
        """Snap in a view; `on_steps(steps or None)` sets the steps of the arrows.

        `again()` repeats the last shift, as soon as there is more to snap to.
        """
        self._view, self._on_steps = view, on_steps
        self._watch = DragWatch(view, self._moved)
        self._near, self._mark = NearMouse(again), None
        self._pointer = self._from = self._axes = self._meshes = None
        self.steps = (1.0, 5.0)
        self.uses_steps = self.uses_points = False
        self.has_point = False  # whether the last shift went to a point of a part

    def remove(self) -> None:
        """Remove the mark and release the mouse."""
        self.end()
        self._near.remove()

    def begin(self, reference, axes, meshes) -> None:
        """Begin a drag of a point (3,) mm along the columns of `axes` (3, 3).

        `meshes()` returns the displayed meshes by part.
        """
        self._from, self._axes = np.asarray(reference, float), axes
        self._meshes = meshes()
        if self.uses_points:
            self._near.look_at(self._meshes)
        self._watch.start()
        self._mark = PlaceMarks(self._view, MARK, colours.SNAP, 10.0)

    def end(self) -> None:
        """End the drag."""
        self._watch.stop()
        self._pointer = self._from = self._meshes = None
        self.has_point = False
        self._near.forget()
        if self._mark is not None:
            self._mark.remove()
            self._mark = None
        self._on_steps(self.steps if self.uses_steps else None)

    def along_arrows(self, shift) -> np.ndarray:
        """Return a shift (3,) mm by arrows, as far along them as the point that it snaps to."""
        shift = np.asarray(shift, float)
        target = self._target() if shift.any() else None
        return shift if target is None else snapping.along_drag(shift, target, self._axes)

    def in_view(self, shift) -> np.ndarray:
        """Return a free shift (3,) mm: to a point of a part, else in steps."""
        target = self._target()
        if target is not None:
            return target
        return snapping.stepped(shift, self.steps[0], self._axes) if self._is_stepping else shift

    @property
    def _is_stepping(self) -> bool:
        is_held = self._pointer is not None and self._pointer.control
        return self.uses_steps != is_held

    def _target(self):
        """Return the shift (3,) to the point under the mouse, marked; None without one."""
        place = None
        if self._pointer is not None and self.uses_points != self._pointer.shift:
            place = self._near.at(camera_of(self._view), self._pointer.place)
        self.has_point = place is not None and place.kind != places.SURFACE
        if not self.has_point:
            self._mark.show([])
            return None
        point = self._near.position(place)
        self._mark.show([(point, "  " + translate("SheetMorph_panels", place.kind))])
        return point - self._from

    def _moved(self, pointer) -> None:
        """Note the mouse and its keys, before the arrows follow it."""
        before, self._pointer = self._is_stepping, pointer
        if pointer.shift != self.uses_points and not self._near.is_looking:
            self._near.look_at(self._meshes)
        if before != self._is_stepping:
            self._on_steps(self.steps if self._is_stepping else None)
