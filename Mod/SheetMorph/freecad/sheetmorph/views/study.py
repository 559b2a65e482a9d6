# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a study in the tree; a double click opens its panel."""

from freecad.sheetmorph.views import menus
from freecad.sheetmorph.views.base import View


class StudyView(View):
    """A study of a morph."""

    icon = "Study"

    def doubleClicked(self, _view_object) -> bool:
        """Open the panel."""
        menus.edit_study(self.object)
        return True

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Add the entries of a study."""
        menus.add_study_actions(menu, self.object)
        return False
