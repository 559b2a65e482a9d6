# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part as selectors see it: in the frame of its file, what is computed from it kept."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays import Floats, Ints
from ..finding.findings import FindPart
from ..finding.search import find
from ..kernel import load_kernel
from ..labels import Labels
from ..part_mesh import PartMesh
from ..recipe.placement import Placement
from .cad_edges import CadEdge, cad_edges
from .chosen import Chosen

if TYPE_CHECKING:
    from .. import _core

# Of its size: how far rounding may put a vertex beside the plane it lies on.
_ROUNDING = 1e-9
# Bends by more are rims, degrees; the crease angle of FindOptions.
CREASE = 35.0


class PartShape:
    """The prepared mesh of a part; mm in the frame of its file after `scale`.

    points (n, 3); triangles (m, 3); used: (n,) whether a triangle has the vertex.
    """

    def __init__(self, mesh: PartMesh, placement: Placement = Placement(), name: str = ""):
        self.mesh = mesh
        self.drawn: Callable[[Any], Ints] | None = None  # what a figure in a view takes
        self.name = name or mesh.name
        self._loops: dict[float, list[Ints]] = {}  # of the last angle
        self.points = np.ascontiguousarray(placement.taken_back(mesh.points))
        self.triangles = mesh.triangles
        self.used = np.zeros(len(self.points), dtype=bool)
        self.used[self.triangles] = True

    @property
    def labels(self) -> Labels:
        """What its file calls parts of it."""
        return self.mesh.labels or Labels()

    @cached_property
    def core(self) -> ModuleType:
        """The kernel."""
        return load_kernel()

    @cached_property
    def kernel_mesh(self) -> _core.TriangleMesh:
        """The kernel's TriangleMesh."""
        found: _core.TriangleMesh = self.core.TriangleMesh(self.points, self.triangles)
        return found

    @cached_property
    def near(self) -> _core.Neighbourhood:
        """The kernel's Neighbourhood."""
        found: _core.Neighbourhood = self.core.Neighbourhood(self.kernel_mesh)
        return found

    @cached_property
    def tree(self) -> _core.PickingTree:
        """The kernel's PickingTree."""
        found: _core.PickingTree = self.core.PickingTree(self.points, self.triangles)
        return found

    @cached_property
    def box(self) -> tuple[Floats, Floats]:
        """The smallest and largest coordinates (3,) of its vertices."""
        points = self.points[self.used] if self.used.any() else np.zeros((1, 3))
        return points.min(axis=0), points.max(axis=0)

    @cached_property
    def size(self) -> float:
        """The diagonal of its box, mm."""
        return float(np.linalg.norm(self.box[1] - self.box[0]))

    @cached_property
    def slack(self) -> float:
        """How far beside a plane a vertex counts as on it, mm."""
        return _ROUNDING * (self.size + float(np.abs(self.box).max()))

    @cached_property
    def areas(self) -> Floats:
        """(m,) mm^2."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        found: Floats = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        return found

    @cached_property
    def border_loops(self) -> list[Ints]:
        """The closed loops where the sheet ends, vertices in order."""
        return [np.asarray(loop) for loop in self.core.boundary_loops(self.kernel_mesh)]

    @cached_property
    def cad_edges(self) -> list[CadEdge]:
        """Where two faces of the CAD file meet, or one ends."""
        face = self.labels.face
        return [] if face is None else cad_edges(self.triangles, face)

    def loops_at(self, crease: float) -> list[Ints]:
        """The closed loops where the sheet ends or bends by an angle, degrees, or more."""
        if crease not in self._loops:
            found = self.near.rims(math.radians(crease))
            self._loops = {crease: [np.asarray(loop) for loop in found]}
        return self._loops[crease]

    @cached_property
    def features(self) -> list[dict[str, Any]]:
        """What is found on it, as `find` tells it; vertices are indices."""
        plain = PartMesh(self.points, self.triangles, name=self.name)
        return find([FindPart(self.name, plain)], with_contacts=False).features

    def of_triangles(self, rows: Ints) -> Chosen:
        """Some triangles with their corners."""
        share = np.zeros(len(self.triangles))
        share[rows] = 1.0
        inside = np.zeros(len(self.points), dtype=bool)
        inside[self.triangles[rows]] = True
        return Chosen(inside, share)

    def of_vertices(self, vertices: Ints) -> Chosen:
        """Some vertices with the triangles between them."""
        inside = np.zeros(len(self.points), dtype=bool)
        inside[vertices] = True
        return Chosen(inside, inside[self.triangles].all(axis=1).astype(float))

    def area_of(self, chosen: Chosen) -> float:
        """mm^2."""
        return float(chosen.share @ self.areas)

    def describe_box(self) -> str:
        """Where the part lies, for messages."""
        low, high = (f"[{', '.join(f'{x:.6g}' for x in corner)}]" for corner in self.box)
        return f'"{self.name}" reaches from {low} to {high}'
