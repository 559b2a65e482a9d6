# SPDX-License-Identifier: LGPL-2.1-or-later
"""A selector on a changed part: it selects the same hole or face as before, or raises a question.

A selector for the nearest item could find a neighbour after a change. Therefore the item that it
selected before is matched with the items of the changed part, and its point moves along. A question
lists the candidates if there is no certain match.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..finding.options import HOLES
from .chosen import Chosen, SelectorError
from .correspondence import HALF, Holes, Match, matched
from .grammar import JOINING, key_of
from .looked_up import RIMMED
from .part_shape import PartShape
from .questions import Candidate, Question, Work, candidate_of, plain
from .resolving import selected
from .things import Thing, text_of, things_of
from .volumes import VOLUMES

# Selectors for a volume or a list; they do not move with the items that they selected.
_STILL = (*VOLUMES, "vertices", "drawn")


@dataclass(frozen=True, eq=False)
class Followed:
    """The selector on the changed part, the region that it selects, and sentences for the user."""

    where: Any
    chosen: Chosen
    told: list[str] = field(default_factory=list)


class Following:
    """Two states of a part, and the scale of the new one relative to the old one."""

    def __init__(self, old: PartShape, new: PartShape, scale: float = 1.0):
        self.old, self.new, self.scale = old, new, scale

    @cached_property
    def holes(self) -> tuple[list[int], list[int]]:
        """Rows of the rims among the features of both states."""
        first, second = (
            [k for k, entry in enumerate(shape.features) if entry["kind"] in RIMMED]
            for shape in (self.old, self.new)
        )
        return first, second

    @cached_property
    def matches(self) -> dict[int, Match]:
        """The matches of all rims, by row of the old feature."""
        first, second = self.holes
        found = matched(
            _holes(self.old, first, self.scale), _holes(self.new, second, 1.0)
        )  # rows in first and second
        return {
            first[k]: Match(
                None if match.new is None else second[match.new],
                [second[j] for j in match.rivals],
                match.moved,
            )
            for k, match in enumerate(found)
        }

    def followed(self, before: Any, where: Any, answer: Floats | None = None) -> Followed:
        """Return a selector on the changed part for the items that it selected before.

        Parameters
        ----------
        before, where : selector
            The selector with ids and lengths of the old state, and of the new one.
        answer : array (3,), optional
            Position of the intended item if a match is uncertain, mm.

        Returns
        -------
        Followed
            The selector, its region and remarks.

        Raises
        ------
        Question
            If an item has no certain match.
        SelectorError
            If it selects nothing in one of the states.
        """
        work = Work(answer)
        moved = self._moved(before, where, work)
        if work.is_still or any(key in _STILL for key in _keys(moved)):
            taken = selected(self.old, before).vertices, selected(self.new, moved).vertices
            try:
                work.told += self.check(*taken)
            except Question as question:
                moved = self.hole_at(work.answered(question))
        return Followed(moved, selected(self.new, moved), list(dict.fromkeys(work.told)))

    def hole_at(self, place: Floats) -> dict[str, Any]:
        """Return the selector for the hole of the changed part nearest to a point."""
        entries = [self.new.features[row] for row in self.holes[1]]
        gaps = [float(np.linalg.norm(np.array(one["center"]) - place)) for one in entries]
        if not gaps:
            raise SelectorError(f'"{self.new.name}" has no hole', "use a selector")
        return {"found": entries[int(np.argmin(gaps))]["kind"], "near": plain(place)}

    def _moved(self, before: Any, where: Any, work: Work) -> Any:
        if isinstance(where, list):
            return [self._moved(*pair, work) for pair in zip(before, where)]
        key = key_of(where)
        if key in JOINING:
            return {**where, key: self._moved(before[key], where[key], work)}
        if "of" in where:
            return {**where, "of": self._moved(before["of"], where["of"], work)}
        things = things_of(key, where)
        if things is None:
            return where
        try:
            return self._leaf(things, before, where, work)
        except Question as question:
            return {**where, _point_key(where): plain(work.answered(question))}

    def _leaf(self, things: Any, before: Any, where: Any, work: Work) -> Any:
        """Return a nearest-item selector with its point moved to the matched item."""
        olds, news = things(self.old, before), things(self.new, where)
        old = _taken(self.old, olds, before)
        if old is None:
            work.is_still = True
            return where
        new, moved = self._match(old, olds, news)
        if moved > 0.0:
            work.told.append(f"{old.text} moved by {moved:.4g} mm")
        key = _point_key(where)
        first = np.array(where[key], dtype=float)
        for place in (first, first + new.place - self.scale * old.place, *new.points(first)):
            leaf = {**where, **self._renamed(where, new)}
            if place is not first:
                leaf[key] = plain(place)
            if _taken(self.new, news, leaf) is new:
                return leaf
        raise Question(old.text, [Candidate(new.text, plain(new.place))])

    def _renamed(self, where: Mapping[str, Any], new: Thing) -> dict[str, Any]:
        """Return the new number or kind of an item if the selector gives one."""
        if "number" in where and new.number is not None:
            return {"number": new.number}
        if "found" in where and new.feature is not None:
            return {"found": self.new.features[new.feature]["kind"]}
        return {}

    def _match(self, old: Thing, olds: list[Thing], news: list[Thing]) -> tuple[Thing, float]:
        """Return the new item for an old one, and its displacement, mm, 0 if it stayed."""
        of_hole = self._hole_of(old)
        if of_hole is not None:
            row, match = of_hole, self.matches[of_hole]
            if match.new is None:
                raise self.question(row)
            same = [thing for thing in news if thing.feature == match.new]
            if old.feature == row and same:
                is_far = match.moved > 1e-3 * self.new.size
                return same[0], match.moved if is_far else 0.0
            entries = self.old.features[row], self.new.features[match.new]
            shift = np.array(entries[1]["center"]) - self.scale * np.array(entries[0]["center"])
            return self._nearest(old, olds, news, shift)
        return self._nearest(old, self._outside(self.old, olds), self._outside(self.new, news))

    def _hole_of(self, old: Thing) -> int | None:
        """Return the row of the hole that contains all vertices of an item, or None."""
        if old.feature is not None:
            return old.feature if old.feature in self.matches else None
        vertices = set(old.vertices.tolist())
        for row in self.matches:
            if vertices <= set(self.old.features[row]["vertices"]):
                return row
        return None

    def _outside(self, shape: PartShape, things: list[Thing]) -> list[Thing]:
        """Return the items that do not belong to a hole, such as the facets of its wall."""
        owner = np.full(len(shape.points), -1)
        for row in self.holes[0 if shape is self.old else 1]:
            owner[shape.features[row]["vertices"]] = row
        return [thing for thing in things if len({-1, *owner[thing.vertices].tolist()}) != 2]

    def _nearest(
        self,
        old: Thing,
        olds: list[Thing],
        news: list[Thing],
        shift: Floats = np.zeros(3),
    ) -> tuple[Thing, float]:
        """Return the item of the same kind that is clearly nearest to the old position."""
        like = [thing for thing in news if old.may_be(thing, self.scale)]
        gaps = [thing.gap(self.scale * old.samples + shift) for thing in like]
        order = np.argsort(gaps, kind="stable").tolist()
        slack = 1e-3 * self.new.size
        if not order:
            raise Question(old.text, [])
        new, gap = like[order[0]], gaps[order[0]]
        limit = HALF * gaps[order[1]] if len(order) > 1 else np.inf
        before = [thing for thing in olds if thing.may_be(new, self.scale)]
        back = [thing.gap((new.samples - shift) / self.scale) for thing in before]
        here = old.gap((new.samples - shift) / self.scale)
        is_mutual = here <= min(back) + slack / self.scale
        if gap > slack and not (gap <= limit and is_mutual):
            named = [Candidate(like[k].text, plain(like[k].place)) for k in order[:2]]
            raise Question(old.text, named)
        return new, gap if gap > slack else 0.0

    def question(self, row: int) -> Question:
        """Return the question about an old hole without a certain match."""
        rivals = [self.new.features[j] for j in self.matches[row].rivals]
        return Question(self._text(row), [candidate_of(entry) for entry in rivals])

    def check(self, before: Ints, after: Ints) -> list[str]:
        """Return sentences on the holes that a region lost or gained.

        Parameters
        ----------
        before, after : array (k,), int
            Vertices of the region in the old state, and in the new one.

        Returns
        -------
        list of str
            The sentences.

        Raises
        ------
        Question
            If the region contains another hole in place of an old one, or if a match is uncertain.
        """
        olds = [row for row in _held(self.old, before) if row in self.matches]
        news = _held(self.new, after)
        images: dict[int, int] = {}
        for row in olds:
            match = self.matches[row].new
            if match is None:
                raise self.question(row)
            images[row] = match
        taken = {m.new for row, m in self.matches.items() if row not in images}
        taken.update(j for m in self.matches.values() if m.new is None for j in m.rivals)
        others = [j for j in news if j in taken]
        lost = [row for row, j in images.items() if j not in news]
        if images and (others or len(lost) == len(images)):
            row = [*lost, *olds][0]
            raise Question(self._text(row), [candidate_of(self.new.features[images[row]])])
        won = [text_of(self.new.features[j]) for j in others]
        told = [f"it now contains {text}, which it did not before" for text in won]
        return told + [f"it no longer contains {self._text(row)}" for row in lost]

    def _text(self, row: int) -> str:
        return text_of(self.old.features[row])


def _point_key(where: Mapping[str, Any]) -> str:
    """Return the key of the point of a nearest-item selector."""
    return "near" if "near" in where else key_of(where)


def _holes(shape: PartShape, rows: list[int], scale: float) -> Holes:
    entries = [shape.features[row] for row in rows]
    sizes = [_sizes(entry) for entry in entries]
    return Holes(
        [entry["kind"] for entry in entries],
        scale * np.array([entry["center"] for entry in entries], dtype=float).reshape(-1, 3),
        np.array([entry["axis"] for entry in entries], dtype=float).reshape(-1, 3),
        scale * np.array(sizes, dtype=float).reshape(-1, 2),
    )


def _sizes(entry: Mapping[str, Any]) -> tuple[float, float]:
    diameter = 2.0 * entry.get("radius", 0.0)
    length, width = entry.get("length", diameter), entry.get("width", diameter)
    return max(length, width), min(length, width)


def _taken(shape: PartShape, things: list[Thing], where: Mapping[str, Any]) -> Thing | None:
    """Return the item that a selector selects on a part, without rings around it."""
    alone = {key: value for key, value in where.items() if key not in ("rings", "holes", "count")}
    vertices = selected(shape, alone).vertices
    return next((one for one in things if np.array_equal(one.vertices, vertices)), None)


def _keys(where: Any) -> list[str]:
    """Return the keys of a selector and of all selectors inside it."""
    if isinstance(where, list):
        return [key for one in where for key in _keys(one)]
    key = key_of(where)
    inner = where[key] if key in JOINING else [where["of"]] if "of" in where else []
    return [key, *(name for one in inner for name in _keys(one))]


def _held(shape: PartShape, vertices: Ints) -> list[int]:
    """Return the rows of the holes whose rims all lie in a region."""
    inside = np.zeros(len(shape.points), dtype=bool)
    inside[vertices] = True
    return [
        row
        for row, entry in enumerate(shape.features)
        if entry["kind"] in HOLES and inside[entry["vertices"]].all()
    ]
