# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of view providers: icon, double click, context menu; no saved state."""

from freecad.sheetmorph import actions, commands, paths
from freecad.sheetmorph.views import menus


class View:
    """A view provider proxy, which stores its view object in memory only."""

    icon = ""
    opened_by = ""  # the command of a double click, without prefix

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        """Attach the view object, also after a document is opened."""
        self._view_object = view_object

    @property
    def object(self):
        """The document object."""
        return self._view_object.Object

    def getIcon(self) -> str:
        """Return the icon in the tree."""
        return paths.icon(self.icon)

    def doubleClicked(self, _view_object) -> bool:
        """Run the command of a double click, if there is one."""
        if self.opened_by:
            commands.run(f"SheetMorph_{self.opened_by}", self.object)
        return bool(self.opened_by)

    def setupContextMenu(self, _view_object, menu) -> bool:
        """Add the commands that apply to the selection; return False to keep FreeCAD's entries."""
        menus.fill(menu)
        return False

    def setEdit(self, _view_object, _mode: int) -> bool:
        """Refuse editing with FreeCAD's dragger, which would change the placement."""
        return False

    def replaceObject(self, _old, _new) -> bool:
        """Refuse replacement by drag and drop, which could turn a region into a part."""
        return False

    def dumps(self) -> None:
        """Save nothing (FreeCAD from 0.21.2)."""

    def loads(self, _state) -> None:
        """Restore nothing (FreeCAD from 0.21.2)."""

    def __getstate__(self) -> None:
        """Save nothing (FreeCAD before 0.21.2)."""

    def __setstate__(self, _state) -> None:
        """Restore nothing (FreeCAD before 0.21.2)."""


class FollowingView(View):
    """The view of an object that is deleted with its dependencies or can lack them."""

    def canDelete(self, _obj) -> bool:
        """Return True, so that FreeCAD does not warn of broken dependencies."""
        return True


class OwnerView(View):
    """The view of an object whose dependents are deleted together with it."""

    def onDelete(self, _view_object, _sub_elements) -> bool:
        """Remove the dependents in FreeCAD's undo step, with a line in the macro."""
        actions.record(actions.call("remove_dependents", actions.name(self.object)))
        return True
