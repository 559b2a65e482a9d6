# SPDX-License-Identifier: LGPL-2.1-or-later
"""A clickable mark on every handle except the one with the arrows.

Marks are drawn on top of the parts, apart from each other and from the arrows.
"""

import numpy as np
from pivy import coin

from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.scene import colours, nodes
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.relay import Watch
from freecad.sheetmorph.scene.viewport import camera_node, camera_of
from freecad.sheetmorph.tools.spreading import spread

SIZE = 13.0  # px
LEAST = 26.0  # px between two marks
ARROWS = 100.0  # px around the handle with the arrows, which are 80 px long
ROOT = "SheetMorphHandleMarks"


class HandleMarks(QtCore.QObject):
    """The marks until `remove`; a click on mark k calls `choose(k)`."""

    def __init__(self, view, choose):
        super().__init__()
        self._view, self._choose = view, choose
        self._places, self._taken, self._shown = np.empty((0, 3)), None, np.empty((0, 2))
        self._is_pressed = False
        self._points, self._lines = coin.SoCoordinate3(), coin.SoCoordinate3()
        self._marks, self._leaders = coin.SoPointSet(), coin.SoLineSet()
        root = coin.SoAnnotation()
        root.setName(ROOT)
        for node in nodes.unlit(colours.ROLES["handle"], 1.5, SIZE):
            root.addChild(node)
        for node in (self._lines, self._leaders, self._points, self._marks):
            root.addChild(node)
        self._hanging = Hanging(view.getSceneGraph(), root)
        self._watch = Watch(coin.SoNodeSensor, camera_node(view), self._draw)
        self._widget = view.graphicsView().viewport()
        self._widget.installEventFilter(self)

    def show(self, places) -> None:
        """Mark places (n, 3) mm, global."""
        self._places = np.asarray(places, float).reshape(-1, 3)
        self._draw()

    def follow(self, moving, _before) -> None:
        """Leave room for the arrows of a motion.Moving."""
        self._taken = moving.place
        self._draw()

    def remove(self) -> None:
        """Remove the marks; the view may be closed already."""
        self._watch.end()
        self._hanging.remove()
        try:
            self._widget.removeEventFilter(self)
        except RuntimeError:
            pass  # the view is closed
        self._view = self._widget = self._choose = None

    def place_of(self, number: int) -> tuple[float, float]:
        """Return the position of a mark in the view, px from the lower left."""
        x, y = self._shown[number]
        return float(x), float(y)

    def eventFilter(self, _watched, event) -> bool:
        """Consume a click on a mark."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseButtonPress and event.button() == QtCore.Qt.LeftButton:
            number = self._at(event)
            self._is_pressed = number is not None
            if self._is_pressed:
                self._choose(number)
            return self._is_pressed
        if kind == QtCore.QEvent.MouseButtonRelease and self._is_pressed:
            self._is_pressed = False
            return True
        return kind == QtCore.QEvent.MouseMove and self._is_pressed

    def _at(self, event):
        """Return the number of the mark under the mouse, None without one."""
        if not len(self._shown):
            return None
        ratio = self._widget.devicePixelRatioF()
        x, y = event.pos().x(), self._widget.height() - 1 - event.pos().y()
        away = np.linalg.norm(self._shown - np.array([x, y]) * ratio, axis=1)
        nearest = int(away.argmin())
        return nearest if away[nearest] <= 0.5 * LEAST else None

    def _draw(self) -> None:
        try:
            camera = camera_of(self._view)
        except (RuntimeError, AttributeError):
            return  # the view is closed
        pixels = camera.pixels(self._places)
        taken = ()
        if self._taken is not None and len(self._places):
            taken = ((camera.pixels([self._taken])[0, :2], ARROWS),)
        self._shown = spread(pixels[:, :2], LEAST, taken)
        marks = [on_screen(camera, x, y, z) for (x, y), z in zip(self._shown, pixels[:, 2])]
        put(self._points, marks)
        self._marks.numPoints = len(marks)
        put(self._lines, [end for pair in zip(self._places, marks) for end in pair])
        self._leaders.numVertices.setNum(len(marks))
        for k in range(len(marks)):
            self._leaders.numVertices.set1Value(k, 2)


def on_screen(camera, x: float, y: float, depth: float) -> np.ndarray:
    """Return the point (3,) mm at a pixel and a depth from -1 (near) to 1."""
    found = np.linalg.solve(camera.to_pixels, np.array([x, y, depth, 1.0]))
    return found[:3] / found[3]


def put(coordinates, points) -> None:
    """Write points (n, 3) into an SoCoordinate3."""
    coordinates.point.setNum(len(points))
    for k, point in enumerate(points):
        coordinates.point.set1Value(k, *(float(c) for c in point))
