# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a morph does that is likely not wanted, and what to do; a strict run fails for it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from .answer import Answer
from .decks import is_deck
from .files import unpacked_name
from .lost_turns import lost_turns
from .preprocessed import Preprocessed
from .recipe.model import Model
from .regions_report import region_remarks
from .results import ContactResult
from .words import counted

# How far a contact may open: of the gap at rest, of the region; below the last share it is nothing.
_OF_GAP, _OF_REGION, _NOTHING = 0.5, 0.1, 1e-3
# From which a thickness changes too much, of the one at rest.
_THINNED = 0.1
# From which an edge is stretched or pressed by too much: half its length.
_STRAIN = 0.5


def warnings_of(result: Answer, parts: list[dict[str, Any]]) -> list[str]:
    """One sentence each; parts: as the report tells them."""
    session = result.session
    return [
        *region_remarks(session),
        *_loose(session),
        *_unheld_primary(session),
        *_lost_decks(session),
        *_open_contacts(result),
        *unsettled(parts),
        *_stretched(parts),
        *lost_turns(result),
        *_thinned(parts),
        *_unrepaired(result),
    ]


def unsettled(parts: list[dict[str, Any]]) -> list[str]:
    """A sentence for every part of a report whose solution did not converge."""
    return [
        f'"{part["name"]}": {part["unsettled"]}; move its handles less, or take a finer mesh'
        for part in parts
        if part["unsettled"] is not None
    ]


def open_contacts(result: Answer) -> dict[str, str]:
    """By the name of every contact that opens or closes too far: by what, and what to do."""
    found = {}
    for contact in result.contacts:
        limit, of_what = _limit(result.session, contact)
        if contact.gap_change > limit:
            found[contact.name] = (
                f'"{contact.name}" opens or closes by {contact.gap_change:.2g} mm, beyond '
                f"{limit:.2g} mm, {of_what}: {_todo(contact, result.session.model)}"
            )
    return found


def _open_contacts(result: Answer) -> Iterator[str]:
    yield from open_contacts(result).values()


def _todo(contact: ContactResult, model: Model) -> str:
    if contact.type == "control mesh" and model.propagation.type != "whole":
        return "make it tied or rigid, or split it into smaller regions"
    if contact.type != "rigid":
        return "make it rigid, split it into smaller regions, or move the handle less"
    return "look at what holds both parts"


def _limit(session: Preprocessed, contact: ContactResult) -> tuple[float, str]:
    """How far a contact may open, mm, and why no farther."""
    region = contact.region_size
    limits = [(_OF_REGION * region, "a tenth of its region")]
    gap = session.rest_gap(contact.name)
    if gap > _NOTHING * region:
        limits.append((_OF_GAP * gap, f"half its gap of {gap:.2g} mm"))
    for part in (contact.source, contact.target):
        solid = session.thin_solid(part)
        if solid is not None:
            limits.append((solid.thickness, f'the thickness of "{part}"'))
    limit, why = min(limits)
    return max(limit, _NOTHING * region), why


def _loose(session: Preprocessed) -> Iterator[str]:
    for part, (pieces, vertices) in session.loose_pieces.items():
        what = f'{counted(pieces, "piece", "pieces")} of "{part}" ({vertices} vertices) that '
        if session.model.unheld == "along":
            yield what + "nothing holds go along with the nearest place of the others"
        else:
            yield (
                what + "nothing holds stay at rest: mark a fixed region or a handle on them, make "
                'parts of them ("split": true) with contacts, or set "unheld" to "along"'
            )


def _unheld_primary(session: Preprocessed) -> Iterator[str]:
    model, primary = session.model, session.model.primary
    movers = [e for k in ("handle", "point") for e in model.of_kind(k) if e.part == primary]
    others = {entry.part for entry in model.of_kind("fixed")} - {primary, *session.unreached}
    if primary and others and len(movers) == 1 and not session.is_held(primary):
        names = ", ".join(f'"{name}"' for name in sorted(others))
        yield (
            f'nothing of its own holds the primary part "{primary}": it moves as one piece, and '
            f"what is fixed on {names} stretches the parts between; set the propagation to "
            '"whole", which solves all parts at once, or fix some of the primary too'
        )


def _lost_decks(session: Preprocessed) -> Iterator[str]:
    """Decks of which a mesh is written, with their joints gone."""
    files = {part.file: part for part in session.model.parts if part.wanted and part.file}
    for file, part in files.items():
        if is_deck(unpacked_name(file)):
            yield (
                f'"{file}" is a deck, but OBJ is written: scale, weld and remesh make another '
                f'mesh, without elements, joints and includes; leave them out of "{part.where}"'
            )


def _unrepaired(result: Answer) -> Iterator[str]:
    for one in result.repairs:
        if one["failing_after"]:
            yield (
                f'{counted(one["failing_after"], "element", "elements")} of "{one["part"]}" still '
                f"miss the criteria {one['criteria']} after repair ({one['failing_before']} before "
                "it): nodes of features, contacts, regions, joints and borders stay where they are"
            )


def _stretched(parts: list[dict[str, Any]]) -> Iterator[str]:
    for entry in parts:
        strain = entry["quality"]["worst_strain"]
        if strain is not None and strain > _STRAIN:
            yield (
                f'an edge of "{entry["name"]}" changes its length by {100.0 * strain:.0f} % in '
                "this pose: move less, remesh it, or hold what is small there in a form feature"
            )


def _thinned(parts: list[dict[str, Any]]) -> Iterator[str]:
    for entry in parts:
        thin = entry["thin"]
        change = max(thin["largest_change"], thin["largest_change_at_walls"]) if thin else 0.0
        if change > _THINNED:
            worst = thin["worst"]
            place = ", ".join(f"{x:.4g}" for x in worst["place"])
            yield (
                f'the thickness of "{entry["name"]}" changes by {100.0 * change:.0f} % at '
                f"({place}), from {worst['rest']:.3g} to {worst['deformed']:.3g} mm: move less, "
                "mesh it finer there, or hold what is small there in a form feature"
            )
