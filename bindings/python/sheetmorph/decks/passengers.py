# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passengers: nodes outside the sheet of a deck that follow it by adjustable rules."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.kernel import load_kernel
from ..base.motion import Motion, blended, on_triangle, rigid_along, rigid_motion
from ..measuring.strain import middle_edge
from .attachment import Group, groups_of
from .deck import Deck
from .shells import Sheet

if TYPE_CHECKING:
    from .. import _core

RULES = ("blend", "rigid", "nearest", "stay")
# A larger group without attachment to the sheet is a separate part.
_LARGEST_LOOSE = 64


@dataclass(frozen=True)
class Rules:
    """Rules for passengers.

    reach is the largest distance of a loose node from the sheet at which it follows, mm; None uses
    the median edge length. given has the rules of nodes by id.
    """

    reach: float | None = None
    given: dict[int, str] = field(default_factory=dict)


@dataclass
class Carried:
    """All nodes of a deck after a motion of its sheet, positions (n, 3).

    counts has the number of nodes by rule. left has the indices of nodes that follow nothing, or
    must stay.
    """

    positions: Floats
    counts: dict[str, int]
    left: Ints


class Passengers:
    """The nodes of a deck outside its sheet."""

    def __init__(self, deck: Deck, sheet: Sheet, rules: Rules = Rules()):
        self._deck, self._sheet, self._rules = deck, sheet, rules
        self._groups = groups_of(deck, sheet)
        self._rest = deck.points[sheet.nodes]
        middle = middle_edge(self._rest, sheet.triangles) if rules.reach is None else 0.0
        self.reach = middle if rules.reach is None else rules.reach

    @property
    def count(self) -> int:
        """Number of these nodes."""
        return sum(len(group.nodes) for group in self._groups)

    def carried(self, positions: Floats) -> Carried:
        """Return all nodes for sheet nodes at positions (k, 3)."""
        whole = self._deck.points.copy()
        whole[self._sheet.nodes] = positions
        found = Carried(whole, dict.fromkeys(RULES, 0), np.empty(0, dtype=np.int64))
        if np.array_equal(positions, self._rest):
            return found
        hits = self._hits()
        motion = Motion(self._rest, positions, self._sheet.triangles, self._asked(hits))
        left = [found.left]
        for number, group in enumerate(self._groups):
            rule = self._rule_of(group)
            places = self._places(motion, group, rule, hits.get(number))
            if places is None:
                found.counts["stay"] += len(group.nodes)
                left.append(group.nodes)
                continue
            whole[group.nodes] = places
            found.counts[rule] += len(group.nodes)
        found.left = np.concatenate(left)
        return found

    def holding(self) -> Ints:
        """Return the rows (k,) of sheet nodes whose motion passengers follow."""
        near = {
            number: [hit for hit in hits if hit is not None and hit.distance <= self.reach]
            for number, hits in self._hits().items()
        }
        return self._asked(near)

    def _asked(self, hits: Mapping[int, Sequence[_core.Hit | None]]) -> Ints:
        asked = [group.held for group in self._groups]
        asked += [
            self._sheet.triangles[hit.triangle] for some in hits.values() for hit in some if hit
        ]
        found: Ints = np.unique(np.concatenate([np.empty(0, np.int64), *asked])).astype(np.int64)
        return found

    def _hits(self) -> dict[int, list[_core.Hit | None]]:
        """Return the nearest sheet points of the loose groups that follow them, by group."""
        wanted = [
            k
            for k, group in enumerate(self._groups)
            if self._rule_of(group) == "nearest" and len(group.nodes) <= _LARGEST_LOOSE
        ]
        if not wanted:
            return {}
        tree = load_kernel().PickingTree(self._rest, self._sheet.triangles)
        points = self._deck.points
        return {k: [tree.nearest_point(points[n]) for n in self._groups[k].nodes] for k in wanted}

    def _rule_of(self, group: Group) -> str:
        for node in self._deck.ids[group.nodes].tolist() if self._rules.given else ():
            if node in self._rules.given:
                return self._rules.given[node]
        if not len(group.held):
            return "nearest"
        is_rigid = not group.kinds.isdisjoint(("rigid", "constraint"))
        return "rigid" if is_rigid and "solid" not in group.kinds else "blend"

    def _places(
        self, motion: Motion, group: Group, rule: str, hits: list[_core.Hit | None] | None
    ) -> Floats | None:
        points = self._deck.points[group.nodes]
        if rule == "stay" or (hits is None and not len(group.held)):
            return None
        if hits is not None:
            return self._nearest(motion, hits, points)
        if motion.stays(group.held):
            return points
        if rule == "rigid":
            turn, shift = rigid_along(motion, group.held)
            return points @ turn.T + shift
        return blended(motion, group.held, points)

    def _nearest(
        self, motion: Motion, hits: Sequence[_core.Hit | None], points: Floats
    ) -> Floats | None:
        """Return the positions of loose points, or None if they are too far from the sheet."""
        near = {k: hit for k, hit in enumerate(hits) if hit and hit.distance <= self.reach}
        if not near:
            return None
        chosen = list(near)
        images = np.array([self._image(motion, hit, points[k]) for k, hit in near.items()])
        if len(points) == 1 or len(chosen) == len(points) < 3:
            return images
        found = rigid_motion(points[chosen], images)
        if found is None:
            shift = (images - points[chosen]).mean(axis=0)
            result: Floats | None = points + shift
            return result
        turn, shift = found
        moved = points @ turn.T + shift
        return points if np.array_equal(images, points[chosen]) else moved

    @staticmethod
    def _image(motion: Motion, hit: _core.Hit, point: Floats) -> Floats:
        corners = motion.triangles[hit.triangle]
        if motion.stays(corners):
            return point
        return on_triangle(motion, hit.triangle, np.asarray(hit.barycentric), point)


def rules_of(entries: dict[str, Any] | None) -> Rules:
    """Return the rules from the recipe key `passengers`."""
    entries = entries or {}
    given: dict[int, str] = {}
    for entry in entries.get("rules", ()):
        given |= {int(node): entry["rule"] for node in entry["nodes"]}
    reach = entries.get("reach")
    return Rules(None if reach is None else float(reach), given)
