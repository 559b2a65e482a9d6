# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows and arcs in the 3D view that drag a handle: FreeCAD's own dragger, at the pivot."""

import math

from pivy import coin

from freecad.sheetmorph import generations
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.relay import Relay
from freecad.sheetmorph.scene.viewport import camera_node, mm_per_px

SIZE = 8.0  # px: what the dragger takes for one, its arrows are ten times as long
FINEST = (0.001, 0.01)  # mm and degrees: steps without snapping


class Dragger:
    """Reports drags until ``remove`` is called.

    Callbacks go through the view: pivy's own ones call Python without the interpreter's lock.
    """

    def __init__(self, view, listener):
        """``listener``: on_grab(), on_drag(translation (3,) mm, axis (3,), degrees), on_release().

        What is dragged after ``cancel`` is not reported, only the release.
        """
        self._view = view
        self._listener = listener
        self._is_silent = False
        self._steps = FINEST
        self._pivot = coin.SoTranslation()
        kinds = [coin.SoType.fromName(name) for name in generations.DRAGGERS]
        kind = next(found for found in kinds if not found.isBad())
        self._dragger = coin.cast(kind.createInstance(), "SoDragger")
        self._root = coin.SoAnnotation()
        # Drawn over the parts, and so grabbed before them too.
        first = coin.SoPickStyle()
        first.style = coin.SoPickStyle.SHAPE_ON_TOP
        self._root.addChild(first)
        self._root.addChild(self._pivot)
        self._root.addChild(self._dragger)
        self._hanging = Hanging(view.getSceneGraph(), self._root)
        self._camera = camera_node(view)
        self._resized = Relay(self.resize)
        self._sensor = coin.SoNodeSensor(self._resized, None)
        self._sensor.attach(self._camera)
        self._callbacks = {
            "addStartCallback": Relay(self._grabbed),
            "addMotionCallback": Relay(self._moved),
            "addFinishCallback": Relay(self._released),
        }
        for kind, function in self._callbacks.items():
            view.addDraggerCallback(self._dragger, kind, function)

    def place(self, pivot, motion) -> None:
        """Shows a motion (translation mm, axis, angle degrees) about a pivot (3,) mm."""
        was_silent, self._is_silent = self._is_silent, True
        self._pivot.translation.setValue(*pivot)
        rotation = coin.SbRotation(coin.SbVec3f(*motion.axis), math.radians(motion.angle))
        self._field("translation").setValue(*motion.translation)
        self._field("rotation").setValue(rotation)
        self._set_steps()
        self.resize()
        self._is_silent = was_silent

    def snap(self, steps) -> None:
        """Drags in steps (mm, degrees) from where they begin; None: freely."""
        self._steps = steps or FINEST
        self._set_steps()

    def cancel(self) -> None:
        """Keeps silent about the rest of the drag."""
        self._is_silent = True

    def remove(self) -> None:
        """Takes the dragger out of the view; the view may be closed already."""
        self._sensor.detach()
        self._hanging.remove()
        try:
            for kind, function in self._callbacks.items():
                self._view.removeDraggerCallback(self._dragger, kind, function)
        except RuntimeError:  # the view is closed
            pass
        for relay in (self._resized, *self._callbacks.values()):
            relay.let_go()

    def _set_steps(self) -> None:
        length, angle = self._steps
        self._field("translationIncrement").setValue(length)
        self._field("rotationIncrement").setValue(math.radians(angle))

    def _field(self, name: str):
        return self._dragger.getField(name)

    def _grabbed(self, _dragger) -> None:
        self._listener.on_grab()

    def _moved(self, _dragger) -> None:
        if self._is_silent:
            return
        rotation = self._field("rotation").getValue()
        axis, angle = rotation.getAxisAngle()
        translation = tuple(rounded(v) for v in self._field("translation").getValue().getValue())
        direction = tuple(rounded(v) for v in axis.getValue())
        self._listener.on_drag(translation, direction, rounded(math.degrees(angle)))

    def _released(self, _dragger) -> None:
        self._is_silent = False
        self._listener.on_release()

    def resize(self, *_) -> None:
        """The same size in px at every zoom, in every view; FreeCAD's way is not for Python."""
        place = self._pivot.translation.getValue() + self._field("translation").getValue()
        try:
            scale = mm_per_px(self._view, place)
        except RuntimeError:  # the view is closed, and its camera told us so
            return
        self._field("draggerSize").setValue(SIZE * scale)


def rounded(value: float) -> float:
    """Without the noise of single precision; 1e-4 mm or degrees is far finer than a mouse."""
    return round(float(value), 4) + 0.0
