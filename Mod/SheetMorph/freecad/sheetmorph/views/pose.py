# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a pose in the tree; a double click applies it."""

from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import View


class PoseView(View):
    """A saved pose."""

    icon = "Pose"

    def doubleClicked(self, _view_object) -> bool:
        """Apply the pose."""
        menus.apply_pose(self.object)
        return True

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Add the entries of a pose."""
        menus.add_pose_actions(menu, self.object)
        return False
