# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who writes meshes into Coin's nodes: the compiled module, or pivy where that does not fit.

It fits where it is loaded into the Coin that FreeCAD draws with; tried once, on nodes of its own.
"""

import functools
import importlib

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes, through_pivy

FAULTS = (ImportError, OSError, SyntaxError, AttributeError, TypeError, ValueError)
TRIED = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]])


class Direct:
    """The nodes are filled by the module `sheetmorph._coin`, without Python in between."""

    def __init__(self):
        """Raises ImportError, or ValueError if it does not know FreeCAD's nodes."""
        self._module = importlib.import_module("sheetmorph._coin")
        theirs, ours = coin.SoDB.getVersion(), self._module.coin_version()
        if theirs != ours:
            raise ValueError(f"it is for {ours}, FreeCAD draws with {theirs}")
        drawn = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        self.mesh_nodes(drawn, TRIED, np.array([[0, 1, 2]], np.int32), 0.5)
        if not np.array_equal(nodes.rows(drawn[0].point), TRIED):
            raise ValueError("what it writes is not what FreeCAD sees")

    def mesh_nodes(self, drawn, points: np.ndarray, triangles: np.ndarray, crease: float):
        """What draws a mesh through three nodes, as `through_pivy.MeshNodes`."""
        addresses = tuple(int(node.this) for node in drawn)
        return self._module.MeshNodes(addresses, points, triangles, crease)

    def value_colours(self, material, ramp: np.ndarray, missing):
        """What colours a material by values, as `through_pivy.ValueColours`."""
        return self._module.ValueColours(int(material.this), ramp, missing)

    def show_patch(self, drawn, triangles: np.ndarray, vertices: np.ndarray) -> bool:
        """Draws a patch through three nodes, as `through_pivy.show_patch`."""
        addresses = tuple(int(node.this) for node in drawn)
        return self._module.show_patch(addresses, triangles, vertices)


class ThroughPivy:
    """The same where the compiled module was not built or does not fit."""

    mesh_nodes = through_pivy.MeshNodes
    value_colours = through_pivy.ValueColours
    show_patch = staticmethod(through_pivy.show_patch)


@functools.cache
def chosen() -> tuple:
    """Who draws, and why it is not the compiled module; empty if it is."""
    try:
        return Direct(), ""
    except FAULTS as error:
        return ThroughPivy, " ".join(str(error).split())


def drawer():
    """Direct or ThroughPivy."""
    return chosen()[0]


def report() -> str:
    """A line on who draws, for *Check Installation*."""
    _, reason = chosen()
    if not reason:
        return "View: filled by the kernel."
    return f"View: filled through pivy, slower ({reason})."
