# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse in the 3D view while handles are moved: arrows, points, snapping, Escape."""

from freecad.sheetmorph.bridge.units import number_in
from freecad.sheetmorph.scene.cursor_value import CursorValue
from freecad.sheetmorph.scene.dragger import Dragger
from freecad.sheetmorph.scene.point_drag import EscapeWatch, PointDrag
from freecad.sheetmorph.tools.pulling import Pull


class HandleDrag:
    """Turns drags into motions until ``remove`` is called.

    ``owner``: motion() and pivot(), (3,) mm, of the handle that is moved; put(motion); settle()
    when the mouse is released; grab(ray): chooses what is there, returns its point or None.
    """

    def __init__(self, view, owner):
        self._view, self._owner = view, owner
        self._points = PointDrag(view, self)
        self._escape = EscapeWatch(self.on_escape)
        self._value = CursorValue(view)
        self._pull = None
        self._arrows = None
        self._steps = None
        self._start = None
        self.moves_pivot = False

    def remove(self) -> None:
        """Takes everything out of the view."""
        self._escape.stop()
        self._points.remove()
        self._value.remove()
        self.show_arrows(False)

    @property
    def is_dragging(self) -> bool:
        """Whether the mouse has the handle."""
        return self._start is not None

    def show_arrows(self, is_shown: bool) -> None:
        """Arrows and arcs at the pivot, or none."""
        if self._arrows is not None:
            self._arrows.remove()
            self._arrows = None
        if is_shown:
            self._arrows = Dragger(self._view, self)
            self._arrows.snap(self._steps)
            self.place()

    def use_points(self, is_on: bool) -> None:
        """Whether points are dragged, or the mouse does what it does otherwise."""
        self._points.is_on = is_on

    def snap(self, steps) -> None:
        """Steps of the arrows, (mm, degrees), or None."""
        self._steps = steps
        if self._arrows is not None:
            self._arrows.snap(steps)

    def place(self) -> None:
        """Puts the arrows where the motion is."""
        if self._arrows is not None:
            self._arrows.place(self._owner.pivot(), self._owner.motion())

    # -- what the arrows call

    def on_grab(self) -> None:
        """A drag begins."""
        self._start = self._owner.motion(), self._owner.pivot()
        self._pull = Pull(self._start[0])
        self._escape.start()

    def on_drag(self, translation, axis, angle: float) -> None:
        """The arrows were dragged."""
        if self._start is None:
            return
        motion, pivot = self._start
        if self.moves_pivot:
            place = [a + b for a, b in zip(pivot, translation)]
            self._owner.put(motion.about(pivot, place))
        else:
            self._go_to(motion.turned(translation, axis, angle))

    def on_release(self) -> None:
        """The drag has ended; a value that was being typed counts."""
        if self._pull is not None and self._pull.text:
            self.on_key("\n")
        self._end()
        self.place()
        self._owner.settle()

    def _go_to(self, motion) -> None:
        if self._pull.moved(motion):
            self._owner.put(motion)
        self._value.show(self._pull.described())

    def _end(self) -> None:
        self._start = self._pull = None
        self._escape.stop()
        self._value.show("")

    # -- what the view tells of keys and size

    def on_key(self, key: str) -> bool:
        """A value typed while the mouse has the handle: Enter ends the drag there."""
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
            self._owner.put(motion)
            self.place()
        return True

    def on_resize(self) -> None:
        """Arrows stay as large as they are on the screen."""
        if self._arrows is not None:
            self._arrows.resize()

    def _let_go(self) -> None:
        """What the mouse does until it is released is nobody's."""
        self._end()
        for tool in (self._arrows, self._points):
            if tool is not None:
                tool.cancel()

    # -- what points call

    def on_press(self, ray):
        """The point that is grabbed, or None."""
        point = self._owner.grab(ray)
        if point is not None:
            self.on_grab()
        return point

    def on_pull(self, shift) -> None:
        """The point was dragged."""
        if self._start is not None:
            self._go_to(self._start[0].shifted(shift))
            self.place()

    on_drop = on_release

    def on_escape(self) -> bool:
        """Takes a drag back; without one Escape is not ours."""
        if self._start is None:
            return False
        before = self._start[0]
        self._let_go()
        self._owner.put(before)
        return True
