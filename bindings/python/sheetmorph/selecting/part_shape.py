# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part as selectors see it: in file coordinates, with cached geometry."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.file_unit import unit_of
from ..base.kernel import load_kernel
from ..base.labels import Labels
from ..base.part_mesh import PartMesh
from ..base.words import tidy
from ..finding.findings import FindPart
from ..finding.search import find
from ..recipe.placement import Placement
from .cad_edges import CadEdge, cad_edges
from .chosen import Chosen

if TYPE_CHECKING:
    from .. import _core

# Share of the part size: admissible rounding error of a vertex on a plane.
_ROUNDING = 1e-9
# Sharper bends are rims, degrees; the default crease angle of FindOptions.
CREASE = 35.0


class PartShape:
    """The prepared mesh of a part, mm in file coordinates after `scale`.

    points is (n, 3), triangles (m, 3), and used (n,) marks the vertices of triangles.
    """

    def __init__(self, mesh: PartMesh, placement: Placement = Placement(), name: str = ""):
        self.mesh = mesh
        # returns the vertices inside a figure in a view
        self.drawn: Callable[[Any], Ints] | None = None
        self.name = name or mesh.name
        self._loops: dict[float, list[Ints]] = {}  # for the last angle
        self.points = np.ascontiguousarray(placement.taken_back(mesh.points))
        self.triangles = mesh.triangles
        self.used = np.zeros(len(self.points), dtype=bool)
        self.used[self.triangles] = True

    @property
    def labels(self) -> Labels:
        """Names in the file for regions of the part."""
        return self.mesh.labels or Labels()

    @cached_property
    def core(self) -> ModuleType:
        """The kernel module."""
        return load_kernel()

    @cached_property
    def kernel_mesh(self) -> _core.TriangleMesh:
        """The part as a TriangleMesh of the kernel."""
        found: _core.TriangleMesh = self.core.TriangleMesh(self.points, self.triangles)
        return found

    @cached_property
    def near(self) -> _core.Neighbourhood:
        """The Neighbourhood of the kernel."""
        found: _core.Neighbourhood = self.core.Neighbourhood(self.kernel_mesh)
        return found

    @cached_property
    def tree(self) -> _core.PickingTree:
        """The PickingTree of the kernel."""
        found: _core.PickingTree = self.core.PickingTree(self.points, self.triangles)
        return found

    @cached_property
    def box(self) -> tuple[Floats, Floats]:
        """Smallest and largest coordinates (3,) of the used vertices."""
        points = self.points[self.used] if self.used.any() else np.zeros((1, 3))
        return points.min(axis=0), points.max(axis=0)

    @cached_property
    def size(self) -> float:
        """Diagonal of the box, mm."""
        return float(np.linalg.norm(self.box[1] - self.box[0]))

    @cached_property
    def slack(self) -> float:
        """Distance from a plane within which a vertex lies on it, mm."""
        return _ROUNDING * (self.size + float(np.abs(self.box).max()))

    @cached_property
    def areas(self) -> Floats:
        """Triangle areas (m,), mm^2."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        found: Floats = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        return found

    @cached_property
    def border_loops(self) -> list[Ints]:
        """Closed border loops of the sheet, as ordered vertices."""
        return [np.asarray(loop) for loop in self.core.boundary_loops(self.kernel_mesh)]

    @cached_property
    def cad_edges(self) -> list[CadEdge]:
        """Edges where two faces of the CAD file meet, or one ends."""
        face = self.labels.face
        return [] if face is None else cad_edges(self.triangles, face)

    def loops_at(self, crease: float) -> list[Ints]:
        """Return the closed loops of borders and of creases with at least this angle, degrees."""
        if crease not in self._loops:
            found = self.near.rims(math.radians(crease))
            self._loops = {crease: [np.asarray(loop) for loop in found]}
        return self._loops[crease]

    @cached_property
    def features(self) -> list[dict[str, Any]]:
        """Found features as in the output of `find`; vertices are indices."""
        plain = PartMesh(self.points, self.triangles, name=self.name)
        return find([FindPart(self.name, plain)], with_contacts=False).features

    def of_triangles(self, rows: Ints) -> Chosen:
        """Return triangles with their corners as a region."""
        share = np.zeros(len(self.triangles))
        share[rows] = 1.0
        inside = np.zeros(len(self.points), dtype=bool)
        inside[self.triangles[rows]] = True
        return Chosen(inside, share)

    def of_vertices(self, vertices: Ints) -> Chosen:
        """Return vertices with the triangles between them as a region."""
        inside = np.zeros(len(self.points), dtype=bool)
        inside[vertices] = True
        return Chosen(inside, inside[self.triangles].all(axis=1).astype(float))

    def area_of(self, chosen: Chosen) -> float:
        """Return the area of a region, mm^2."""
        return float(chosen.share @ self.areas)

    def describe_box(self) -> str:
        """Describe the box of the part for messages."""
        low, high = (f"[{', '.join(map(tidy, corner))}]" for corner in self.box)
        text = f'"{self.name}" reaches from {low} to {high} mm'
        unit = unit_of(self.size, None)
        if unit["scale"] != 1.0 and unit["is_certain"]:
            text += f'. The unit seems to be {unit["guess"]}: use "scale": {unit["scale"]:g}'
        return text
