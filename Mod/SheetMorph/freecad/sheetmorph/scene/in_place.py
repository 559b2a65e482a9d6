# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node drawn in place of a part, visible whenever the part would be."""

from pivy import coin

from freecad.sheetmorph.scene.hanging import Hanging
from freecad.sheetmorph.scene.relay import Watch


class InPlace:
    """The replacement of a drawing until `remove`, without a change of the document.

    The part's own switch keeps its state, since FreeCAD reads and sets the visibility there.
    """

    def __init__(self, view_object, root, node, also=()):
        """Hide a part and draw `node` under the group `root` instead.

        `view_object` is that of the part. `also` are views of other objects that represent the
        part, such as its deformed shape.
        """
        self._shown = coin.SoSwitch()  # a new switch is off
        self._shown.addChild(node)
        self._hidden = [_Hidden(view, self._follow) for view in (view_object, *also)]
        self._hanging = Hanging(root, self._shown)
        self._follow()

    def remove(self) -> None:
        """Draw the part again; a second call does nothing."""
        hidden, self._hidden = self._hidden, []
        for each in hidden:
            each.remove()
        self._hanging.remove()
        self._shown.removeAllChildren()

    def _follow(self) -> None:
        is_shown = any(each.is_on for each in self._hidden)
        self._shown.whichChild = coin.SO_SWITCH_ALL if is_shown else coin.SO_SWITCH_NONE


class _Hidden:
    """The hidden drawing of an object, with a callback when its visibility changes."""

    def __init__(self, view_object, on_change):
        self._root, self._drawn = view_object.RootNode, view_object.SwitchNode
        self._unseen = coin.SoSwitch()  # a new switch is off
        self._root.replaceChild(self._drawn, self._unseen)
        self._unseen.addChild(self._drawn)
        self._watch = Watch(coin.SoFieldSensor, self._drawn.whichChild, on_change)

    @property
    def is_on(self) -> bool:
        """Whether the object is visible."""
        return self._drawn.whichChild.getValue() >= 0

    def remove(self) -> None:
        """Draw the object again."""
        self._watch.end()
        if self._root.findChild(self._unseen) >= 0:
            self._root.replaceChild(self._unseen, self._drawn)
