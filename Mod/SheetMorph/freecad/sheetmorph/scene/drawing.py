# SPDX-License-Identifier: LGPL-2.1-or-later
"""The writer of meshes into Coin nodes: the compiled module, else pivy.

The compiled module fits if it uses the Coin library that FreeCAD draws with. A single test on
separate nodes decides.
"""

import functools
import importlib

import numpy as np
from pivy import coin

from freecad.sheetmorph.scene import nodes, through_pivy

FAULTS = (ImportError, OSError, SyntaxError, AttributeError, TypeError, ValueError)
TRIED = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]])


class Direct:
    """The compiled module `sheetmorph._coin`, which fills nodes without Python."""

    def __init__(self):
        """Load and test the module.

        Raises ImportError, or ValueError if the module cannot use FreeCAD's nodes.
        """
        self._module = importlib.import_module("sheetmorph._coin")
        theirs, ours = coin.SoDB.getVersion(), self._module.coin_version()
        if theirs != ours:
            raise ValueError(f"it is built for {ours}, but FreeCAD draws with {theirs}")
        drawn = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        self.mesh_nodes(drawn, TRIED, np.array([[0, 1, 2]], np.int32), 0.5)
        if not np.array_equal(nodes.rows(drawn[0].point), TRIED):
            raise ValueError("FreeCAD does not see what it writes")

    def mesh_nodes(self, drawn, points: np.ndarray, triangles: np.ndarray, crease: float):
        """Return an object that draws a mesh through three nodes, as `through_pivy.MeshNodes`."""
        addresses = tuple(int(node.this) for node in drawn)
        return self._module.MeshNodes(addresses, points, triangles, crease)

    def value_colours(self, material, ramp: np.ndarray, missing):
        """Return an object that colours a material, as `through_pivy.ValueColours`."""
        return self._module.ValueColours(int(material.this), ramp, missing)

    def show_patch(self, drawn, triangles: np.ndarray, vertices: np.ndarray) -> bool:
        """Draw a patch through three nodes, as `through_pivy.show_patch`."""
        addresses = tuple(int(node.this) for node in drawn)
        return self._module.show_patch(addresses, triangles, vertices)


class ThroughPivy:
    """The same functions in Python, where the compiled module is missing or does not fit."""

    mesh_nodes = through_pivy.MeshNodes
    value_colours = through_pivy.ValueColours
    show_patch = staticmethod(through_pivy.show_patch)


@functools.cache
def chosen() -> tuple:
    """Return the writer, and why it is not the compiled module (empty if it is)."""
    try:
        return Direct(), ""
    except FAULTS as error:
        return ThroughPivy, " ".join(str(error).split())


def drawer():
    """Return the writer, a Direct or ThroughPivy."""
    return chosen()[0]


def report() -> str:
    """Return a line about the writer for *Check Installation*."""
    _, reason = chosen()
    if not reason:
        return "View: filled by the kernel."
    return f"View: filled through pivy, slower ({reason})."
