# SPDX-License-Identifier: LGPL-2.1-or-later
"""The vertex, mid-point or surface point under the mouse, found without a pause of the window."""

from concurrent import futures

import numpy as np

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.garbage import collecting
from freecad.sheetmorph.interaction.frame_worker import ENDING, give_way
from freecad.sheetmorph.qt import QtCore
from freecad.sheetmorph.tools import places

RINGS = (3.0, 8.0)  # px: rays this far from the mouse find a corner that the mouse itself misses
EIGHT = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]
RAYS = np.array([(0.0, 0.0), *((ring * x, ring * y) for ring in RINGS for x, y in EIGHT)])


class NearMouse(QtCore.QObject):
    """The search on displayed meshes until `remove`; a thread builds the search trees.

    A tree of a million triangles takes a second. Until it is ready, nothing is found; then
    `on_ready()` is called.
    """

    _ready = QtCore.Signal()
    _ended = QtCore.Signal()

    def __init__(self, on_ready):
        super().__init__()
        self._on_ready = on_ready
        self._ready.connect(self._tell, QtCore.Qt.QueuedConnection)
        self._meshes, self._built = {}, ({}, {})  # the latter: the meshes of trees, and the trees
        self._thread = None
        self._ended.connect(self._let_go, QtCore.Qt.QueuedConnection)

    @property
    def is_looking(self) -> bool:
        """Whether meshes are searched, or will be as soon as their trees are ready."""
        return bool(self._meshes)

    def look_at(self, meshes: dict) -> None:
        """Search these meshes, (points (n, 3), triangles (m, 3)) by part, from now on."""
        if self._thread is None:
            collecting().hold()
            self._thread = futures.ThreadPoolExecutor(max_workers=1, initializer=give_way)
        self._meshes = meshes
        self._thread.submit(self._build, meshes)

    def at(self, camera, mouse):
        """Return the places.Place at the mouse (2,) px, None without one.

        It is the nearest vertex or mid-point, else the point of the surface under the mouse. At the
        corner of a part, the triangle under the mouse need not have the nearest vertex.
        """

        def away(points):
            return camera.away(points, mouse)

        found, trees = [], self._trees_near(camera, mouse)
        for place in mouse + RAYS:
            near, far = camera.line(*place)
            part, hit = first_hit(trees, near, far - near)
            if hit is not None:
                found.append(places.place_near(part, self._meshes[part], hit, away))
        found.sort(key=lambda one: (one.kind == places.SURFACE, away(self.position(one))[0]))
        return found[0] if found else None

    def position(self, place) -> np.ndarray:
        """Return the position (3,) of a place on the searched meshes."""
        return place.at(self._meshes[place.part][0])

    def forget(self) -> None:
        """Find nothing until `look_at`."""
        self._meshes, self._built = {}, ({}, {})

    def remove(self) -> None:
        """Release the trees, without waiting for the thread."""
        self.forget()
        self._on_ready = None
        thread, self._thread = self._thread, None
        if thread is not None:
            ENDING.add(self)
            thread.submit(self._ended.emit)
            thread.shutdown(wait=False)

    def _let_go(self) -> None:
        ENDING.discard(self)
        collecting().release()

    def _build(self, meshes: dict) -> None:
        """Build the trees, unless newer meshes came; runs in the thread."""
        trees = {}
        for name, (points, triangles) in meshes.items():
            if self._meshes is not meshes:
                return
            if not len(triangles):
                continue
            tree = kernel.core().PickingTree(points, triangles)
            trees[name] = tree, points.min(axis=0), points.max(axis=0)
        self._built = meshes, trees
        self._ready.emit()

    def _tell(self) -> None:
        if self._built[0] is self._meshes and self._meshes:
            self._on_ready()

    def _trees_near(self, camera, mouse) -> dict:
        """Return the trees of the parts that may be seen within the rays."""
        meshes, trees = self._built
        if meshes is not self._meshes:
            return {}
        around = mouse + RAYS
        boxes = {name: box for name, (_, *box) in trees.items()}
        return {name: trees[name][0] for name in boxes if camera.may_show(*boxes[name], around)}


def first_hit(trees: dict, origin, direction) -> tuple:
    """Return the name of the tree that a ray meets first, and the kernel's hit, or ("", None)."""
    found, nearest = "", None
    for name, tree in trees.items():
        hit = tree.nearest_hit(origin, direction)
        if hit is not None and (nearest is None or hit.distance < nearest.distance):
            found, nearest = name, hit
    return found, nearest
