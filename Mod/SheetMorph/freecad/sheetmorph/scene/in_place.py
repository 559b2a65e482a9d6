# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node drawn in place of a part, hidden and shown as the part is."""

from pivy import coin

from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.relay import Relay


class InPlace:
    """Until ``remove``; the document knows nothing of it.

    The part's own switch stays as it is: FreeCAD reads there whether the part is shown, and sets it
    when somebody hides the part.
    """

    def __init__(self, view_object, root, node, also=()):
        """``view_object``: of the part; ``root``: a group in which ``node`` hangs meanwhile;
        ``also``: views of other objects that stand for the part, such as its deformed shape."""
        self._shown = coin.SoSwitch()  # off as it is made
        self._shown.addChild(node)
        self._hidden = [_Hidden(view, self._follow) for view in (view_object, *also)]
        self._hanging = Hanging(root, self._shown)
        self._follow()

    def remove(self) -> None:
        """Draws the part again; a second time there is nothing to do."""
        hidden, self._hidden = self._hidden, []
        for each in hidden:
            each.remove()
        self._hanging.remove()
        self._shown.removeAllChildren()

    def _follow(self, *_) -> None:
        is_shown = any(each.is_on for each in self._hidden)
        self._shown.whichChild = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE


class _Hidden:
    """What an object draws, out of sight; calls a function when its object is shown or hidden."""

    def __init__(self, view_object, on_change):
        self._root, self._drawn = view_object.RootNode, view_object.SwitchNode
        self._unseen = coin.SoSwitch()  # off as it is made
        self._root.replaceChild(self._drawn, self._unseen)
        self._unseen.addChild(self._drawn)
        self._relay = Relay(on_change)  # Coin keeps what it calls for ever
        self._sensor = coin.SoFieldSensor(self._relay, None)
        self._sensor.attach(self._drawn.whichChild)

    @property
    def is_on(self) -> bool:
        """Whether the object is shown."""
        return self._drawn.whichChild.getValue() >= 0

    def remove(self) -> None:
        """Draws the object again."""
        self._sensor.detach()
        self._sensor = None  # which knows its owner: what is drawn would live on with both
        self._relay.let_go()
        if self._root.findChild(self._unseen) >= 0:
            self._root.replaceChild(self._unseen, self._drawn)
