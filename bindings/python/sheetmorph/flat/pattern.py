# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a bent sheet to its blank, with the residual stretch."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import FailedError, FileError
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..base.words import at_place, counted
from ..files import read_part
from ..files.packed import unpacked_name
from ..measuring.strain import arcs, areas, principal_stretches
from .bends import Bend, KTable, find_bends

if TYPE_CHECKING:
    from .. import _core

_ROUND = 2e-3  # share of the radius: rims closer to a circle are cut as a circle
_FEWEST_OF_CIRCLE = 12
_STRAIGHT = 1e-3  # radians: a loop that turns by less is straight
_WIDEST_ARC = 0.35  # radians in one triangle; beyond it the triangle belongs to a fold
_LOST = 0.05  # share of a solid's volume that its sheet may miss


class NotFlat(FailedError):
    """A sheet that cannot be flattened, or only with more stretch than allowed."""


@dataclass(frozen=True, eq=False)
class FlatPattern:
    """The blank of one sheet; lengths in mm.

    Attributes
    ----------
    rest, flat : array (n, 3)
        Vertices of the bent sheet, and of the flat one with z = 0.
    triangles : array (m, 3)
        Vertex indices.
    outline : array (k,)
        Vertices of the outline.
    holes : list of array (k,)
        Vertices of every rim.
    circles : list
        Centre (3,) and radius of each hole, None if it is not round.
    rigid : list of bool
        Whether each hole kept its exact form.
    lines : list of array (2, 3)
        Ends of the centre line of each bend in the blank.
    stretches : array (m, 2)
        Principal stretches of the blank relative to the sheet.
    notes : list of str
        Remarks for the user.
    """

    name: str
    rest: Floats
    flat: Floats
    triangles: Ints
    outline: Ints
    holes: list[Ints]
    circles: list[tuple[Floats, float] | None]
    rigid: list[bool]
    bends: list[Bend]
    lines: list[Floats]
    stretches: Floats
    thickness: float | None = None
    notes: list[str] = field(default_factory=list)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the blank, mm."""
        low, high = self.flat.min(axis=0), self.flat.max(axis=0)
        return float(high[0] - low[0]), float(high[1] - low[1])

    def corners(self, loop: Ints) -> Floats:
        """Return the vertices (k,) at which a loop changes its direction."""
        places = self.flat[loop, :2]
        before, after = places - np.roll(places, 1, 0), np.roll(places, -1, 0) - places
        sine = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
        lengths = np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
        is_corner = np.abs(sine) > _STRAIGHT * np.maximum(lengths, 1e-300)
        found: Floats = loop[is_corner] if is_corner.sum() >= 3 else loop
        return found

    def residual(self) -> tuple[float, float]:
        """Return the largest |principal stretch - 1|, and its 99 % quantile by area."""
        strain = np.abs(self.stretches - 1.0).max(axis=1)
        area = areas(self.rest, self.triangles)
        order = np.argsort(strain)
        reached = np.cumsum(area[order]) / area.sum()
        place = min(int(np.searchsorted(reached, 0.99)), len(order) - 1)
        return float(strain.max()), float(strain[order[place]])


def flat_patterns(
    path: str | Path,
    *,
    thickness: float | None = None,
    table: KTable | None = None,
    limit: float = 0.01,
    weld: float | None = None,
    progress: Progress | None = None,
) -> list[FlatPattern]:
    """Return the blanks of all pieces of a file with open sheets or thin solids.

    thickness, mm, is that of an open sheet at its mid-surface; thin solids have their own. limit is
    the largest stretch of 99 % of the area. Vertices closer than weld, mm, are merged. Raises
    FileError, KernelError, NotFlat, ValueError.
    """
    file = read_part(path, None, progress)
    points, triangles = _welded(file.mesh, weld)
    if not len(triangles):
        raise FileError(Path(path), "it has no triangles", "give a file with a sheet")
    mesh = PartMesh(points, triangles, name=unpacked_name(path).stem)
    return patterns_of(mesh, thickness=thickness, table=table, limit=limit, progress=progress)


def patterns_of(
    mesh: PartMesh,
    *,
    thickness: float | None = None,
    table: KTable | None = None,
    limit: float = 0.01,
    progress: Progress | None = None,
) -> list[FlatPattern]:
    """Return the blanks of all pieces of a mesh; see flat_patterns()."""
    name, pieces = mesh.name, list(_pieces(mesh.points, mesh.triangles))
    wishes = _Wishes(thickness, table or KTable(), limit, progress)
    return [
        _flat(name if len(pieces) == 1 else f"{name}-{number}", piece, wishes)
        for number, piece in enumerate(pieces, 1)
    ]


@dataclass(frozen=True)
class _Wishes:
    """The options of flat_patterns()."""

    thickness: float | None
    table: KTable
    limit: float
    progress: Progress | None


def _welded(mesh: PartMesh, tolerance: float | None) -> tuple[Floats, Ints]:
    """Return points and triangles after an optional merge, without degenerate triangles."""
    points, triangles = mesh.points, mesh.triangles
    if tolerance is not None:
        core = load_kernel()
        cure = core.cured(core.TriangleMesh(points, triangles), tolerance)
        points, triangles = np.array(cure.points), np.array(cure.triangles)
    sound = np.array([len(set(row)) == 3 for row in triangles.tolist()], bool)
    return points, triangles[sound]


def _pieces(points: Floats, triangles: Ints) -> Iterator[tuple[Floats, Ints]]:
    """Yield points and triangles of every connected piece, in the order of their first vertex."""
    root = np.arange(len(points))
    while True:
        least = root[triangles].min(axis=1)
        before = root.copy()
        for corner in range(3):
            np.minimum.at(root, triangles[:, corner], least)
        root = root[root]
        if (root == before).all():
            break
    for label in np.unique(root[triangles[:, 0]]) if len(triangles) else ():
        own = triangles[root[triangles[:, 0]] == label]
        used, new = np.unique(own, return_inverse=True)
        yield points[used], new.reshape(own.shape).astype(np.int32)


def _sheet(
    core: ModuleType, name: str, piece: tuple[Floats, Ints]
) -> tuple[_core.TriangleMesh, float | None]:
    """Return the kernel mesh of a sheet, or of a thin solid with its thickness."""
    part = core.Part(name, core.TriangleMesh(*piece))
    part.make_thin(False)
    session = core.DeformationSession(core.Assembly([part]))
    solid, sheet = session.thin_solid(0), session.sheet(0)
    if solid is None:
        return sheet, None
    _require_whole(name, piece, sheet, float(solid.thickness))
    return sheet, float(solid.thickness)


def _require_whole(
    name: str, piece: tuple[Floats, Ints], sheet: _core.TriangleMesh, thickness: float
) -> None:
    """Raise NotFlat if mid-surface area times thickness differs from the volume of a solid."""
    corners = (piece[0] - piece[0][0])[piece[1]]
    volume = abs(float(np.linalg.det(corners).sum())) / 6.0
    area = float(areas(np.array(sheet.points), np.array(sheet.triangles)).sum())
    share = area * thickness / volume if volume > 0.0 else 0.0
    if abs(share - 1.0) > _LOST:
        raise NotFlat(
            f'"{name}" cannot be flattened: the sheet of {thickness:.4g} mm found '
            f"in it has {area:,.0f} mm2, which is {100.0 * share:.0f} % of its "
            f"volume of {volume:,.0f} mm3",
            "remove everything that is not sheet from the solid, or repair steps in its skins",
        )


def _flat(name: str, piece: tuple[Floats, Ints], wishes: _Wishes) -> FlatPattern:
    core = load_kernel()
    mesh, own_thickness = _sheet(core, name, piece)
    thickness = own_thickness or wishes.thickness
    rest, triangles = np.array(mesh.points), np.array(mesh.triangles)
    loops = sorted((np.array(loop) for loop in core.boundary_loops(mesh)), key=_length_in(rest))
    holes = _apart(loops[:-1])
    bends = find_bends(core, mesh, thickness, wishes.table)
    neutral = _neutral(rest, triangles, bends)
    try:
        told = neutral[0], neutral[1].tolist()
        found = core.flatten(mesh, [rim.tolist() for rim in holes], told, wishes.progress)
    except core.InvalidInput as error:
        raise NotFlat(error.what, error.todo, f'"{name}"') from error
    flat = _laid_along_x(np.array(found.positions), loops[-1])
    if found.turned:
        triangles[found.turned] = triangles[found.turned][:, ::-1]
    pattern = FlatPattern(
        name=name, rest=rest, flat=flat, triangles=triangles, outline=loops[-1],
        holes=holes, circles=[_circle(flat[rim]) for rim in holes], rigid=list(found.is_rigid),
        bends=bends, lines=[_line(rest, flat, triangles, bend) for bend in bends],
        stretches=np.nan_to_num(principal_stretches(rest, flat, triangles, neutral), nan=1.0),
        thickness=thickness,
        notes=_notes(found, bends, thickness),
    )  # fmt: skip
    _require_flat(pattern, found, wishes.limit)
    return pattern


def _require_flat(pattern: FlatPattern, found: _core.Flattening, limit: float) -> None:
    largest, most = pattern.residual()
    if len(found.flipped):
        number = len(found.flipped)
        corners = pattern.triangles[found.flipped[0]]
        place = at_place(pattern.rest[corners].mean(axis=0))
        what = f"{counted(number, 'triangle flips', 'triangles flip')} near {place}"
        todo = "cut it there, or leave out what is not developable"
        raise NotFlat(f'"{pattern.name}" cannot be flattened: {what}', todo)
    if most > limit:
        raise NotFlat(
            f'"{pattern.name}" cannot be flattened within {100 * limit:.2g} %: it '
            "is curved in two directions, and 1 % of it stretches by more than "
            f"{100 * most:.2g} % (largest {100 * largest:.2g} %)",
            "allow more with --limit, or cut it",
        )


def _notes(found: _core.Flattening, bends: list[Bend], thickness: float | None) -> list[str]:
    notes = ["kinematic result: springback and friction are not included"]
    curved = len(found.is_rigid) - sum(found.is_rigid)
    if curved:
        notes.append(
            f"{curved} rims are not plane and follow the sheet; the others keep their shape"
        )
    if bends and thickness is None:
        notes.append(
            "the thickness is unknown: lengths are those of the given sheet, without a K-factor"
        )
    if any(not bend.radius for bend in bends) and thickness:
        notes.append("sharp folds have no radius and get no bend allowance")
    if found.unsettled:
        notes.append(found.unsettled)
    return notes


def _length_in(points: Floats) -> Callable[[Ints], float]:
    """Return a function for the length of a closed loop of vertices, mm."""
    return lambda loop: float(
        np.linalg.norm(points[loop] - np.roll(points[loop], 1, 0), axis=1).sum()
    )


def _apart(loops: list[Ints]) -> list[Ints]:
    """Return the loops that share no vertex with an earlier one."""
    seen: set[int] = set()
    found = []
    for loop in loops:
        if seen.isdisjoint(loop.tolist()):
            found.append(loop)
        seen.update(loop.tolist())
    return found


def _neutral(rest: Floats, triangles: Ints, bends: list[Bend]) -> tuple[Floats, Floats]:
    """Return directions (m, 3) and factors (m,) of the neutral fibre relative to the flat
    triangles.

    A flat triangle is a chord of the bent sheet, so the neutral fibre is longer.
    """
    directions, turns = arcs(rest, triangles)
    turns[turns > _WIDEST_ARC] = 0.0
    factors = 1.0 + turns**2 / 24.0
    directions[turns == 0.0] = 0.0
    for bend in bends:
        if bend.factor == 1.0 or not len(bend.triangles):
            continue
        corners = rest[triangles[bend.triangles]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        across = np.cross(bend.direction, normals)
        directions[bend.triangles] = across / np.linalg.norm(across, axis=1)[:, None]
        factors[bend.triangles] *= bend.factor
    return directions, factors


def _laid_along_x(flat: Floats, outline: Ints) -> Floats:
    """Rotate the blank to the smallest box along one of its edges, with its corner at 0."""
    rim = flat[outline, :2]
    sides = np.roll(rim, -1, 0) - rim
    angles = np.arctan2(sides[:, 1], sides[:, 0]) % (0.5 * np.pi)
    angles = angles[np.unique(np.round(angles, 6), return_index=True)[1]]
    turns = [np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) for a in angles[:720]]
    best = min(turns, key=lambda turn: round(float(np.prod(np.ptp(rim @ turn, axis=0))), 9))
    if np.ptp(rim @ best, axis=0)[0] < np.ptp(rim @ best, axis=0)[1] * (1.0 - 1e-9):
        best = best @ np.array([[0.0, -1.0], [1.0, 0.0]])
    turned = flat[:, :2] @ best
    turned -= turned[outline].min(axis=0)
    return np.column_stack([turned, np.zeros(len(flat))])


def _circle(rim: Floats) -> tuple[Floats, float] | None:
    """Return centre and radius of a rim whose vertices lie on a circle, or None."""
    if len(rim) < _FEWEST_OF_CIRCLE:
        return None
    system = np.column_stack([2.0 * rim[:, :2], np.ones(len(rim))])
    x, y, rest = np.linalg.lstsq(system, (rim[:, :2] ** 2).sum(axis=1), rcond=None)[0]
    radius = float(np.sqrt(max(rest + x * x + y * y, 0.0)))
    centre = np.array([x, y, 0.0])
    off = np.abs(np.linalg.norm(rim - centre, axis=1) - radius).max()
    return (centre, radius) if off <= _ROUND * radius else None


def _line(rest: Floats, flat: Floats, triangles: Ints, bend: Bend) -> Floats:
    """Return the ends (2, 3) of the centre line of a bend in the blank."""
    places = flat[bend.vertices, :2]
    if len(bend.triangles):
        along = _carried(rest, flat, triangles[bend.triangles], bend.direction)
    else:
        along = np.linalg.svd(places - places.mean(axis=0))[2][0]
    across = np.array([-along[1], along[0]])
    far, near = places @ along, places @ across
    middle = 0.5 * (near.min() + near.max())
    ends = np.array([far.min(), far.max()])[:, None] * along + middle * across
    return np.column_stack([ends, np.zeros(2)])


def _carried(rest: Floats, flat: Floats, triangles: Ints, direction: Floats) -> Floats:
    """Map a direction (3,) on some triangles to the blank, (2,) with length 1."""
    sides = rest[triangles[:, 1:]] - rest[triangles[:, :1]]
    moved = flat[triangles[:, 1:], :2] - flat[triangles[:, :1], :2]
    gram = np.einsum("mik,mjk->mij", sides, sides)
    weights = np.linalg.solve(gram, (sides @ direction)[:, :, None])[:, :, 0]
    along = np.einsum("mi,mik->mk", weights, moved).mean(axis=0)
    found: Floats = along / np.linalg.norm(along)
    return found
