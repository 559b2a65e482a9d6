# SPDX-License-Identifier: LGPL-2.1-or-later
"""A welded seat frame of 14 parts: rails, cross members, stringers, brackets (x forward, z up)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from shapes.curves import closed_steps
from shapes.example import Example, Grip, motion
from shapes.planar import Blank, Hole, triangulate
from shapes.sheet import Sheet, at_steps, loft, on_map, placed
from shapes.strips import Profile, Strip, folded, rounded_end
from shapes.surface import Bead, Seat, tangent_frame, with_beads, with_seats

GAP = 1.2  # mm between welded sheets
RAIL_Y, CROSS_X, STRINGER_Y = 250.0, 330.0, 90.0
RAIL_HEIGHT, CROSS_HEIGHT, STRINGER_HEIGHT = 64.0, 46.0, 30.0
CROSS_TOP = GAP + CROSS_HEIGHT
STRINGER_TOP = CROSS_TOP + GAP + STRINGER_HEIGHT
QUARTER = np.pi / 2
X, Y, Z = np.eye(3)


@dataclass(frozen=True)
class Folding:
    """A part folded from a strip: section, half its width, in which directions it lies."""

    profile: Profile
    half: float
    along: np.ndarray
    across: np.ndarray
    spacing: float
    total: int
    corner: float = 6.0

    def sheet(self, name: str, holes: tuple[Hole, ...], beads: tuple[Bead, ...] = ()) -> Sheet:
        ends = np.cumsum([length for length, _ in self.profile.runs])

        def high(arc: np.ndarray) -> np.ndarray:
            return self.half - rounded_end(arc, ends[-1], self.corner)

        strip = Strip(
            ends[-1], lambda arc: -high(arc), high, tuple(ends[:-1]), self.spacing, holes, False
        )
        crests = [line for bead in beads for line in bead.outlines(0.7 * self.spacing)]
        lines = (*strip.fold_lines(), *crests)
        blank = Blank(strip.outline(), holes, lines, self.spacing, self.total, 0.45)
        surface = folded(self.profile, np.array([self.along, Z]), self.across)
        return on_map(name, triangulate(blank), with_beads(surface, beads))


def hat(web: float, height: float, flange: float, radius: float) -> Profile:
    """A hat section centred on 0, its flanges at height 0."""
    bend, wall = radius * QUARTER, height - 2 * radius
    left = ((flange, 0), (bend, 90), (wall, 0), (bend, -90))
    right = ((bend, -90), (wall, 0), (bend, 90), (flange, 0))
    return Profile((-web / 2 - 2 * radius - flange, 0.0), 0.0, (*left, (web, 0), *right))


def middle(profile: Profile, run: int) -> float:
    """The arc length in the middle of a run of a section."""
    lengths = [length for length, _ in profile.runs]
    return sum(lengths[:run]) + lengths[run] / 2


def rail() -> Sheet:
    """A rail along x, its outer wall towards +y, its web at height 0."""
    section = hat(68.0, RAIL_HEIGHT, 25.0, 8.0)
    web, outer = middle(section, 4), middle(section, 6) - 2.0
    holes = [Hole(f"mount {n}", (web, x), 8.0, 16, 5.0) for n, x in (("a", 424.0), ("b", -424.0))]
    holes += [Hole(f"access {n}", (web, x), 17.0, 20, 6.0) for n, x in (("a", 232), ("b", -232))]
    holes += [
        Hole(f"strap {n}", (outer, x), 8.0, 16, 5.0) for n, x in (("a", CROSS_X), ("b", -CROSS_X))
    ]
    beads = (
        Bead((web, 92.0), (web, 178.0), 5.0, 15.0, 5.0),
        Bead((web, -178.0), (web, -92.0), 5.0, 15.0, 5.0),
    )
    return Folding(section, 450.0, Y, -X, 27.0, 760).sheet("rail", tuple(holes), beads)


def cross() -> Sheet:
    """A cross member along y, its flanges at height 0."""
    section = hat(60.0, CROSS_HEIGHT, 22.0, 8.0)
    web = middle(section, 4)
    holes = [Hole(f"strap {n}", (web, y), 8.0, 16, 5.0) for n, y in (("a", 235), ("b", -235))]
    holes += [Hole("centre", (web, 0.0), 13.0, 20, 5.0)]
    return Folding(section, 286.0, X, Y, 22.0, 535).sheet("cross", tuple(holes))


def stringer() -> Sheet:
    """A stringer along x, its flanges at height 0."""
    section = hat(40.0, STRINGER_HEIGHT, 18.0, 7.0)
    web = middle(section, 4)
    holes = [Hole(f"plate {n}", (web, x), 6.5, 16, 3.5) for n, x in (("a", 125), ("b", -125))]
    return Folding(section, 395.0, Y, -X, 24.0, 480).sheet("stringer", tuple(holes))


def strap() -> Sheet:
    """A strap from the web of a cross member at y = 208 down the outer wall of a rail."""
    start, radius = 208.0 - RAIL_Y, 8.0
    wall = 34.0 + radius + GAP
    tab, bend, drop = wall - radius - start, radius * QUARTER, 90.0
    section = Profile((start, CROSS_TOP + GAP), 0.0, ((tab, 0), (bend, -90), (drop, 0)))
    top = tab + bend
    depth = CROSS_TOP + GAP - radius + RAIL_HEIGHT / 2 - 2.0
    holes = (
        Hole("cross member", (235.0 - 208.0, 0.0), 8.0, 16, 4.0),
        Hole("rail", (top + depth, 0.0), 8.0, 16, 4.0),
    )
    beads = (Bead((top + 14.0, 0.0), (top + 42.0, 0.0), 3.0, 9.0, 3.0),)
    return Folding(section, 21.0, Y, -X, 9.0, 175, 12.0).sheet("strap", holes, beads)


def mount() -> Sheet:
    """A bumper mount: a tab on the web of a rail at x = 402 and an upright plate before its end."""
    section = Profile((402.0, GAP), 0.0, ((46.0, 0), (8.0 * QUARTER, 90), (84.0, 0)))
    plate = middle(section, 2) + 4.0
    holes = [Hole("rail", (22.0, 0.0), 8.0, 16, 4.0), Hole("tow", (plate, 0.0), 13.0, 20, 4.0)]
    for number, (u, v) in enumerate(((-22, -20), (-22, 20), (22, -20), (22, 20)), start=1):
        holes.append(Hole(f"bumper {number}", (plate + u, float(v)), 5.0, 16, 3.0))
    return Folding(section, 32.0, X, Y, 8.5, 310, 12.0).sheet("mount", tuple(holes))


def seat_plate(total: int) -> Sheet:
    """The plate on the stringers: raised access hole, bolts, beads, a turned-up edge."""
    height = STRINGER_TOP + GAP
    arc = np.linspace(0, QUARTER, 30)
    bow = 26.0 * np.column_stack([np.cos(arc), np.sin(arc)])
    turns = [bow, bow[:, ::-1] * [-1, 1], -bow, bow[:, ::-1] * [1, -1]]
    corners = [[136.0, 94.0], [-136.0, 94.0], [-136.0, -94.0], [136.0, -94.0]]
    loop = np.vstack([np.array(corner) + turn for corner, turn in zip(corners, turns)])
    access = Hole("access", (0.0, 0.0), 40.0, 28, 6.0)
    holes = [access]
    places = [(125.0, 90.0), (-125.0, 90.0), (-125.0, -90.0), (125.0, -90.0)]
    holes += [Hole(f"bolt {k}", place, 7.5, 16, 4.5) for k, place in enumerate(places, start=1)]
    edge = closed_steps(loop, 21.0, holes)[:-1]
    beads = tuple(Bead((x, -42.0), (x, 42.0), 4.0, 13.0, 5.0) for x in (-92.0, 92.0))
    lines = tuple(line for bead in beads for line in bead.outlines(12.0))
    blank = Blank(edge, tuple(holes), lines, 17.0, total - 2 * len(edge), 0.45)

    def level(at: np.ndarray) -> np.ndarray:
        return np.column_stack([at, np.full(len(at), height)])

    seat = Seat(access.centre, 47.0, 60.0, tangent_frame(level, access.centre).raised(5.0))
    sheet = on_map("seat plate", triangulate(blank), with_beads(with_seats(level, [seat]), beads))
    along = np.roll(edge, -1, axis=0) - np.roll(edge, 1, axis=0)
    side = np.column_stack([along[:, 1], -along[:, 0], np.zeros(len(edge))])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    bound = level(edge)
    loft(sheet, 2, lambda t, row: at_steps(bound + 5.0 * side, t) + (4.0 + 10.0 * (row - 1)) * Z)
    return sheet


def sheets() -> tuple[Sheet, ...]:
    """The primary first: the left rail."""
    ends, members, strings = rail(), cross(), stringer()
    parts = [placed(ends, "rail left", RAIL_Y * Y - RAIL_HEIGHT * Z)]
    below = -RAIL_Y * Y - RAIL_HEIGHT * Z
    parts += [placed(ends, "rail right", below, turned=True)]
    for name, x in (("front", CROSS_X), ("middle", 0.0), ("rear", -CROSS_X)):
        parts.append(placed(members, f"cross {name}", x * X + GAP * Z))
    for name, y in (("left", STRINGER_Y), ("right", -STRINGER_Y)):
        parts.append(placed(strings, f"stringer {name}", y * Y + (CROSS_TOP + GAP) * Z))
    straps, mounts = strap(), mount()
    for end, x in (("front", CROSS_X), ("rear", -CROSS_X)):
        parts.append(placed(straps, f"strap {end} left", x * X + RAIL_Y * Y))
        parts.append(placed(straps, f"strap {end} right", x * X - RAIL_Y * Y, turned=True))
    parts += [placed(mounts, "mount left", RAIL_Y * Y), placed(mounts, "mount right", -RAIL_Y * Y)]
    rest = 5963 - sum(len(part.points) for part in parts)
    return (*parts, seat_plate(rest))


def example() -> Example:
    """The front end of the left rail is lifted and turned; through 24 welds everything follows."""
    parts = sheets()
    return Example(
        folder="welded_frame",
        sheets=parts,
        formats=("obj",) * (len(parts) - 1) + ("ply",),
        fixed=(Grip("rear end", "rail left", lambda p: p[:, 0] < -385.0),),
        handles=(Grip("front end", "rail left", lambda p: p[:, 0] > 398.0),),
        pose={"front end": motion((0.0, 0.0, 55.0), (0.0, -1.0, 0.0), 9.0)},
        supports=(),
        reach=1.25 * GAP,
        propagation="local",
        margin=16.0,
        one_contact_per_pair=True,
    )
