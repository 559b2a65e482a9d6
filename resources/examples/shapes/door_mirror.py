# SPDX-License-Identifier: LGPL-2.1-or-later
"""A door mirror: cover shell, support frame inside it, foot that carries it (x outward, z up)."""

from __future__ import annotations

import numpy as np

from shapes.curves import circle, closed_steps
from shapes.example import Example, Grip, motion
from shapes.planar import Blank, Hole, triangulate
from shapes.sheet import Sheet, at_steps, loft, on_map
from shapes.strips import Profile, Strip, folded, rounded_end
from shapes.surface import (
    Bead,
    Frame,
    Map,
    Seat,
    normals,
    smooth_step,
    tangent_frame,
    with_beads,
    with_seats,
)

GAP = 1.2  # mm between touching sheets
CENTRE = np.array([96.0, 62.0])
BOLTS = {
    "bolt top": Hole("bolt top", (46.0, 91.0), 4.5, 16, 3.2),
    "bolt bottom": Hole("bolt bottom", (44.0, 33.0), 4.5, 16, 3.2),
    "bolt tip": Hole("bolt tip", (148.0, 43.0), 4.5, 16, 3.2),
}
FOOT_BOLTS = ((40.0, 55.0), (40.0, 69.0))
FRAME_PLANE = -3.0  # y of the support frame's web
CUP = 13.8  # mm, radius at which the frame's cups leave its web


def outline(width: float, height: float, power: float, count: int) -> np.ndarray:
    """(count, 2) counter-clockwise rounded trapezoid around CENTRE, lower towards the tip."""
    angle = np.linspace(0, 2 * np.pi, 721)[:-1]
    bow = np.column_stack([np.cos(angle), np.sin(angle)])
    loop = np.sign(bow) * np.abs(bow) ** (2 / power)
    loop = loop * [width / 2, height / 2] * np.column_stack([np.ones(720), 1 - 0.14 * loop[:, 0]])
    return closed_steps(CENTRE + loop, 1.0, (), count)[:-1]


def dome(at: np.ndarray) -> np.ndarray:
    """The cover's front: gently curved both ways, its front towards -y."""
    x, z = (at - CENTRE).T / [[95.0], [60.0]]
    depth = -22 + 12 * x**2 + 10 * z**2 + 3 * x
    return np.column_stack([at[:, 0], depth, at[:, 1]])


def cover() -> Sheet:
    """The primary part: a domed front, rolled edge, wall and return lip."""
    holes = (*BOLTS.values(), Hole("lamp", (148.0, 84.0), 13.0, 24, 4.0))
    beads = (Bead((64.0, 78.0), (114.0, 78.0), 3.0, 8.5, 3.0),)
    lines = tuple(line for bead in beads for line in bead.outlines(8.5))
    edge = outline(184, 118, 2.9, 52)
    blank = Blank(edge, holes, lines, 11.0, 706 - 52 * 6, 0.4)
    surface = with_beads(with_seats(dome, cover_seats()), beads)
    sheet = on_map("cover", triangulate(blank), surface)
    bound, outward = edge_frames(surface, edge)
    loft(sheet, 6, lambda t, row: _cover_wall(at_steps(bound, t), at_steps(outward, t), row))
    return sheet


def cover_seats() -> list[Seat]:
    """Flat bosses around the cover's holes; the bolts' are pressed in by 1 mm."""
    seats = [
        Seat(hole.centre, 8.4, 15.0, tangent_frame(dome, hole.centre).raised(-1.0))
        for hole in BOLTS.values()
    ]
    lamp = tangent_frame(dome, (148.0, 84.0)).raised(-1.5)
    return [*seats, Seat((148.0, 84.0), 17.5, 23.0, lamp)]


def edge_frames(surface: Map, edge: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions of a blank outline in space and the unit directions outward along the sheet."""
    along = np.roll(edge, -1, axis=0) - np.roll(edge, 1, axis=0)
    side = np.column_stack([along[:, 1], -along[:, 0]])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    bound, normal = surface(edge), normals(surface, edge)
    step = surface(edge + 1e-3 * side) - surface(edge - 1e-3 * side)
    step -= np.sum(step * normal, axis=1, keepdims=True) * normal
    return bound, step / np.linalg.norm(step, axis=1, keepdims=True)


def _cover_wall(bound: np.ndarray, outward: np.ndarray, row: int) -> np.ndarray:
    """Rows 1 to 3 roll the edge over, 4 and 5 run straight back to the glass, 6 turns inward."""
    rolled, back = bound, np.array([0.0, 1.0, 0.0])
    for turn in np.radians([20.0, 47.0, 74.0])[:row]:
        rolled = rolled + 9.0 * (np.cos(turn) * outward + np.sin(turn) * back)
    if row <= 3:
        return rolled
    aside = outward * [1, 0, 1]
    opening = rolled + 2.0 * aside
    opening[:, 1] = 42.0
    if row <= 5:
        share = (row - 3) / 2
        return (1 - share) * rolled + share * opening
    return opening - 7.0 * aside + 0.8 * back


def plate(at: np.ndarray) -> np.ndarray:
    """The web of the support frame."""
    return np.column_stack([at[:, 0], np.full(len(at), FRAME_PLANE), at[:, 1]])


def frame() -> Sheet:
    """The support frame: a web with cups up to the cover's bosses, a motor hole, an edge flange."""
    motor = Hole("motor", (100.0, 60.0), 20.0, 36, 3.5)
    small = [Hole(f"foot {k + 1}", FOOT_BOLTS[k], 3.5, 16, 2.2) for k in range(2)]
    small += [Hole("cable", (140.0, 82.0), 8.0, 24, 2.5)]
    bolts = [Hole(name, hole.centre, 4.0, 16, 2.5) for name, hole in BOLTS.items()]
    beads = (
        Bead((72.0, 98.0), (110.0, 97.0), 1.6, 5.0, 2.0),
        Bead((72.0, 23.0), (110.0, 24.0), 1.6, 5.0, 2.0),
    )
    lines = [line for bead in beads for line in bead.outlines(4.6)]
    lines += [circle(hole.centre, CUP, 4.2) for hole in bolts]
    lines += [circle(hole.centre, 11.0, 3.4) for hole in bolts]
    lines += [circle(motor.centre, 29.0, 4.5)]
    edge = outline(154, 96, 3.2, 96)
    blank = Blank(edge, (motor, *small, *bolts), tuple(lines), 6.0, 1264 - 96 * 3, 0.4)
    sheet = on_map("frame", triangulate(blank), with_beads(_frame_surface(), beads))
    bound, outward = edge_frames(plate, edge)
    loft(sheet, 3, lambda t, row: _edge_flange(at_steps(bound, t), at_steps(outward, t), row))
    return sheet


def _frame_surface() -> Map:
    """The web with cups whose bottoms lie one gap behind the cover's, and a raised motor rim."""
    seats = [Seat(seat.centre, 8.2, CUP, seat.frame.raised(-GAP)) for seat in cover_seats()[:3]]
    motor = Frame(np.array([100.0, FRAME_PLANE, 60.0]), np.eye(3)[0], np.eye(3)[2])
    return with_seats(plate, [*seats, Seat((100.0, 60.0), 23.5, 29.0, motor.raised(3.0))])


def _edge_flange(bound: np.ndarray, outward: np.ndarray, row: int) -> np.ndarray:
    """A bent edge: one row round the bend, two straight back."""
    back = np.array([0.0, 1.0, 0.0])
    bent = bound + 2.4 * outward + 2.4 * back
    return bent + (row - 1) * 4.4 * (back + 0.08 * outward)


FOOT = Profile(
    (60.0, FRAME_PLANE + GAP),
    180.0,
    ((30.0, 0), (9.4, -90), (39.0, 0), (9.4, 90), (48.0, 0), (9.4, 90), (62.0, 0)),
)


def foot() -> Sheet:
    """The foot: an arm on the frame, a step out of the housing, a plate for the door's bolts."""
    ends = np.cumsum([length for length, _ in FOOT.runs])
    holes = [
        Hole(f"foot {k + 1}", (60.0 - x, z - 62.0), 3.5, 16, 2.2)
        for k, (x, z) in enumerate(FOOT_BOLTS)
    ]
    middle = ends[5] + 33.0
    for k, (s, z) in enumerate(((-19.0, -27.0), (19.0, -27.0), (-19.0, 27.0), (19.0, 27.0))):
        holes.append(Hole(f"door {k + 1}", (middle + s, z), 4.5, 16, 2.5))
    holes.append(Hole("cable", (middle, 0.0), 10.0, 24, 3.0))
    bead = Bead((ends[3] + 9.0, 0.0), (ends[4] - 9.0, 0.0), 2.0, 6.5, 2.5)
    strip = _foot_strip(ends, holes)
    lines = (*strip.fold_lines(), *bead.outlines(5.5))
    blank = Blank(strip.outline(), tuple(holes), lines, 7.0, 500, 0.4)
    surface = folded(FOOT, np.eye(3)[:2], np.eye(3)[2])
    flat = triangulate(blank)
    sheet = on_map("foot", flat, with_beads(surface, (bead,)))
    sheet.points = sheet.points + [0.0, 0.0, 62.0]
    return sheet


def _foot_strip(ends: np.ndarray, holes: list[Hole]) -> Strip:
    """36 mm wide on the frame, 80 mm wide at the door, the corners rounded."""

    def half(arc: np.ndarray) -> np.ndarray:
        wide = 17.0 + 23.0 * smooth_step((arc - ends[4] + 14.0) / 40.0)
        return wide - rounded_end(arc, ends[-1], 10.0)

    folds = [ends[k] + share * 9.4 for k in (0, 2, 4) for share in (0.0, 0.5, 1.0)]
    return Strip(ends[-1], lambda arc: -half(arc), half, tuple(folds), 6.0, tuple(holes))


def example() -> Example:
    """The tip of the cover is lifted and turned while its inboard side stays."""
    sheets = (cover(), frame(), foot())
    tip = Grip("tip", "cover", lambda p: p[:, 0] > 174.0)
    return Example(
        folder="door_mirror",
        sheets=sheets,
        formats=("obj", "ply", "obj"),
        fixed=(Grip("inboard side", "cover", lambda p: p[:, 0] < 16.0),),
        handles=(tip,),
        pose={"tip": motion((2.2, 0.0, 16.0), (0.0, -1.0, 0.0), 8.0)},
        supports=(Grip("door plate", "foot", lambda p: p[:, 0] < -35.0),),
        reach=1.25 * GAP,
        propagation="single",
    )
