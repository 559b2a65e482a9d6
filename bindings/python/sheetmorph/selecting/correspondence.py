# SPDX-License-Identifier: LGPL-2.1-or-later
"""Correspondence between the holes of a part before and after a change.

The match explains the change with the fewest edits: holes that stay, groups of holes that moved as
one rigid body, and single holes that moved or were resized, removed or added. A hole stays
unmatched if another explanation is nearly as short and does not move the hole clearly farther. Both
candidates are then its rivals.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from .rigid_motions import Motion, proposed_motions

# A hole may move by this share of the distance to the next candidate.
HALF = 0.5
# Sizes with a smaller relative difference are equal. Axes with a smaller cosine belong to different
# walls.
_SAME_SIZE, _SAME_AXIS = 0.02, 0.9
# Tolerances for a rigid motion, as shares of the hole size and of the distance to the next hole.
_OF_SIZE, _OF_PITCH = 0.02, 0.1
# Explanations with this number of edits beyond the shortest one are also possible.
_MARGIN = 1
_GROUPS, _STARTS = 4, 12


@dataclass(frozen=True, eq=False)
class Holes:
    """Holes of a part: kinds, centres (n, 3), axes (n, 3), sizes (n, 2), larger first, mm."""

    kinds: list[str]
    places: Floats
    axes: Floats
    sizes: Floats

    def __len__(self) -> int:
        return len(self.kinds)


@dataclass(frozen=True)
class Match:
    """The match of a hole: its row on the changed part, or None and the rivals if it is uncertain.

    moved is in mm, 0 for an unmatched hole.
    """

    new: int | None
    rivals: list[int] = field(default_factory=list)
    moved: float = 0.0


@dataclass(frozen=True)
class _Explanation:
    """A possible explanation of the change.

    pairs (n,) has the new hole of every old one, -1 for none. groups (n,) is equal for holes that
    move together, 0 for those at rest. edits counts the changes. moved is the total distance, mm.
    """

    pairs: Ints
    groups: Ints
    edits: int
    moved: float


def matched(old: Holes, new: Holes) -> list[Match]:
    """Return for every old hole its match among the new ones."""
    if not len(old):
        return []
    if not len(new):
        return [Match(None) for _ in range(len(old))]
    pair = _Pair(old, new)
    found = sorted(pair.explanations(), key=lambda one: (one.edits, one.moved))
    best = found[0]
    others = [one for one in found[1:] if one.edits <= best.edits + _MARGIN]
    return [_decided(pair, k, best, others) for k in range(len(old))]


def _decided(pair: _Pair, k: int, best: _Explanation, others: Sequence[_Explanation]) -> Match:
    chosen = int(best.pairs[k])
    if chosen < 0:
        return Match(None, pair.nearest(k))
    if best.groups[k] > 0:
        rows = np.flatnonzero(best.groups == best.groups[k])
        moved = pair.moved(best, rows)
        differs = [one for one in others if one.pairs[k] not in (-1, chosen)]
        close = {int(one.pairs[k]) for one in differs if moved > HALF * pair.moved(one, rows)}
        if close:
            gaps = pair.gaps[k]
            return Match(None, sorted({chosen, *close}, key=lambda j: float(gaps[j])))
    return Match(chosen, moved=float(pair.gaps[k, chosen]))


class _Pair:
    """The holes of a part in two states.

    gaps (n, m) are distances between old and new centres, mm. may (n, m) states whether a hole can
    correspond to another, and same (n, m) whether kind and size agree too. slack (n,) is the
    distance that counts as rest, mm.
    """

    def __init__(self, old: Holes, new: Holes):
        self.old, self.new = old, new
        self.gaps: Floats = _gaps(old.places, new.places)
        self.may: Bools = np.abs(old.axes @ new.axes.T) > _SAME_AXIS
        kinds = np.array(old.kinds)[:, None] == np.array(new.kinds)[None, :]
        larger = np.maximum(old.sizes[:, None, :], new.sizes[None, :, :])
        differs = np.abs(old.sizes[:, None, :] - new.sizes[None, :, :])
        self.same: Bools = self.may & kinds & (differs <= _SAME_SIZE * larger).all(axis=2)
        self.slack = self._slack()

    def _slack(self) -> Floats:
        slack = _OF_SIZE * self.old.sizes.max(axis=1)
        if len(self.old) > 1:
            between = _gaps(self.old.places, self.old.places)
            np.fill_diagonal(between, np.inf)
            slack = np.minimum(slack, _OF_PITCH * between.min(axis=1))
        found: Floats = slack
        return found

    def nearest(self, k: int) -> list[int]:
        """Return the two nearest new holes, which the user can mean by an old one."""
        rows = np.flatnonzero(self.may[k])
        found: list[int] = rows[np.argsort(self.gaps[k, rows], kind="stable")][:2].tolist()
        return found

    def moved(self, explanation: _Explanation, rows: Ints) -> float:
        """Return the mean distance by which an explanation moves some old holes, mm."""
        rows = rows[explanation.pairs[rows] >= 0]
        return float(self.gaps[rows, explanation.pairs[rows]].mean())

    def explanations(self) -> Iterator[_Explanation]:
        """Yield an explanation for every start: rest, or a motion of the largest group."""
        at_rest = self._explained([])
        yield at_rest
        if not at_rest.edits:
            return
        everything = np.ones(len(self.old), bool), np.ones(len(self.new), bool)
        for motion in self._motions(*everything)[:_STARTS]:
            yield self._explained([motion])

    def _motions(self, old: Bools, new: Bools) -> list[Motion]:
        """Return the motions that map at least two free old holes to free new ones, best first."""
        rows, columns = np.flatnonzero(old), np.flatnonzero(new)
        if min(len(rows), len(columns)) < 2:
            return []
        places = self.old.places[rows], self.new.places[columns]
        axes = self.old.axes[rows], self.new.axes[columns]
        allowed = self.may[np.ix_(rows, columns)]
        motions = proposed_motions(places, axes, allowed, float(self.slack.min()))
        counted = [(len(self._placed(motion, old, new)[0]), motion) for motion in motions]
        kept = [(count, motion) for count, motion in counted if count > 1]
        kept.sort(key=lambda one: (-one[0], one[1].length(places[0])))
        return [motion for _, motion in kept]

    def _placed(self, motion: Motion | None, old: Bools, new: Bools) -> tuple[Ints, Ints]:
        """Return the free old holes that a motion, None for rest, maps to new ones, and these."""
        rows, columns = np.flatnonzero(old), np.flatnonzero(new)
        if not len(rows) or not len(columns):
            return rows[:0], columns[:0]
        places = self.old.places[rows]
        places = places if motion is None else motion.applied(places)
        gaps = _gaps(places, self.new.places[columns])
        gaps[~self.may[np.ix_(rows, columns)]] = np.inf
        nearest = gaps.argmin(axis=1)
        every = np.arange(len(rows))
        is_mutual = gaps.argmin(axis=0)[nearest] == every
        is_placed = (gaps[every, nearest] <= self.slack[rows]) & is_mutual
        return rows[is_placed], columns[nearest[is_placed]]

    def _explained(self, first: list[Motion]) -> _Explanation:
        """Match holes at rest, or after a given motion, then groups, then single holes."""
        pairs, groups = np.full(len(self.old), -1), np.zeros(len(self.old), dtype=int)

        def take(motion: Motion | None) -> None:
            rows, columns = self._placed(motion, *self._free(pairs))
            pairs[rows] = columns
            groups[rows] = 0 if motion is None else 1 + groups.max()

        for motion in [*first, None]:
            take(motion)
        for _ in range(_GROUPS):
            motions = self._motions(*self._free(pairs))
            if not motions:
                break
            take(motions[0])
        for k, j in self._singles(pairs):
            pairs[k], groups[k] = j, 1 + groups.max()
        old, new = self._free(pairs)
        edits = int(groups.max() + old.sum() + new.sum()) + self._resized(pairs)
        rows = np.flatnonzero(pairs >= 0)
        return _Explanation(pairs, groups, edits, float(self.gaps[rows, pairs[rows]].sum()))

    def _free(self, pairs: Ints) -> tuple[Bools, Bools]:
        new = np.ones(len(self.new), bool)
        new[pairs[pairs >= 0]] = False
        return pairs < 0, new

    def _singles(self, pairs: Ints) -> Iterator[tuple[int, int]]:
        """Yield single holes that moved less than half the distance to others, and their match."""
        old, new = self._free(pairs)
        for k in np.flatnonzero(old).tolist():
            free = np.flatnonzero(new & self.may[k])
            if len(free) and self._is_clear(k, j := int(free[self.gaps[k, free].argmin()])):
                new[j] = False
                yield k, j

    def _is_clear(self, k: int, j: int) -> bool:
        """Return whether a hole moved less than half the distance to any other one of both states.

        A hole that also changed its kind or size may move by half its size.
        """
        gap = self.gaps[k, j]
        others = np.delete(self.gaps[k], j)[np.delete(self.may[k], j)]
        before = np.delete(self.gaps[:, j], k)[np.delete(self.may[:, j], k)]
        limit = HALF * min([*others.tolist(), *before.tolist()], default=np.inf)
        if not self.same[k, j]:
            limit = min(limit, HALF * float(self.old.sizes[k].max()))
        return bool(gap <= limit)

    def _resized(self, pairs: Ints) -> int:
        """Count the different changes of kind or size among the matched holes."""
        rows = [k for k in np.flatnonzero(pairs >= 0) if not self.same[k, pairs[k]]]
        return len(
            {
                (self.old.kinds[k], self.new.kinds[pairs[k]], *_rounded(self.old.sizes[k]),
                 *_rounded(self.new.sizes[pairs[k]]))
                for k in rows
            }
        )  # fmt: skip


def _rounded(sizes: Floats) -> list[str]:
    return [f"{size:.3g}" for size in sizes]


def _gaps(first: Floats, second: Floats) -> Floats:
    found: Floats = np.linalg.norm(first[:, None, :] - second[None, :, :], axis=2)
    return found
