# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picking a region by clicks and drawn figures, with undo."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad.sheetmorph.tools.figures import BRUSH, Camera, number
from freecad.sheetmorph.tools.part_mesh import NOTHING, to_ids
from freecad.sheetmorph.tools.rims import Ray
from freecad.sheetmorph.tools.sentences import KEPT, Said, added, changed, removed

REPLACE, ADD, REMOVE = "replace", "add", "remove"
VERTEX, FACET, FACE, RIM, WHOLE = "vertex", "facet", "face", "rim", "whole"


@dataclass(frozen=True)
class Options:
    """The options of one click or figure."""

    what: str = FACE  # one of the names above, or of figures.DRAWN
    mode: str = REPLACE  # without a modifier key
    crease: float = math.radians(30.0)  # radians
    rings: int = 0  # around a hole rim
    holes_only: bool = False  # a click near the outline picks no rim
    through: bool = False  # hidden vertices count too
    radius: float = 25.0  # of the brush, px


def mode_of(shift: bool, control: bool, mode: str = REPLACE) -> str:
    """Return the mode for modifier keys: Shift adds, Ctrl removes, neither keeps `mode`."""
    if control:
        return REMOVE
    return ADD if shift else mode


class Taken:
    """Vertices that belong to other regions, which a pick leaves out."""

    def __init__(self, regions: dict[str, np.ndarray] | None = None):
        """Create the set; `regions` maps labels of regions to their vertices."""
        self._regions = {label: to_ids(ids) for label, ids in (regions or {}).items()}
        self.vertices = to_ids(np.concatenate([NOTHING, *self._regions.values()]))

    def owners(self, vertices: np.ndarray) -> list[str]:
        """Return the labels of the regions that contain some of the vertices."""
        return [name for name, ids in self._regions.items() if np.isin(vertices, ids).any()]


class RegionPicker:
    """The state of picking on one part, with meshes like `part_mesh.PartMesh`."""

    def __init__(self, mesh, picked: Iterable[int] = (), options: Options = Options(), others=()):
        """Start with picked vertices; `others` are the meshes that may hide this one."""
        self._mesh = mesh
        self._taken = Taken()
        self._left_out = NOTHING
        self._others = list(others)
        self._picked = to_ids(picked)
        self._said: Said = None if len(self._picked) else []
        self._history: list[tuple[np.ndarray, Said]] = []
        self._options = options
        self._painted = NOTHING

    @property
    def picked(self) -> np.ndarray:
        """The picked vertices, ascending."""
        return self._picked

    @property
    def said(self) -> Said:
        """The picks as a selector in global coordinates at rest, None if unknown."""
        return self._said

    def begin_with(self, where: Said) -> None:
        """Set the selector of the initial vertices, in the coordinates of the file."""
        self._said = {KEPT: where}

    def leave(self, taken: Taken) -> None:
        """Leave the vertices of other regions out of every later pick."""
        self._taken = taken

    @property
    def refused(self) -> list[str]:
        """The labels of the regions whose vertices the last pick left out."""
        return self._taken.owners(self._left_out)

    @property
    def options(self) -> Options:
        """The options of a click."""
        return self._options

    @property
    def can_go_back(self) -> bool:
        """Whether a pick can be undone."""
        return bool(self._history)

    def choose(self, **options) -> None:
        """Change options by their names in Options."""
        self._options = replace(self._options, **options)

    def mode(self, shift: bool, control: bool) -> str:
        """Return the mode of a pick with these keys; strokes of a brush always add."""
        found = mode_of(shift, control, self._options.mode)
        return ADD if found == REPLACE and self._options.what == BRUSH else found

    def aim(self, ray: Ray) -> np.ndarray:
        """Return the vertices that a click would pick, none if another part hides them."""
        options, mesh = self._options, self._mesh
        found = mesh.hit(ray)
        if found is not None and self._is_hidden(ray, found[1]):
            return NOTHING
        if options.what == RIM:
            return mesh.rim(
                ray, options.rings, crease=options.crease, holes_only=options.holes_only
            )
        if found is None:
            return NOTHING
        if options.what == VERTEX:
            return mesh.vertex(*found)
        if options.what == FACET:
            return mesh.facet(found[0])
        if options.what == FACE:
            return mesh.face(found[0], options.crease)
        return mesh.piece(found[0])

    def aim_inside(self, camera: Camera, outline: np.ndarray) -> np.ndarray:
        """Return the vertices that a closed figure (k, 2) px would pick."""
        hiding = None if self._options.through else [self._mesh, *self._others]
        return self._mesh.inside(camera, outline, hiding)

    def paint(self, camera: Camera, outline: np.ndarray) -> np.ndarray:
        """Add a figure to the present stroke; return all vertices of the stroke so far."""
        self._painted = np.union1d(self._painted, self.aim_inside(camera, outline))
        return self._painted

    def take_painted(self, mode: str, said: Said = None) -> bool:
        """Pick the vertices of the stroke and end it; return whether that changed anything."""
        painted = self._painted
        self.forget_painted()
        return bool(len(painted)) and self.take(painted, mode, said)

    def told(self, ray: Ray) -> Said:
        """Return a click as a selector: the face, rim or piece at its place."""
        options, mesh = self._options, self._mesh
        found = mesh.hit(ray)
        crease = number(round(math.degrees(options.crease), 9))
        if options.what == RIM:
            place = mesh.place_on_rim(ray, options.crease, options.holes_only)
            rings = {"rings": options.rings} if options.rings else {}
            said = {"rim_at": place, "alone": True, "crease_angle": crease, **rings}
            return None if place is None else said
        if found is None or options.what not in (FACE, WHOLE):
            return {"vertices": [int(vertex) for vertex in self.aim(ray)]}
        place = mesh.place_at_rest(*found)
        if options.what == FACE:
            return {"face_at": place, "crease_angle": crease}
        return {"piece_at": place}

    def forget_painted(self) -> None:
        """Start a new stroke."""
        self._painted = NOTHING

    def click(self, ray: Ray, mode: str = REPLACE) -> bool:
        """Pick what the ray aims at; return False if it meets nothing or nothing changes."""
        target = self.aim(ray)
        return bool(len(target)) and self.take(target, mode, self.told(ray))

    def take(self, vertices: Iterable[int], mode: str = REPLACE, said: Said = None) -> bool:
        """Replace, add or remove vertices; return whether that changed anything.

        `said` is the selector of the vertices, if it exists.
        """
        target = to_ids(vertices)
        if mode == ADD:
            return self._become(np.union1d(self._picked, target), added(self._said, said))
        if mode == REMOVE:
            return self._become(np.setdiff1d(self._picked, target), removed(self._said, said))
        return self._become(target, None if said is None else [said])

    def take_holes(self) -> bool:
        """Pick the rims of all holes."""
        rims = self._mesh.hole_rims(self._options.rings)
        said = [
            {"rim_at": place, "alone": True, **({"rings": rings} if rings else {})}
            for place in self._mesh.places_of_holes()
            for rings in [self._options.rings]
        ]
        return self._become(to_ids(np.concatenate([NOTHING, *rims])), said)

    def grow(self) -> bool:
        """Add one ring of neighbours."""
        return self._become(self._mesh.grown(self._picked), changed("grow", self._said))

    def shrink(self) -> bool:
        """Remove the outermost ring."""
        return self._become(self._mesh.shrunk(self._picked), changed("shrink", self._said))

    def invert(self) -> bool:
        """Pick the vertices that are not picked."""
        others = np.setdiff1d(self._mesh.used, self._picked)
        return self._become(others, removed([{"all": True}], self._said or None))

    def clear(self) -> bool:
        """Pick nothing."""
        return self._become(NOTHING, [])

    def back(self) -> bool:
        """Undo the last change."""
        if not self._history:
            return False
        self._left_out = NOTHING
        self._picked, self._said = self._history.pop()
        return True

    def groups(self) -> Sequence[np.ndarray]:
        """Return the connected pieces of the picked vertices."""
        return self._mesh.groups(self._picked)

    def _is_hidden(self, ray: Ray, point: np.ndarray) -> bool:
        if self._options.through:
            return False
        distance = np.linalg.norm(point - ray.origin) * (1.0 - 1e-6)
        return any(other.distance(ray) < distance for other in self._others)

    def _become(self, picked: np.ndarray, said: Said) -> bool:
        self._left_out = np.intersect1d(picked, self._taken.vertices)
        if len(self._left_out):
            said = removed(said, {"vertices": self._left_out.tolist()})
        picked = np.setdiff1d(picked, self._taken.vertices)
        if np.array_equal(picked, self._picked):
            return False
        self._history.append((self._picked, self._said))
        self._picked, self._said = picked.astype(np.int32), said
        return True
