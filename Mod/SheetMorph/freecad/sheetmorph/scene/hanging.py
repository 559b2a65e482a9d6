# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node that is added temporarily to another scene."""


class Hanging:
    """A node in a scene until `remove`; the view or object of the scene may vanish earlier."""

    def __init__(self, root, node):
        """Add a node to `root`, a group node, which this object keeps alive."""
        self._root, self._node = root, node
        root.addChild(node)

    def remove(self) -> None:
        """Remove the node; a second call does nothing."""
        if self._root is not None and self._root.findChild(self._node) >= 0:
            self._root.removeChild(self._node)
        self._root = self._node = None
