# SPDX-License-Identifier: LGPL-2.1-or-later
"""A node that hangs in somebody else's scene for a while."""


class Hanging:
    """Until ``remove``; the view or object whose scene it is may be gone by then."""

    def __init__(self, root, node):
        """``root``: a group node, kept alive here."""
        self._root, self._node = root, node
        root.addChild(node)

    def remove(self) -> None:
        """Takes the node out; a second time there is nothing to do."""
        if self._root is not None and self._root.findChild(self._node) >= 0:
            self._root.removeChild(self._node)
        self._root = self._node = None
