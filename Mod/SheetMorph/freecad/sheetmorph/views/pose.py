# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a pose looks in the tree; a double click takes the morph there."""

from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import View


class PoseView(View):
    """A pose kept by name."""

    icon = "Pose"

    def doubleClicked(self, _view_object) -> bool:
        """Moves all handles to where they were."""
        menus.apply_pose(self.object)
        return True

    def setupContextMenu(self, _view_object, menu) -> bool:
        """What can be done with a pose."""
        menus.add_pose_actions(menu, self.object)
        return False
