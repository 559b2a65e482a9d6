# SPDX-License-Identifier: LGPL-2.1-or-later
"""A selector on a changed part: it takes the same hole or face as before, or asks which one.

A selector that looks for the nearest thing may find a neighbour after a change. Here the thing it
took before is matched with the things of the changed part first, and its point moves along. What
cannot be matched is a question that names the candidates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from ..arrays import Floats, Ints
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

# Selectors that are a piece of space or a list: they cannot move along with what they took.
_STILL = (*VOLUMES, "vertices", "drawn")


@dataclass(frozen=True, eq=False)
class Followed:
    """where: the selector on the changed part; chosen: what it takes; told: sentences."""

    where: Any
    chosen: Chosen
    told: list[str] = field(default_factory=list)


class Following:
    """Two states of a part, and how many times as large the new one is."""

    def __init__(self, old: PartShape, new: PartShape, scale: float = 1.0):
        self.old, self.new, self.scale = old, new, scale

    @cached_property
    def holes(self) -> tuple[list[int], list[int]]:
        """The rows of the rims among the features of both states."""
        first, second = (
            [k for k, entry in enumerate(shape.features) if entry["kind"] in RIMMED]
            for shape in (self.old, self.new)
        )
        return first, second

    @cached_property
    def matches(self) -> dict[int, Match]:
        """By row of an old feature that is a rim: the row of the new one."""
        first, second = self.holes
        found = matched(
            _holes(self.old, first, self.scale), _holes(self.new, second, 1.0)
        )  # rows of both lists
        return {
            first[k]: Match(
                None if match.new is None else second[match.new],
                [second[j] for j in match.rivals],
                match.moved,
            )
            for k, match in enumerate(found)
        }

    def followed(self, before: Any, where: Any, answer: Floats | None = None) -> Followed:
        """Return a selector on the changed part that takes what it took before.

        Parameters
        ----------
        before, where
            The selector with the ids and lengths of the old state, and with those of the new one.
        answer
            (3,) the place of the thing that is meant where a match is not certain, mm.

        Raises
        ------
        Question
            What it took before has no certain match.
        SelectorError
            It takes nothing on one of the states.
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
        """Return the selector of the hole of the changed part that is nearest to a place."""
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
            return self._leaf(things, (before, where), work)
        except Question as question:
            return {**where, _point_key(where): plain(work.answered(question))}

    def _leaf(self, things: Any, pair: tuple[Any, Any], work: Work) -> Any:
        """A selector that looks for the nearest thing, its point moved to the match."""
        before, where = pair
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
        """The number or the kind of a thing, where a selector states it."""
        if "number" in where and new.number is not None:
            return {"number": new.number}
        if "found" in where and new.feature is not None:
            return {"found": self.new.features[new.feature]["kind"]}
        return {}

    def _match(self, old: Thing, olds: list[Thing], news: list[Thing]) -> tuple[Thing, float]:
        """The new thing that an old one is, and how far it moved, mm, 0 if it stayed."""
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
            return self._nearest(old, (olds, news), shift)
        return self._nearest(old, (self._outside(self.old, olds), self._outside(self.new, news)))

    def _hole_of(self, old: Thing) -> int | None:
        """The hole that a thing is or belongs to with all its vertices."""
        if old.feature is not None:
            return old.feature if old.feature in self.matches else None
        vertices = set(old.vertices.tolist())
        for row in self.matches:
            if vertices <= set(self.old.features[row]["vertices"]):
                return row
        return None

    def _outside(self, shape: PartShape, things: list[Thing]) -> list[Thing]:
        """The things that belong to no hole of a state, such as facets of its wall."""
        owner = np.full(len(shape.points), -1)
        for row in self.holes[0 if shape is self.old else 1]:
            owner[shape.features[row]["vertices"]] = row
        return [thing for thing in things if len({-1, *owner[thing.vertices].tolist()}) != 2]

    def _nearest(
        self,
        old: Thing,
        things: tuple[list[Thing], list[Thing]],
        shift: Floats = np.zeros(3),
    ) -> tuple[Thing, float]:
        """The thing of the same kind that lies clearly nearest to where an old one was."""
        olds, news = things
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
        """What to ask about an old hole without a certain match."""
        rivals = [self.new.features[j] for j in self.matches[row].rivals]
        return Question(self._text(row), [candidate_of(entry) for entry in rivals])

    def check(self, before: Ints, after: Ints) -> list[str]:
        """Return sentences on the holes that a region lost or won.

        Parameters
        ----------
        before, after
            Its vertices on the old state and on the new one.

        Raises
        ------
        Question
            It holds another hole in place of one that it held before, or an uncertain one.
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
        told = [f"it holds {text} now, and did not before" for text in won]
        return told + [f"it does not hold {self._text(row)} any more" for row in lost]

    def _text(self, row: int) -> str:
        return text_of(self.old.features[row])


def _point_key(where: Mapping[str, Any]) -> str:
    """The key of the point near which a selector looks."""
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
    """The thing that a selector takes on a part, without the rings around it."""
    alone = {key: value for key, value in where.items() if key not in ("rings", "holes", "count")}
    vertices = selected(shape, alone).vertices
    return next((one for one in things if np.array_equal(one.vertices, vertices)), None)


def _keys(where: Any) -> list[str]:
    """The keys of a selector and of those in it."""
    if isinstance(where, list):
        return [key for one in where for key in _keys(one)]
    key = key_of(where)
    inner = where[key] if key in JOINING else [where["of"]] if "of" in where else []
    return [key, *(name for one in inner for name in _keys(one))]


def _held(shape: PartShape, vertices: Ints) -> list[int]:
    """The rows of the holes that lie in a region with all their rims."""
    inside = np.zeros(len(shape.points), dtype=bool)
    inside[vertices] = True
    return [
        row
        for row, entry in enumerate(shape.features)
        if entry["kind"] in HOLES and inside[entry["vertices"]].all()
    ]
