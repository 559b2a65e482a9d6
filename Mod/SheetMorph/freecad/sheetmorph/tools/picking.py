# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picking a region: what a click means, what is picked, and how to take it back."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

REPLACE, ADD, REMOVE = "replace", "add", "remove"
FACET, FACE, RIM, WHOLE = "facet", "face", "rim", "whole"


@dataclass(frozen=True)
class Options:
    """What one click takes."""

    what: str = FACE
    crease: float = math.radians(30.0)  # radians
    rings: int = 0  # around a hole rim
    holes_only: bool = False  # a click near the outline takes no rim


def mode_of(shift: bool, control: bool) -> str:
    """Shift adds, Ctrl removes, a plain click starts anew."""
    if control:
        return REMOVE
    return ADD if shift else REPLACE


class RegionPicker:
    """The state of picking on one part; ``mesh`` answers as ``part_mesh.PartMesh`` does."""

    def __init__(self, mesh, picked=(), options: Options = Options()):
        self._mesh = mesh
        self._picked = frozenset(int(v) for v in picked)
        self._history: list[frozenset] = []
        self._options = options

    @property
    def picked(self) -> frozenset:
        """The vertices picked now."""
        return self._picked

    @property
    def can_go_back(self) -> bool:
        """Whether there is a pick to take back."""
        return bool(self._history)

    def choose(self, **options) -> None:
        """Changes options, by the names in Options."""
        self._options = replace(self._options, **options)

    def aim(self, ray) -> frozenset:
        """What a click along the ray would take; empty if nothing."""
        options = self._options
        if options.what == RIM:
            return self._mesh.rim(ray, options.rings, options.holes_only)
        found = self._mesh.hit(ray)
        if found is None:
            return frozenset()
        triangle = found[0]
        if options.what == FACET:
            return self._mesh.facet(triangle)
        if options.what == FACE:
            return self._mesh.face(triangle, options.crease)
        return self._mesh.piece(triangle)

    def click(self, ray, mode: str = REPLACE) -> bool:
        """Takes what the ray aims at; a click into the void changes nothing and returns False."""
        target = self.aim(ray)
        return bool(target) and self.take(target, mode)

    def take(self, vertices, mode: str = REPLACE) -> bool:
        """Replaces, adds or removes vertices; whether that changed anything."""
        target = frozenset(vertices)
        if mode == ADD:
            return self._become(self._picked | target)
        if mode == REMOVE:
            return self._become(self._picked - target)
        return self._become(target)

    def take_holes(self) -> bool:
        """Picks the rims of all holes."""
        rims = self._mesh.hole_rims(self._options.rings)
        return self._become(frozenset().union(*rims))

    def grow(self) -> bool:
        """Adds one ring of neighbours."""
        return self._become(self._mesh.grown(self._picked))

    def shrink(self) -> bool:
        """Takes the outermost ring away."""
        return self._become(self._mesh.shrunk(self._picked))

    def clear(self) -> bool:
        """Picks nothing."""
        return self._become(frozenset())

    def back(self) -> bool:
        """Takes back the last change."""
        if not self._history:
            return False
        self._picked = self._history.pop()
        return True

    def groups(self) -> list[list[int]]:
        """The connected pieces of what is picked."""
        return self._mesh.groups(self._picked)

    def _become(self, picked: frozenset) -> bool:
        if picked == self._picked:
            return False
        self._history.append(self._picked)
        self._picked = picked
        return True
