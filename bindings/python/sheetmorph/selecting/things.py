# SPDX-License-Identifier: LGPL-2.1-or-later
"""The candidate items of nearest-item selectors: rims, faces, borders and pieces of a part."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from .looked_up import CREASE_ANGLE, RIMMED, rim_loops, rim_vertices, segments_distance
from .part_shape import PartShape

# Number of sample points of an item, and smallest cosine between equal directions.
_SAMPLES, _SAME_WAY = 48, 0.8
# Largest factor by which its length, or the square root of its area, may change.
_SAME_EXTENT = 4.0
# A face has a direction if its area vector is longer than this share of its area.
_FLAT = 0.9

Told = Mapping[str, Any]


@dataclass(frozen=True, eq=False)
class Thing:
    """An item that a selector can select on a part.

    vertices are those that the selector selects, and samples (k, 3) are points on the item. feature
    is its row among the features. way (3,) is the normal of a flat face. number is that of a CAD
    face.
    """

    kind: str
    shape: PartShape
    vertices: Ints
    samples: Floats
    triangles: Ints | None = None
    segments: Ints | None = None
    feature: int | None = None
    way: Floats | None = None
    number: int | None = None
    _tree: list[Any] = field(default_factory=list)

    @property
    def place(self) -> Floats:
        """Centre of the item; for a feature the fitted one."""
        if self.feature is not None:
            return np.array(self.shape.features[self.feature]["center"])
        found: Floats = self.samples.mean(axis=0)
        return found

    @property
    def text(self) -> str:
        """Description for a question."""
        if self.feature is not None:
            return text_of(self.shape.features[self.feature])
        return f"the {self.kind} at {_spoken(self.place)}"

    @property
    def extent(self) -> float:
        """Length of a line, or square root of the area of a face, mm."""
        if self.triangles is None:
            ends = self.shape.points[self.segments]
            return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())
        a, b, c = (self.shape.points[self.triangles[:, k]] for k in range(3))
        return float(np.sqrt(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()))

    def may_be(self, other: Thing, scale: float) -> bool:
        """Return whether the item can correspond to another one of a state scaled by `scale`."""
        if self.kind != other.kind or (self.way is None) != (other.way is None):
            return False
        extents = sorted([scale * self.extent, other.extent])
        if extents[1] > _SAME_EXTENT * extents[0]:
            return False
        return self.way is None or other.way is None or float(self.way @ other.way) > _SAME_WAY

    def gap(self, places: Floats) -> float:
        """Return the mean distance of points (k, 3) from the item, mm."""
        return float(np.mean([self._nearest(place)[0] for place in places]))

    def points(self, first: Floats) -> Iterator[Floats]:
        """Yield points at which a selector selects the item: its centre, then points on it."""
        yield self.place
        yield self._nearest(first)[1]
        yield from self.samples[:: max(1, len(self.samples) // 12)]

    def _nearest(self, place: Floats) -> tuple[float, Floats]:
        if self.triangles is None:
            ends = self.shape.points[self.segments]
            middles = ends.mean(axis=1)
            row = int(np.linalg.norm(middles - place, axis=1).argmin())
            return segments_distance(ends, place), middles[row]
        if not self._tree:
            core = self.shape.core
            self._tree.append(core.PickingTree(self.shape.points, self.triangles))
        hit = self._tree[0].nearest_point(place)
        return float(hit.distance), np.asarray(hit.point)


def text_of(entry: Mapping[str, Any]) -> str:
    """Return the description of a feature for a question: kind, size and position."""
    size = f" of {2.0 * entry['radius']:.4g} mm" if entry["kind"] == "round hole" else ""
    return f"the {entry['kind']}{size} at {_spoken(entry['center'])}"


def things_of(key: str, told: Told) -> Callable[[PartShape, Told], list[Thing]] | None:
    """Return the function that lists the candidates of a selector on a part.

    It is None for a selector that is a rule, a name or a volume.
    """
    if key == "found":
        return _features if "near" in told else None
    return _LISTED.get(key)


def _features(shape: PartShape, told: Told) -> list[Thing]:
    found = []
    for row, entry in enumerate(shape.features):
        if entry["kind"] == told["found"] or (entry["kind"] in RIMMED and told["found"] in RIMMED):
            rows = np.flatnonzero(shape.of_vertices(np.array(entry["vertices"])).share)
            if len(rows) and entry["kind"] not in RIMMED:
                found.append(replace(_face(shape, rows, entry["kind"]), feature=row))
            else:
                loop = np.array(entry["rims"][0] if entry.get("rims") else entry["vertices"])
                vertices = np.array(entry["vertices"])
                found.append(_line(shape, _closed(loop), "rim", vertices, row))
    return found


def _rims(shape: PartShape, told: Told) -> list[Thing]:
    loops, rows = rim_loops(shape, told)
    found: list[Thing] = []
    for k, loop in enumerate(loops):
        row = rows[k] if k < len(rows) else None
        if row is None or row not in rows[:k]:
            vertices = rim_vertices(shape, told, loop, row)
            found.append(_line(shape, _closed(loop), "rim", vertices, row))
    return found


def _faces(shape: PartShape, told: Told) -> list[Thing]:
    angle = math.radians(told.get("crease_angle", CREASE_ANGLE))
    is_free = np.ones(len(shape.triangles), dtype=bool)
    found = []
    for triangle in range(len(shape.triangles)):
        if is_free[triangle]:
            rows = np.asarray(shape.near.face(triangle, angle))
            is_free[rows] = False
            found.append(_face(shape, rows, "face"))
    return found


def _borders(shape: PartShape, _: Told) -> list[Thing]:
    return [_line(shape, _closed(loop), "border", loop) for loop in shape.border_loops]


def _pieces(shape: PartShape, _: Told) -> list[Thing]:
    is_free = np.ones(len(shape.triangles), dtype=bool)
    found = []
    for triangle in range(len(shape.triangles)):
        if is_free[triangle]:
            rows = np.asarray(shape.near.piece(triangle))
            is_free[rows] = False
            found.append(_face(shape, rows, "piece"))
    return found


def _cad_faces(shape: PartShape, told: Told) -> list[Thing]:
    face, faces = shape.labels.face, shape.labels.faces
    if face is None:
        return []
    present = [k for k in np.unique(face[face >= 0]).tolist()]
    return [
        _face(shape, np.flatnonzero(face == k), f"CAD face ({faces[k].kind})", faces[k].number)
        for k in present
        if told.get("kind", faces[k].kind) == faces[k].kind
    ]


def _cad_edges(shape: PartShape, _: Told) -> list[Thing]:
    return [
        _line(shape, edge.segments, "CAD edge", edge.segments.ravel()) for edge in shape.cad_edges
    ]


_LISTED: dict[str, Callable[[PartShape, Told], list[Thing]]] = {
    "rim_at": _rims,
    "face_at": _faces,
    "border_at": _borders,
    "piece_at": _pieces,
    "cad_face_at": _cad_faces,
    "cad_edge_at": _cad_edges,
}


def _closed(loop: Ints) -> Ints:
    """Return the segments (k, 2) of a closed polyline."""
    found: Ints = np.column_stack([loop, np.roll(loop, -1)])
    return found


def _line(
    shape: PartShape, segments: Ints, kind: str, vertices: Ints, feature: int | None = None
) -> Thing:
    """Return a line of segments with its selected vertices and its feature row."""
    spread = _spread(shape.points[segments].mean(axis=1))
    return Thing(kind, shape, np.unique(vertices), spread, segments=segments, feature=feature)


def _face(shape: PartShape, rows: Ints, kind: str, number: int | None = None) -> Thing:
    """Return triangles as an item; number is that of a CAD face."""
    triangles = np.ascontiguousarray(shape.triangles[rows])
    a, b, c = (shape.points[triangles[:, k]] for k in range(3))
    vector = 0.5 * np.cross(b - a, c - a).sum(axis=0)
    area = float(shape.areas[rows].sum())
    length = float(np.linalg.norm(vector))
    order = np.argsort(-shape.areas[rows], kind="stable")
    middles = ((a + b + c) / 3.0)[order]
    corners = np.unique(triangles)
    samples = np.concatenate([_spread(middles), _spread(shape.points[corners])])
    return Thing(
        kind, shape, corners, samples, triangles=triangles, number=number,
        way=vector / length if length > _FLAT * area else None,
    )  # fmt: skip


def _spread(places: Floats) -> Floats:
    """Return evenly distributed samples of many points."""
    step = np.linspace(0, len(places) - 1, min(len(places), _SAMPLES)).round().astype(int)
    found: Floats = places[step]
    return found


def _spoken(place: Any) -> str:
    return "(" + ", ".join(f"{x:.4g}" for x in np.round(np.asarray(place, float), 9) + 0.0) + ")"
