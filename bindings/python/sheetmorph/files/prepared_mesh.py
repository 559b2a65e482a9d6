# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh after scaling, merging and remeshing that still accepts the vertex ids of its file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ids, Ints
from ..base.labels import Labels
from ..base.part_mesh import PartMesh
from ..base.progress import Progress

if TYPE_CHECKING:
    from .. import _core

# Smaller barycentric coordinates count as zero: the vertex lies on an edge or at a corner.
_ON_EDGE = 1e-9
# The same limit for positions that rounding has moved.
_BESIDE = 1e-4


@dataclass(frozen=True)
class Wanted:
    """The requested preparation of a mesh.

    weld is the merge tolerance in mm, None for no merging. edge is the target edge length in mm,
    None for no remeshing. rims is one of RIMS. scale converts the coordinates to mm, such as 1000
    for metres, and is applied first.
    """

    weld: float | None = None
    edge: float | None = None
    rims: str = "polygon"
    scale: float = 1.0

    def __bool__(self) -> bool:
        return self.weld is not None or self.edge is not None or self.scale != 1.0


RIMS = ("polygon", "circle")


@dataclass(frozen=True, eq=False, repr=False)
class PreparedMesh(PartMesh):
    """The mesh that is deformed; its ids are those of ``source``, the mesh of the file.

    Attributes
    ----------
    source : PartMesh
        The mesh of the file, mm.
    support : array (n, j), int
        Source vertices around each vertex, the nearest first; it is repeated on edges and at
        corners.
    vertex_of : array (k,), int
        For every source vertex the vertex at or nearest to its position, -1 without one.
    done : dict or None
        The preparation, for the report.
    """

    source: PartMesh = field(kw_only=True)  # mm
    support: Ints = field(kw_only=True)
    vertex_of: Ints = field(kw_only=True)
    done: dict[str, Any] | None = field(kw_only=True)

    @property
    def preparation(self) -> dict[str, Any] | None:
        return self.done

    @property
    def file_triangle_count(self) -> int:
        return len(self.source.triangles)

    def find(self, ids: Ids, prepared: bool = False) -> tuple[Ints, list[int]]:
        """Return vertices (j,) int32 between or nearest to the file ids, and the missing ids."""
        if prepared:
            return super().find(ids, prepared)
        old, missing = self.source.find(ids)
        chosen = np.zeros(len(self.source.points), dtype=bool)
        chosen[old] = True
        nearest = self.vertex_of[old]
        missing += self.source.file_ids(old[nearest < 0])
        between = np.flatnonzero(chosen[self.support].all(axis=1))
        return np.union1d(between, nearest[nearest >= 0]).astype(np.int32), missing

    def file_ids(self, indices: Ids) -> list[int]:
        """Return for each vertex the file id of the nearest source vertex."""
        return self.source.file_ids(self.support[np.asarray(indices, dtype=np.int64), 0])

    def describe_ids(self, prepared: bool = False) -> str:
        return super().describe_ids(prepared) if prepared else self.source.describe_ids()

    def place_on(
        self, core: ModuleType, triangle: int, barycentric: Sequence[float]
    ) -> tuple[int, Sequence[float]]:
        """Return the point on this mesh that is nearest to a point on a triangle of the file."""
        place = np.asarray(barycentric) @ self.source.points[self.source.triangles[triangle]]
        hit = core.PickingTree(self.points, self.triangles).nearest_point(place)
        return hit.triangle, tuple(hit.barycentric)

    def restricted(self, vertices: Ints, corners: Ints, name: str) -> PartMesh:
        """Return a part of the mesh with vertices (k,) and triangles (m, 3) over them."""
        number = np.full(len(self.points) + 1, -1)
        number[vertices] = np.arange(len(vertices))
        return PreparedMesh(
            self.points[vertices],
            corners,
            name=name,
            source=self.source,
            support=self.support[vertices],
            vertex_of=number[self.vertex_of],
            done=self.done,
        )


def prepared_mesh(
    core: ModuleType, mesh: PartMesh, wanted: Wanted, progress: Progress | None = None
) -> tuple[PartMesh, Ints]:
    """Scale, merge and remesh a mesh; return it with the file triangle of each triangle (m,).

    Scaling alone changes no triangle. progress(fraction, task) returns whether to continue. Raises
    InvalidInput of the kernel (a ValueError) and its Cancelled.
    """
    if wanted.scale != 1.0:
        mesh = replace(mesh, points=wanted.scale * mesh.points)
    if wanted.weld is None and wanted.edge is None:
        return _only_scaled(mesh, wanted.scale), np.arange(len(mesh.triangles))
    tolerance = 0.0 if wanted.weld is None else wanted.weld
    cure = core.cured(core.TriangleMesh(mesh.points, mesh.triangles), tolerance)
    done: dict[str, Any] = {
        "scale": wanted.scale,
        "weld": wanted.weld,
        **{key: getattr(cure, key) for key in ("welded", "removed", "split", "turned")},
        "remesh": None,
        "unsettled": cure.unsettled or None,
    }
    points, triangles, first = cure.points, cure.triangles, _first_of(cure)
    support, vertex_of = first[:, None], cure.vertex_of
    triangle_of = cure.triangle_of
    if wanted.edge is not None:
        cut = core.TriangleMesh(points, triangles)
        fresh = core.remeshed(cut, wanted.edge, _is_round(wanted), progress)
        support = first[_corners_below(fresh, triangles)]
        vertex_of = np.append(fresh.vertex_of, -1)[vertex_of]
        triangle_of = triangle_of[fresh.triangle[fresh.triangles].min(axis=1)]
        done["remesh"] = _told(fresh, wanted)
        done["unsettled"] = done["unsettled"] or fresh.unsettled or None
        points, triangles = fresh.points, fresh.triangles
    made = PreparedMesh(
        points, triangles, name=mesh.name, source=mesh, support=support, vertex_of=vertex_of,
        done=done, labels=_labels(core, mesh, points, triangles, triangle_of),
    )  # fmt: skip
    return made, triangle_of


def _labels(
    core: ModuleType, mesh: PartMesh, points: Floats, triangles: Ints, triangle_of: Ints
) -> Labels | None:
    """Transfer the labels of a mesh to new triangles, by the facet under the centre of each.

    triangle_of gives the candidate facet of each triangle, which is final without a remesh.
    """
    if mesh.labels is None:
        return None
    middles = points[triangles].mean(axis=1)
    below = mesh.points[mesh.triangles[triangle_of]].mean(axis=1)
    off = np.flatnonzero((middles != below).any(axis=1)).tolist()
    rows = triangle_of.copy()
    if off:
        tree = core.PickingTree(mesh.points, mesh.triangles)
        rows[off] = [tree.nearest_point(middles[k]).triangle for k in off]
    return mesh.labels.carried(rows)


def _only_scaled(mesh: PartMesh, scale: float) -> PreparedMesh:
    """Return the scaled mesh with all vertices and triangles of the file."""
    ids = np.arange(len(mesh.points))
    counts = dict.fromkeys(("welded", "removed", "split", "turned"), 0)
    done = {"scale": scale, "weld": None, **counts, "remesh": None, "unsettled": None}
    return PreparedMesh(
        mesh.points, mesh.triangles, name=mesh.name, source=mesh, support=ids[:, None],
        vertex_of=ids, done=done, labels=mesh.labels,
    )  # fmt: skip


def placed_on(core: ModuleType, made: PartMesh, before: PartMesh) -> PreparedMesh:
    """Return a mesh that accepts the ids of another mesh of the same surface, by position."""
    old = core.PickingTree(before.points, before.triangles)
    new = core.PickingTree(made.points, made.triangles)
    below = [old.nearest_point(point) for point in made.points]
    corners = before.triangles[[hit.triangle for hit in below]]
    weights = np.array([hit.barycentric for hit in below])
    above = [new.nearest_point(point) for point in before.points]
    near = made.triangles[[hit.triangle for hit in above]]
    nearest = np.array([hit.barycentric for hit in above]).argmax(axis=1)
    return PreparedMesh(
        made.points, made.triangles, name=before.name, source=before,
        support=_with_weight(corners, weights, _BESIDE),
        vertex_of=near[np.arange(len(near)), nearest], done=made.preparation,
    )  # fmt: skip


def _is_round(wanted: Wanted) -> bool:
    return wanted.rims == "circle"


def _first_of(cure: _core.CuredMesh) -> Ints:
    """Return for every merged vertex (k,) the first vertex of the file at its position."""
    first = np.full(len(cure.points), -1)
    old = np.flatnonzero(cure.vertex_of >= 0)[::-1]
    first[cure.vertex_of[old]] = old
    return first


def _corners_below(fresh: _core.RemeshedMesh, triangles: Ints) -> Ints:
    """Return (n, 4): the nearest corner of the facet under each vertex, then its support."""
    return _with_weight(triangles[fresh.triangle], fresh.barycentric, _ON_EDGE)


def _with_weight(corners: Ints, weights: Floats, least: float) -> Ints:
    """Return (n, 4): the nearest corner, then the corners (n, 3) with more than a least weight."""
    most = corners[np.arange(len(corners)), weights.argmax(axis=1)]
    return np.column_stack([most, np.where(weights > least, corners, most[:, None])])


def _told(fresh: _core.RemeshedMesh, wanted: Wanted) -> dict[str, Any]:
    return {
        "edge": wanted.edge,
        "rims": wanted.rims,
        "rims_on_circles": fresh.circles,
        "flats": fresh.flats,
        "deviation": fresh.deviation,
        "flat_deviation": fresh.flat_deviation,
        "least_edge": fresh.least_edge or None,
        "kept_vertices": int(fresh.is_kept.sum()),
    }
