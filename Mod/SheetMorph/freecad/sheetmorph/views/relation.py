# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a relation of form features in the tree."""

from freecad.sheetmorph.views.base import View

ICONS = {"group": "GroupFeatures", "coaxial": "MakeCoaxial", "distance": "KeepDistance"}


class RelationView(View):
    """A group, a coaxial pair or a distance."""

    icon = "GroupFeatures"

    def getIcon(self) -> str:
        """Return the icon of the type."""
        self.icon = ICONS.get(getattr(self.object, "Type", ""), "GroupFeatures")
        return super().getIcon()

    def updateData(self, _obj, name: str) -> None:
        """Update the icon after a change of type."""
        if name == "Type":
            self._view_object.signalChangeIcon()
