# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notes of the report: recipe settings without effect, and the strain of steel."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..base.errors import Subject
from ..recipe.model import Model, PartEntry
from ..solving.preprocessed import Preprocessed
from .stretch import stretch_words

_MOST_BODIES = 5
_ALL, _REGIONS, _BOUNDARIES = 1, 2, 3


def notes_of(session: Preprocessed) -> list[str]:
    """Return a sentence for every setting of the recipe without effect."""
    model = session.model
    found = {"single": _single, "whole": _whole}.get(model.propagation.type, _local)(session)
    return [*_primary(model), *_thin(session), *_sheets(session), *found, *_joined(session)]


def _sheets(session: Preprocessed) -> Iterator[str]:
    model = session.model
    if model.energy == "steel" and model.refine:
        yield "refine has no effect: the energy steel is already more accurate"


def _joined(session: Preprocessed) -> Iterator[str]:
    """Yield notes on features and contacts that form one rigid body unintentionally."""
    declared = [
        {Subject("feature", name) for name in entry.features}
        for entry in session.model.relations
        if entry.type == "group"
    ]
    bodies = zip(session.joined_bodies, session.joined_subjects)
    joined = [labels for labels, subjects in bodies if subjects not in declared]
    for labels in joined[:_MOST_BODIES]:
        names = ", ".join(labels[:_MOST_BODIES])
        more = f" and {len(labels) - _MOST_BODIES} more" if len(labels) > _MOST_BODIES else ""
        yield f"{names}{more} form one rigid body, because they share vertices"
    if len(joined) > _MOST_BODIES:
        yield (
            f"{len(joined) - _MOST_BODIES} more sets of form features and rigid "
            "contacts form one rigid body each"
        )


def shape_notes(parts: list[dict[str, Any]]) -> Iterator[str]:
    """Yield sentences about the worst strain of steel; parts are the part entries of the report."""
    for entry in parts:
        if entry["steel"] is not None and entry["is_reached"]:
            yield from stretch_words(entry)


def _primary(model: Model) -> Iterator[str]:
    for part in model.parts:
        if part.name == model.primary and part.mode:
            yield f'mode {part.mode} of "{part.name}" has no effect: it is the primary part'


def _thin(session: Preprocessed) -> Iterator[str]:
    for part in session.model.parts:
        if part.thin == "auto" and session.thin_solid(part.name) is None:
            yield (
                f'thin "auto" of "{part.name}" has no effect: the part is not '
                "recognised as a thin solid"
            )


def _single(session: Preprocessed) -> Iterator[str]:
    model = session.model
    if model.contacts:
        yield "the contacts are ignored: a single control mesh drives every part"
    followed = {region.part for region in model.of_kind("follower")}
    featured = {region.part for region in model.of_kind("feature")}
    for part in model.parts:
        if part.name not in followed:
            continue
        if part.name == model.primary:
            yield f'the followers on "{part.name}" have no effect: it is the primary part'
        elif (mode := part.mode or (_BOUNDARIES if part.name in featured else _ALL)) != _REGIONS:
            driven = "every vertex" if mode == _ALL else "its unconstrained boundary"
            yield (
                f'the followers on "{part.name}" have no effect: the single control mesh drives '
                f"{driven} (mode {mode}); mode 2 drives the followers"
            )


def _whole(session: Preprocessed) -> Iterator[str]:
    model = session.model
    for part in model.parts:
        if part.mode and part.name != model.primary:
            lead = f'mode {part.mode} of "{part.name}" has no effect'
            yield f'{lead}: the propagation "whole" solves all parts together'
    for name in sorted({region.part for region in model.of_kind("follower")}):
        yield (
            f'the followers on "{name}" have no effect: the propagation "whole" '
            "solves all parts together"
        )


def _local(session: Preprocessed) -> Iterator[str]:
    kinds = {contact.name: contact.type for contact in session.model.contacts}
    for part in session.model.parts:
        if part.name == session.model.primary or not part.mode:
            continue
        into = [name for name, _, target in session.directions if target == part.name]
        yield from _mode(part, {name: kinds[name] for name in into})


def _mode(part: PartEntry, into: dict[str, str]) -> Iterator[str]:
    """Compare the mode of a part with the types of the contacts that drive it, by name."""
    lead = f'mode {part.mode} of "{part.name}" has no effect'
    if not into:
        yield f"{lead}: no contact drives the part"
    for name, kind in into.items():
        if (part.mode == _BOUNDARIES and kind != "control mesh") or (
            part.mode == _ALL and kind == "rigid"
        ):
            yield f'{lead} on the {kind} contact "{name}": it drives its own side of the part'
