# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse while a region is picked: hover, clicks and figures drawn on the screen."""

from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.scene.figure import Figure
from freecad.sheetmorph.scene.viewport import Listener, Viewport, take_every_move
from freecad.sheetmorph.tools import figures
from freecad.sheetmorph.tools.part_mesh import NOTHING
from freecad.sheetmorph.tools.rims import Ray
from freecad.sheetmorph.tools.sentences import DrawnFigure


class PickMouse(Listener):
    """The link from the mouse to a picker, with a host that reacts.

    The host has `picked()`, called after every pick, `accept` and `reject`. It has `hover(ray)` and
    `click(ray)` for events without a picker or target, and `turn_wheel(steps)` for a brush.
    """

    def __init__(self, view, host):
        self._host = host
        self._picker = self._seen = None
        self._viewport = Viewport(view, self)
        self._figure = Figure(self._viewport.widget, colours.HOVER)
        self._drawing = self._mode = None
        self._place = None

    def use(self, picker, seen) -> None:
        """Act on a RegionPicker that a PickView shows, or on none."""
        self._end()
        self._picker, self._seen = picker, seen
        self._figure.show_outline(None)

    def remove(self) -> None:
        """Release the mouse."""
        take_every_move(False)
        self._figure.remove()
        self._viewport.remove()
        self._picker = self._seen = self._host = None

    def on_move(self, pointer) -> None:
        """Show the vertices that a click would pick."""
        self._place = pointer and pointer.place
        ray = None if pointer is None else Ray(pointer.origin, pointer.direction)
        if self._picker is None:
            self._host.hover(ray)
            return
        aimed = NOTHING
        if self._is_brush():
            aimed = self._show_brush()
        elif ray is not None and not self._draws():
            aimed = self._picker.aim(ray)
        self._seen.show_aimed(aimed)
        self._host.hover(None if ray is None or len(aimed) or self._draws() else ray)

    def on_click(self, pointer) -> None:
        """Pick the vertices under the mouse."""
        ray = Ray(pointer.origin, pointer.direction)
        if self._picker is None:
            self._host.click(ray)
            return
        target = self._picker.aim(ray)
        if len(target):
            mode = self._picker.mode(pointer.shift, pointer.control)
            self._picker.take(target, mode, self._picker.told(ray))
            self._host.picked()
        else:
            self._host.click(ray)

    def on_press(self, pointer) -> bool:
        """Claim the left button for a drawing tool."""
        if not self._draws():
            return False
        options = self._picker.options
        self._mode = self._picker.mode(pointer.shift, pointer.control)
        self._drawing = figures.Drawing(options.what, pointer.place, options.radius)
        take_every_move(options.what == figures.LASSO)
        self._go_on(self._drawing.outline())
        return True

    def on_drag(self, pointer) -> None:
        """Continue the figure; a brush shows its vertices immediately."""
        self._place = pointer.place
        if self._drawing is not None:
            self._go_on(self._drawing.go_to(pointer.place))

    def on_release(self, _pointer) -> None:
        """Pick the vertices in the figure; an empty one changes nothing."""
        if self._drawing is None:
            return
        if self._drawing.has_extent:
            camera = self._viewport.camera()
            last = self._drawing.rest() if self._is_brush() else self._drawing.outline()
            if last is not None:
                self._picker.paint(camera, last)
            self._picker.take_painted(self._mode, self._said(camera))
        self._end()
        self._host.picked()
        if self._is_brush():
            self._seen.show_aimed(self._show_brush())

    def on_wheel(self, steps: float) -> bool:
        """Change the size of the brush."""
        if not self._is_brush():
            return False
        self._host.turn_wheel(steps)
        self._seen.show_aimed(self._show_brush())
        return True

    def on_escape(self) -> None:
        """Discard the present figure, or cancel without one."""
        if self._drawing is not None:
            self._end()
        else:
            self._host.reject()

    def on_enter(self) -> None:
        """Accept the panel."""
        self._host.accept()

    def _said(self, camera) -> dict:
        """Return the drawn figure as a selector."""
        options = self._picker.options
        return DrawnFigure(
            options.what,
            self._drawing.places,
            camera.view,
            figures.number(options.radius) if self._is_brush() else 0,
            options.through,
        ).said()

    def _draws(self) -> bool:
        return self._picker is not None and self._picker.options.what in figures.DRAWN

    def _is_brush(self) -> bool:
        return self._picker is not None and self._picker.options.what == figures.BRUSH

    def _show_brush(self):
        """Draw the circle of the brush; return the vertices in it."""
        if self._place is None:
            self._figure.show_outline(None)
            return NOTHING
        outline = figures.circle(self._place, self._picker.options.radius)
        self._figure.show_outline(outline)
        return self._picker.aim_inside(self._viewport.camera(), outline)

    def _go_on(self, outline) -> None:
        if self._is_brush():
            self._seen.show_aimed(self._picker.paint(self._viewport.camera(), outline))
        self._figure.show_outline(self._drawing.outline())

    def _end(self) -> None:
        """Discard the present figure."""
        take_every_move(False)
        self._drawing = None
        self._figure.show_outline(None)
        if self._picker is not None:
            self._picker.forget_painted()
            self._seen.show_aimed(NOTHING)
