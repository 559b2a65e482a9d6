# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node drawn in place of a part, hidden and shown as the part is."""

from pivy import coin

from freecad.sheetmorph.scene.hanging import Hanging


class InPlace:
    """Until ``remove``; the document knows nothing of it.

    The part's own switch stays as it is: FreeCAD reads there whether the part is shown, and sets it
    when somebody hides the part.
    """

    def __init__(self, view_object, root, node):
        """``view_object``: of the part; ``root``: a group in which ``node`` hangs meanwhile."""
        self._part, self._mesh = view_object.RootNode, view_object.SwitchNode
        self._unseen, self._shown = coin.SoSwitch(), coin.SoSwitch()  # off as they are made
        self._part.replaceChild(self._mesh, self._unseen)
        self._unseen.addChild(self._mesh)
        self._shown.addChild(node)
        self._hanging = Hanging(root, self._shown)
        self._sensor = coin.SoFieldSensor(self._follow, None)
        self._sensor.attach(self._mesh.whichChild)
        self._follow()

    def remove(self) -> None:
        """Draws the part again; a second time there is nothing to do."""
        if self._sensor is not None:
            self._sensor.detach()
        self._sensor = None  # which knows this object: what is drawn would live on with both
        self._hanging.remove()
        self._shown.removeAllChildren()
        if self._part.findChild(self._unseen) >= 0:
            self._part.replaceChild(self._unseen, self._mesh)

    def _follow(self, *_) -> None:
        is_shown = self._mesh.whichChild.getValue() >= 0
        self._shown.whichChild = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE
