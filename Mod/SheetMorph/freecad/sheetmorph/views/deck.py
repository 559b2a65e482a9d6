# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a deck and of the shells of its properties."""

import numpy as np

from freecad.sheetmorph.bridge.rest import read_kept
from freecad.sheetmorph.scene import colours
from freecad.sheetmorph.views.base import OwnerView
from freecad.sheetmorph.views.patches import PatchView


class DeckView(OwnerView):
    """A file, visible only through its parts."""

    icon = "Deck"


class ShellsView(PatchView):
    """The shells of a property, coloured where they are switched on."""

    icon = "Shells"
    drawn_properties = ("Part", "Number")

    def __init__(self, view_object):
        super().__init__(view_object)
        view_object.Visibility = False

    def patches(self, obj) -> list:
        """Return the vertices of its elements."""
        labels = None if obj.Part is None else read_kept(obj.Part).labels
        rows = labels.groups.get(f"PID {obj.Number}") if labels is not None else None
        if rows is None:
            return []
        vertices = np.unique(read_kept(obj.Part).triangles[rows])
        return [(obj.Part, vertices, colours.of_number(obj.Number))]
