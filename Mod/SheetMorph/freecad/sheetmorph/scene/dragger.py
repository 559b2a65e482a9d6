# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows and arcs in the 3D view that drag a handle: FreeCAD's dragger at the pivot."""

import math

import numpy as np
from pivy import coin

from freecad.sheetmorph import generations
from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.relay import Relay, Watch
from freecad.sheetmorph.scene.viewport import camera_node, mm_per_px
from freecad.sheetmorph.tools.local_axes import GLOBAL, to_global, to_local

SIZE = 8.0  # px: unit size of the dragger, whose arrows are ten times as long
FINEST = (0.001, 0.01)  # mm and degrees: steps without snapping


class Dragger:
    """The dragger, which reports drags until `remove`.

    Callbacks go through the view, because those of pivy call Python without its global lock.
    """

    def __init__(self, view, listener):
        """Add the dragger to a view.

        `listener` has on_grab(), on_drag(translation (3,) mm, axis (3,), degrees) and on_release().
        After `cancel`, only the release is reported.
        """
        self._view = view
        self._listener = listener
        self._is_silent = False
        self._steps = FINEST
        self._axes = GLOBAL
        self._pivot, self._turn = coin.SoTranslation(), coin.SoRotation()
        kinds = [coin.SoType.fromName(name) for name in generations.DRAGGERS]
        kind = next(found for found in kinds if not found.isBad())
        self._dragger = coin.cast(kind.createInstance(), "SoDragger")
        self._root = coin.SoAnnotation()
        # Drawn on top of the parts, so that the mouse finds it before them.
        first = coin.SoPickStyle()
        first.style = coin.SoPickStyle.SHAPE_ON_TOP
        self._root.addChild(first)
        self._root.addChild(self._pivot)
        self._root.addChild(self._turn)
        self._root.addChild(self._dragger)
        self._hanging = Hanging(view.getSceneGraph(), self._root)
        self._watch = Watch(coin.SoNodeSensor, camera_node(view), self.resize)
        self._callbacks = {
            "addStartCallback": Relay(self._grabbed),
            "addMotionCallback": Relay(self._moved),
            "addFinishCallback": Relay(self._released),
        }
        for kind, function in self._callbacks.items():
            view.addDraggerCallback(self._dragger, kind, function)

    def place(self, pivot, motion, axes: np.ndarray) -> None:
        """Show a motion (translation mm, axis, angle in degrees) about a pivot (3,) mm.

        The columns of `axes` (3, 3) are the directions of the arrows before the rotation.
        """
        was_silent, self._is_silent = self._is_silent, True
        self._axes = axes
        self._pivot.translation.setValue(*pivot)
        rows = np.eye(4)
        rows[:3, :3] = axes.T  # Coin multiplies rows
        self._turn.rotation.setValue(coin.SbRotation(coin.SbMatrix(*rows.ravel().tolist())))
        direction = coin.SbVec3f(*to_local(axes, motion.axis))
        rotation = coin.SbRotation(direction, math.radians(motion.angle))
        self._field("translation").setValue(*to_local(axes, motion.translation))
        self._field("rotation").setValue(rotation)
        self._set_steps()
        self.resize()
        self._is_silent = was_silent

    def snap(self, steps) -> None:
        """Drag in steps (mm, degrees) from the start; None drags freely."""
        self._steps = steps or FINEST
        self._set_steps()

    def cancel(self) -> None:
        """Report nothing more of this drag."""
        self._is_silent = True

    def remove(self) -> None:
        """Remove the dragger; the view may be closed already."""
        self._watch.end()
        self._hanging.remove()
        try:
            for kind, function in self._callbacks.items():
                self._view.removeDraggerCallback(self._dragger, kind, function)
        except RuntimeError:  # the view is closed
            pass
        for relay in self._callbacks.values():
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
        shift = self._field("translation").getValue().getValue()
        vectors = (tuple(map(rounded, vector)) for vector in (shift, axis.getValue()))
        translation, direction = (to_global(self._axes, vector) for vector in vectors)
        self._listener.on_drag(translation, direction, rounded(math.degrees(angle)))

    def _released(self, _dragger) -> None:
        self._is_silent = False
        self._listener.on_release()

    def resize(self) -> None:
        """Give the dragger the same size in px at every zoom.

        FreeCAD's own method is not available in Python.
        """
        shift = self._turn.rotation.getValue().multVec(self._field("translation").getValue())
        place = self._pivot.translation.getValue() + shift
        try:
            scale = mm_per_px(self._view, place)
        except RuntimeError:  # the view is closed, which changed its camera
            return
        self._field("draggerSize").setValue(SIZE * scale)


def rounded(value: float) -> float:
    """Return a value without the noise of single precision; 1e-4 is finer than a mouse."""
    return round(float(value), 4) + 0.0
