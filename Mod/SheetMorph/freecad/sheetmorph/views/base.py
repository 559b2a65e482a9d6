# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view providers share: icon, nothing saved, nothing edited by FreeCAD's own dragger."""

from freecad.sheetmorph import actions, paths


class View:
    """A view provider proxy; keeps its view object in memory only."""

    icon = ""

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object) -> None:
        """Called when the object gets its view, also after opening a document."""
        self._view_object = view_object

    @property
    def object(self):
        """The document object."""
        return self._view_object.Object

    def getIcon(self) -> str:
        """The icon in the tree."""
        return paths.icon(self.icon)

    def setEdit(self, _view_object, _mode: int) -> bool:
        """No editing by FreeCAD's dragger: it would move the placement."""
        return False

    def replaceObject(self, _old, _new) -> bool:
        """Nothing takes another's place by being dropped on it: a region would become the part."""
        return False

    def dumps(self) -> None:
        """Nothing is saved (FreeCAD from 0.21.2)."""

    def loads(self, _state) -> None:
        """Nothing is restored (FreeCAD from 0.21.2)."""

    def __getstate__(self) -> None:
        """Nothing is saved (FreeCAD before 0.21.2)."""

    def __setstate__(self, _state) -> None:
        """Nothing is restored (FreeCAD before 0.21.2)."""


class FollowingView(View):
    """A view of what goes along with what it depends on, or does without it."""

    def canDelete(self, _obj) -> bool:
        """No warning that it might break, whatever of what it depends on is deleted."""
        return True


class OwnerView(View):
    """A view of what other objects of ours depend on: deleted in the tree, it takes them along."""

    def onDelete(self, _view_object, _sub_elements) -> bool:
        """One undo step, and a line in a macro, as for all that FreeCAD deletes."""
        actions.record(actions.call("remove_dependents", actions.name(self.object)))
        return True
