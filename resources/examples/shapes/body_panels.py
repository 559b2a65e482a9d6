# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two body panels: side wall A stands with its flange on floor pan B (x forward, z up)."""

from __future__ import annotations

import numpy as np

from shapes.curves import circle, closed_steps
from shapes.example import Example, Grip, motion
from shapes.planar import Blank, Hole, inside, triangulate
from shapes.sheet import Sheet, on_map
from shapes.strips import Profile, Strip, rounded_end
from shapes.surface import (
    Bead,
    Frame,
    Seat,
    smooth_step,
    tangent_frame,
    with_beads,
    with_seats,
)

GAP = 1.5  # mm between the flanges
HALF = 400.0  # half the length of the floor
SIDE = 352.0  # half the length of the side wall
DEPTH = 32.0  # of the floor's pan
PAN_TOP, PAN_MIDDLE, PAN_FOOT = (
    (48.0, 96.0),
    (71.0, 73.0),
    (94.0, 50.0),
)  # inset from the edge and corner radius, mm
BOW = 45.0  # how far the side wall bulges outward
BOLTS = (-288.0, -96.0, 96.0, 288.0)
SECTION = Profile((-40.0, 0.0), 0.0, ((40.0, 0), (15.7, 84), (220.0, 12), (15.7, -92), (24.0, 0)))


def meeting_curve(along: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(n, 3) points of the line where the side wall meets the floor, and its outward normals."""
    points = np.column_stack([along, -BOW * (along / HALF) ** 2, np.zeros_like(along)])
    slope = -2 * BOW * along / HALF**2
    normal = np.column_stack([-slope, np.ones_like(along), np.zeros_like(along)])
    return points, normal / np.linalg.norm(normal, axis=1, keepdims=True)


def wall(at: np.ndarray) -> np.ndarray:
    """Blank (arc of the section, place along the panel) to space."""
    points, outward = meeting_curve(at[:, 1])
    section = SECTION.at(at[:, 0])
    return points + section[:, :1] * outward + section[:, 1:] * np.array([0.0, 0.0, 1.0])


def side() -> Sheet:
    """Part A: flange with bolt holes, crowned wall with two access holes and a bead, top flange."""
    ends = np.cumsum([length for length, _ in SECTION.runs])
    middle = (ends[1] + ends[2]) / 2
    bolts = [Hole(f"bolt {k + 1}", (20.0, -x), 8.0, 16, 5.0) for k, x in enumerate(BOLTS)]
    access = [
        Hole("access rear", (middle, 216.0), 42.0, 28, 9.0),
        Hole("access front", (middle, -216.0), 42.0, 28, 9.0),
    ]
    bead = Bead((middle, -118.0), (middle, 118.0), 9.0, 26.0, 9.0)

    def half(arc: np.ndarray) -> np.ndarray:
        return SIDE - rounded_end(arc, ends[-1], 16.0)

    strip = Strip(ends[-1], lambda arc: -half(arc), half, tuple(ends[:4]), 20.0, tuple(bolts))
    lines = (*strip.fold_lines(), *bead.outlines(19.0))
    lines += tuple(circle(hole.centre, 68.0, 16.0) for hole in access)
    blank = Blank(strip.outline(), (*bolts, *access), lines, 24.0, 820, 0.45)
    seats = [Seat(hole.centre, 13.5, 19.0, tangent_frame(_turned, hole.centre)) for hole in bolts]
    seats += [
        Seat(hole.centre, 51.5, 68.0, tangent_frame(_turned, hole.centre).raised(-5.0))
        for hole in access
    ]
    surface = with_beads(with_seats(_turned, seats), (bead,))
    return on_map("side", triangulate(blank), surface)


def _turned(at: np.ndarray) -> np.ndarray:
    """The wall with its blank turned so that the triangles face outward."""
    return wall(at * [1.0, -1.0])


def floor_loop(inset: float, radius: float) -> np.ndarray:
    """A counter-clockwise loop `inset` mm inside the floor's edge, its corners rounded."""
    side, deep = HALF - inset, -480.0 + inset
    along = np.linspace(side - radius, radius - side, 400)
    points, outward = meeting_curve(along)
    front = (points + (5.0 - inset) * outward)[:, :2]
    arc = np.linspace(0, np.pi / 2, 40)
    bow = radius * np.column_stack([np.cos(arc), np.sin(arc)])
    turns = [bow, bow[:, ::-1] * [-1, 1], -bow, bow[:, ::-1] * [1, -1]]
    left, right, low = radius - side, side - radius, deep + radius
    high = front[0, 1] - radius
    places = np.array([[right, high], [left, high], [left, low], [right, low]])
    corners = [place + turn for place, turn in zip(places, turns)]
    return np.vstack([corners[0], front[1:-1], *corners[1:]])


def pan(at: np.ndarray) -> np.ndarray:
    """The floor: a flat rim just below the side's flange and a pan drawn 32 mm below the rim."""
    edge = closed_steps(floor_loop(*PAN_TOP), 3.0)
    starts, spans = edge[:-1], np.diff(edge, axis=0)
    offset = at[:, None] - starts[None]
    share = np.clip(np.sum(offset * spans, axis=2) / np.sum(spans**2, axis=1), 0, 1)
    away = np.linalg.norm(offset - share[..., None] * spans, axis=2).min(axis=1)
    away = np.where(inside(edge[:-1], at), away, 0.0)
    slope = PAN_FOOT[0] - PAN_TOP[0]
    return np.column_stack([at, -GAP - DEPTH * smooth_step(away / slope)])


def floor() -> Sheet:
    """Part B: rim with bolt holes, drawn pan with an access hole, drains and beads."""
    points, outward = meeting_curve(np.array(BOLTS))
    at_side = (points - 20.0 * outward)[:, :2]
    places = [*at_side, (-310.0, -457.0), (-105.0, -457.0), (105.0, -457.0), (310.0, -457.0)]
    places += [(-377.0, -240.0), (377.0, -240.0)]
    bolts = [Hole(f"bolt {k + 1}", tuple(p), 8.0, 16, 5.0) for k, p in enumerate(places)]
    edge = closed_steps(floor_loop(0.0, 36.0), 20.0, bolts)[:-1]
    drains = [Hole("drain rear", (-200.0, -240.0), 24.0, 24, 7.0)]
    drains += [Hole("drain front", (200.0, -240.0), 24.0, 24, 7.0)]
    access = Hole("access", (0.0, -240.0), 54.0, 32, 10.0)
    beads = floor_beads()
    seats = [Seat(drain.centre, 31.5, 42.0, _level(drain, -4.0)) for drain in drains]
    seats.append(Seat(access.centre, 65.0, 80.0, _level(access, 8.0)))
    lines = [line for bead in beads for line in bead.outlines(17.0)]
    lines += [
        closed_steps(floor_loop(*loop), 19.0, bolts) for loop in (PAN_TOP, PAN_MIDDLE, PAN_FOOT)
    ]
    blank = Blank(edge, (*bolts, *drains, access), tuple(lines), 22.0, 1757, 0.45)
    surface = with_beads(with_seats(pan, seats), beads)
    return on_map("floor", triangulate(blank), surface)


def floor_beads() -> tuple[Bead, ...]:
    """Four beads along the panel and two across its middle."""
    along = [(x, y) for x in (-270.0, 110.0) for y in (-150.0, -330.0)]
    beads = [Bead((x, y), (x + 160.0, y), 9.0, 24.0, 9.0) for x, y in along]
    beads += [Bead((-50.0, y), (50.0, y), 9.0, 24.0, 9.0) for y in (-132.0, -348.0)]
    return tuple(beads)


def _level(hole: Hole, height: float) -> Frame:
    """A horizontal seat above the bottom of the pan."""
    frame = tangent_frame(lambda at: np.column_stack([at, np.zeros(len(at))]), hole.centre)
    return frame.raised(height - GAP - DEPTH)


def example() -> Example:
    """The front end of the side wall is pulled outward, lifted and turned; the floor follows."""
    return Example(
        folder="body_panels",
        sheets=(side(), floor()),
        formats=("obj", "ply"),
        fixed=(Grip("rear end", "side", lambda p: p[:, 0] < -318.0),),
        handles=(Grip("front end", "side", lambda p: p[:, 0] > 318.0),),
        pose={"front end": motion((0.0, 30.0, 60.0), (0.0, -1.0, 0.0), 10.0)},
        supports=(),
        reach=1.1 * GAP,
        propagation="single",
    )
