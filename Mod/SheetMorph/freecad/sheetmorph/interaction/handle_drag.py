# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view while handles move: arrows, points, snapping, Escape."""

from freecad.sheetmorph.bridge.units import number_in
from freecad.sheetmorph.scene.cursor_value import CursorValue
from freecad.sheetmorph.scene.dragger import Dragger
from freecad.sheetmorph.scene.point_drag import EscapeWatch, PointDrag
from freecad.sheetmorph.tools.motion import Pull


class HandleDrag:
    """The conversion of drags into motions, until `remove`.

    It sets and observes `moving`, a motion.Moving. `owner` has settle(), called when the mouse is
    released, and grab(ray), which chooses the vertex under the mouse and returns its position or
    None.
    """

    def __init__(self, view, moving, owner):
        self._view, self._moving, self._owner = view, moving, owner
        self._points = PointDrag(view, self)
        self._escape = EscapeWatch(self.on_escape)
        self._value = CursorValue(view)
        self._pull = None
        self._arrows = None
        self._steps = None
        self._start = None
        self._has_arrow = False  # the mouse moves the arrows, which then follow nothing else
        self.moves_pivot = False
        moving.observe(self._follow)

    def remove(self) -> None:
        """Remove everything from the view."""
        self._escape.stop()
        self._points.remove()
        self._value.remove()
        self.show_arrows(False)

    @property
    def is_dragging(self) -> bool:
        """Whether the mouse drags the handle."""
        return self._start is not None

    def show_arrows(self, is_shown: bool) -> None:
        """Show or hide arrows and arcs at the pivot."""
        if self._arrows is not None:
            self._arrows.remove()
            self._arrows = None
        if is_shown:
            self._arrows = Dragger(self._view, self)
            self._arrows.snap(self._steps)
            self._place()

    def use_points(self, is_on: bool) -> None:
        """Switch whether the mouse drags points, or acts as usual."""
        self._points.is_on = is_on

    def snap(self, steps) -> None:
        """Set the steps of the arrows, (mm, degrees), or None."""
        self._steps = steps
        if self._arrows is not None:
            self._arrows.snap(steps)

    def _follow(self, _moving, _before) -> None:
        if not self._has_arrow:
            self._place()

    def _place(self) -> None:
        """Move the arrows to the present motion."""
        if self._arrows is not None:
            self._arrows.place(self._moving.pivot, self._moving.motion)

    # -- called by the arrows

    def on_grab(self) -> None:
        """Start a drag of the arrows."""
        self._start = self._moving.motion, self._moving.pivot
        self._pull = Pull(self._moving.motion)
        self._has_arrow = True
        self._escape.start()

    def on_drag(self, translation, axis, angle: float) -> None:
        """Handle a drag of the arrows."""
        if self._start is None:
            return
        motion, pivot = self._start
        if self.moves_pivot:
            place = [a + b for a, b in zip(pivot, translation)]
            self._moving.set(motion.about(pivot, place))
        else:
            self._go_to(motion.turned(translation, axis, angle))

    def on_release(self) -> None:
        """End the drag; a value that was being typed counts."""
        if self._pull is not None and self._pull.text:
            self.on_key("\n")
        self._end()
        self._place()
        self._owner.settle()

    def _go_to(self, motion) -> None:
        if self._pull.moved(motion):
            self._moving.set(motion)
        self._value.show(self._pull.described())

    def _end(self) -> None:
        self._start = self._pull = None
        self._has_arrow = False
        self._escape.stop()
        self._value.show("")

    # -- called by the view

    def on_key(self, key: str) -> bool:
        """Add a key to the value typed during a drag; Enter ends the drag there."""
        if self._pull is None:
            return False
        if key != "\n":
            is_taken = self._pull.type(key)
            self._value.show(self._pull.described())
            return is_taken
        value = number_in(self._pull.text, "deg" if self._pull.is_turn else "mm")
        if value is not None:
            motion = self._pull.with_value(value)
            self._let_go()
            self._moving.set(motion)
        return True

    def on_resize(self) -> None:
        """Restore the size of the arrows on the screen."""
        if self._arrows is not None:
            self._arrows.resize()

    def _let_go(self) -> None:
        """Ignore the mouse until it is released."""
        self._end()
        for tool in (self._arrows, self._points):
            if tool is not None:
                tool.cancel()

    # -- called by points

    def on_press(self, ray):
        """Return the point to grab, or None."""
        point = self._owner.grab(ray)
        if point is not None:
            self.on_grab()
            self._has_arrow = False
        return point

    def on_pull(self, shift) -> None:
        """Handle a drag of the point."""
        if self._start is not None:
            self._go_to(self._start[0].shifted(shift))

    on_drop = on_release

    def on_escape(self) -> bool:
        """Undo a drag; return False without one, so that Escape keeps its usual effect."""
        if self._start is None:
            return False
        before = self._start[0]
        self._let_go()
        self._moving.set(before)
        return True
