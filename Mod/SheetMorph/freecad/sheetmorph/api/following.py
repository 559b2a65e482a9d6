# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transfer of regions and contact sides to a changed mesh of their part, or a question."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import conversion, selecting
from freecad.sheetmorph.bridge.rest import Kept, read_kept
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.tools import sentences

MOST_SHOWN = 4
# questions of the last Unbound, because FreeCAD keeps only the text of an error
_asked: dict[str, dict] = {}


class Unbound(ValueError):
    """Regions whose hole or face has no certain match on the changed part.

    `unbound` maps the name of an object (with `.a` or `.b` for a contact side) to a dict. It has
    `label`, `was`, a sentence, and `candidates`, each with `text` and `place` (mm, in file
    coordinates). `bindings` accepts a position or a selector as the answer.
    """

    def __init__(self, part, unbound: dict[str, dict]):
        self.unbound = unbound
        _asked.update(unbound)
        told = [spoken(one) for one in unbound.values()][:MOST_SHOWN]
        more = len(unbound) - len(told)
        told += [f"{more} more"] if more else []
        names = ", ".join(f"'{name}': [x, y, z]" for name in list(unbound)[:MOST_SHOWN])
        super().__init__(
            f"'{part.Label}' changed too much for a certain match: {'; '.join(told)}. "
            f"Pass bindings={{{names}}} with the right places, or delete the region first."
        )


def asked() -> dict[str, dict]:
    """Return the questions since `forget`, in the form of `Unbound.unbound`."""
    return dict(_asked)


def forget() -> None:
    """Clear the list of questions."""
    _asked.clear()


def spoken(asked: dict) -> str:
    """Return one question as a sentence."""
    texts = [one["text"] for one in asked["candidates"]]
    if not texts:
        return f"'{asked['label']}' was {asked['was']}, which is gone"
    return f"'{asked['label']}' was {asked['was']}; it may be {' or '.join(texts)} now"


@dataclass(frozen=True)
class Change:
    """A changed mesh of a part.

    placed maps old vertices to it. made is the mesh in file coordinates, and scale its size
    relative to the old one. bindings has the user's answers by object name.
    """

    placed: Any
    made: Any
    scale: float = 1.0
    bindings: dict[str, Any] = field(default_factory=dict)


def moved_vertices(
    part, change: Change, told: dict[str, str]
) -> list[tuple[Any, str, np.ndarray, str]]:
    """Return the picked regions on the new mesh: object, side, vertices, selector.

    The dict `told` receives a sentence, by object name, for each region that changed. Raises
    Unbound, a ValueError, for an uncertain match, and ValueError if a region would lose all
    vertices.
    """
    assembly = assembly_of(part)
    found = [(region, "") for region in model.regions(assembly, part)]
    for contact in model.contacts(assembly, part):
        sides = (("a", contact.PartA), ("b", contact.PartB))
        found += [(contact, side) for side, owner in sides if owner == part]
    follower = Follower(part, change)
    moved, unbound = [], {}
    for owner, side in found:
        try:
            vertices, where, text = follower.followed(owner, side)
        except follower.question as asked:
            candidates = [{"text": one.text, "place": one.place} for one in asked.candidates]
            entry = {"label": owner.Label, "was": asked.was, "candidates": candidates}
            unbound[name_of(owner, side)] = entry
            continue
        if len(vertices) == 0:
            raise ValueError(f"'{owner.Label}' has no place on the new mesh; delete it first.")
        told |= {owner.Name: text} if text else {}
        moved.append((owner, side, vertices, where))
    if unbound:
        raise Unbound(part, unbound)
    return moved


def keep_moved(moved: list) -> None:
    """Store the result of `moved_vertices` in regions and contact sides."""
    for owner, side, vertices, where in moved:
        if side:
            model.set_contact_vertices(owner, side, vertices, where)
        else:
            model.set_vertices(owner, vertices, where)


def name_of(owner, side: str) -> str:
    """Return the key of an object, or of one side of it, in `bindings`."""
    return f"{owner.Name}.{side}" if side else owner.Name


class Follower:
    """The search for the picked regions of a part on its changed mesh."""

    def __init__(self, part, change: Change):
        self.change = change
        frame = replace(read_kept(part).frame, origin=conversion.near_origin(change.made.points))
        labels = change.made.with_indices().labels
        kept = Kept(change.made.points, change.made.triangles, None, frame, [], True, labels)
        self.states = selecting.following_of(part, kept, change.scale)
        self.question = selecting.question_type()

    def followed(self, owner, side: str) -> tuple[np.ndarray, str, str]:
        """Return vertices, selector and differences of a region; raise Question of the package."""
        before = selecting.sentence_of(owner, side)
        answer = self.answer(owner, side)
        if isinstance(answer, (dict, list)) and selecting.is_selector(answer):
            return selecting.chosen_on(self.states.new, answer).vertices, json.dumps(answer), ""
        answer = None if answer is None else place_of(answer, owner)
        if before is None:
            return self.nearest(owner, side, answer)
        said = sentences.scaled(before, self.change.scale)
        where = sentences.with_moved_ids(said, lambda ids: self.change.placed.find(ids)[0].tolist())
        try:
            found = self.states.followed(before, where, answer)
            text = selecting.followed_text(owner.Label, self.states, before, found)
        except self.question:
            raise
        except ValueError as error:
            vertices, where, _ = self.nearest(owner, side, answer)
            return (
                vertices,
                where,
                f"'{owner.Label}' keeps its vertices without a selector: {error}.",
            )
        return found.chosen.vertices, json.dumps(found.where), text

    def answer(self, owner, side: str) -> Any:
        """Return the user's answer for an object, or None."""
        bindings = self.change.bindings
        return bindings.get(name_of(owner, side), bindings.get(owner.Label))

    def nearest(self, owner, side: str, answer) -> tuple[np.ndarray, str, str]:
        """Return the nearest vertices for an object without a selector.

        Raises Question if they do not contain the same holes.
        """
        old = model.contact_vertices(owner, side) if side else model.vertices(owner)
        vertices, _ = self.change.placed.find(old)
        if answer is not None:
            where = self.states.hole_at(answer)
            return selecting.chosen_on(self.states.new, where).vertices, json.dumps(where), ""
        told = self.states.check(old, vertices)
        return vertices, "", f"'{owner.Label}': {'; '.join(told)}." if told else ""


def place_of(answer, owner) -> np.ndarray:
    """Return the position that the user gave as an answer, or raise ValueError."""
    place = np.asarray(answer, dtype=float)
    if place.shape != (3,) or not np.isfinite(place).all():
        raise ValueError(
            f"The binding of '{owner.Label}' is neither a place [x, y, z] nor a selector."
        )
    return place
