# SPDX-License-Identifier: LGPL-2.1-or-later
"""Warnings about results that the user probably does not want; a strict run fails on them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..base.arrays import Ints
from ..base.errors import Caution, Subject
from ..base.words import at_place, counted, folds
from ..decks import is_deck
from ..files import unpacked_name
from ..recipe.model import Model
from ..solving.answer import Answer
from ..solving.preprocessed import Preprocessed
from ..solving.results import ContactResult
from .lost_turns import lost_turns
from .regions import region_remarks
from .thin_solids import crossed_anew

UNREACHED, OPEN_CONTACT, FLIPPED = "unreached", "open contact", "flipped"
# Code, problem and remedy.
_Shape = tuple[str, str, str]

# Limits for the gap change of a contact: a share of the gap at rest and a share of the region size.
# A gap below the last share of the region size counts as zero.
_OF_GAP, _OF_REGION, _NOTHING = 0.5, 0.1, 1e-3
# Relative change of thickness above which a warning follows.
_THINNED = 0.1
# Relative change of edge length above which a warning follows.
_STRAIN = 0.5


def warnings_of(result: Answer, parts: list[dict[str, Any]]) -> list[Caution]:
    """Return all warnings of a result; parts are the part entries of the report."""
    session = result.session
    return [
        *region_remarks(session),
        *_unreached(session),
        *_loose(session),
        *_unheld_primary(session),
        *_lost_decks(session),
        *_open_contacts(result),
        *unsettled(parts),
        *(text for entry in parts for text in _misshapen(result, entry)),
        *lost_turns(result),
        *_thinned(parts),
        *_unrepaired(result),
    ]


def unsettled(parts: list[dict[str, Any]]) -> list[Caution]:
    """Return a warning for every part entry of a report whose solve did not converge."""
    return [
        Caution(
            part["unsettled"],
            Subject("part", part["name"]),
            code="unsettled",
            todo="move its handles less, or use a finer mesh",
            where=f'"{part["name"]}"',
        )
        for part in parts
        if part["unsettled"] is not None
    ]


def open_contacts(result: Answer) -> dict[str, Caution]:
    """Return a warning for every contact whose gap changes too much.

    Parameters
    ----------
    result : Answer or Result
        Exact result of ``Session.deform``.

    Returns
    -------
    dict
        Contact name to its Caution; the text gives the gap change and its limit in mm, and a
        remedy.
    """
    found = {}
    for contact in result.contacts:
        limit, of_what = _limit(result.session, contact)
        if contact.gap_change > limit:
            where = "" if contact.place is None else f" at {at_place(contact.place)}"
            found[contact.name] = Caution(
                f'the gap of "{contact.name}" changes by {contact.gap_change:.2g} '
                f"mm{where} (allowed {limit:.2g} mm, {of_what})",
                Subject("contact", contact.name),
                code=OPEN_CONTACT,
                todo=_todo(contact, result.session.model),
            )
    return found


def _open_contacts(result: Answer) -> Iterator[Caution]:
    yield from open_contacts(result).values()


def _todo(contact: ContactResult, model: Model) -> str:
    if model.propagation.type == "single":
        return 'set the propagation to "local" or "whole", which keep contacts, or move less'
    if contact.type == "control mesh" and model.propagation.type != "whole":
        return "make it tied or rigid, or split it into smaller regions"
    if contact.type != "rigid":
        return "make it rigid, split it into smaller regions, or move the handle less"
    return "check the constraints of both parts"


def _limit(session: Preprocessed, contact: ContactResult) -> tuple[float, str]:
    """Return the admissible gap change of a contact, mm, and the reason for this limit."""
    region = contact.region_size
    limits = [(_OF_REGION * region, "a tenth of its size")]
    gap = session.contact_gap(contact.name).middle
    if gap > _NOTHING * region:
        limits.append((_OF_GAP * gap, f"half its gap of {gap:.2g} mm"))
    for part in (contact.source, contact.target):
        solid = session.thin_solid(part)
        if solid is not None:
            limits.append((solid.thickness, f'the thickness of "{part}"'))
    limit, why = min(limits)
    return max(limit, _NOTHING * region), why


def _loose(session: Preprocessed) -> Iterator[Caution]:
    for part, (pieces, vertices) in session.loose_pieces.items():
        where = at_place(session.loose_places[part])
        number = counted(pieces, "piece", "pieces")
        what = f'{number} of "{part}" ({vertices} vertices, one at {where}) '
        does, todo = "move along with the nearest constrained place", ""
        if session.model.unheld != "along":
            does, todo = "stay at rest", (
                "mark a fixed region or a handle on them, split them into parts "
                '("split": true) and add contacts, or set "unheld" to "along"'
            )
        yield _of_part(part, "loose", f"{what}are unconstrained and {does}", todo)


def _unheld_primary(session: Preprocessed) -> Iterator[Caution]:
    model, primary = session.model, session.model.primary
    movers = [e for k in ("handle", "point") for e in model.of_kind(k) if e.part == primary]
    others = {entry.part for entry in model.of_kind("fixed")} - {primary, *session.unreached}
    if primary and others and len(movers) == 1 and not session.is_held(primary):
        names = ", ".join(f'"{name}"' for name in sorted(others))
        yield _of_part(
            primary,
            "unheld primary",
            f'the primary part "{primary}" has no fixed region: it moves as one '
            f"rigid piece, and the fixed regions on {names} stretch the parts between",
            'set the propagation to "whole", which solves all parts at once, or mark a fixed '
            "region on the primary part too",
        )


def _lost_decks(session: Preprocessed) -> Iterator[Caution]:
    """Warn about decks for which only a mesh is written, without their joints."""
    files = {part.file: part for part in session.model.parts if part.wanted and part.file}
    for file, part in files.items():
        if is_deck(unpacked_name(file)):
            yield _of_part(
                part.name,
                "lost deck",
                f'the deck "{file}" is written as OBJ, because "scale", "weld" or '
                '"remesh" makes a new mesh without elements, joints and includes',
                f'remove these keys from "{part.where}" to write a deck',
            )


def _unrepaired(result: Answer) -> Iterator[Caution]:
    for one in result.repairs:
        if one["failing_after"]:
            yield _of_part(
                one["part"],
                "unrepaired",
                f"{counted(one['failing_after'], 'element', 'elements')} of "
                f'"{one["part"]}" still fail the criteria {one["criteria"]} after '
                f"repair ({one['failing_before']} before): the repair does not move "
                "nodes of features, contacts, regions, joints and borders",
            )


def _unreached(session: Preprocessed) -> Iterator[Caution]:
    held = {entry.part for entry in session.model.of_kind("fixed")}
    for part in session.unreached:
        if part not in held:
            yield Caution(
                f'no motion reaches "{part}", so it stays at rest',
                Subject("part", part),
                code=UNREACHED,
                todo="join it to the others with a contact, mark a fixed region on it, or leave "
                "it out",
            )


def _thinned(parts: list[dict[str, Any]]) -> Iterator[Caution]:
    for entry in parts:
        thin = entry["thin"]
        change = max(thin["largest_change"], thin["largest_change_at_walls"]) if thin else 0.0
        if change > _THINNED:
            worst = thin["worst"]
            place = ", ".join(f"{x:.4g}" for x in worst["place"])
            yield _of_part(
                entry["name"],
                "thinned",
                f'the thickness of "{entry["name"]}" changes by {100.0 * change:.0f} % '
                f"at ({place}), from {worst['rest']:.3g} to {worst['deformed']:.3g} mm",
                "move less, mesh it finer there, or mark small details there as a form feature",
            )


def _misshapen(result: Answer, entry: dict[str, Any]) -> Iterator[Caution]:
    """Warn about the mesh of a part in this pose; entry is its part entry in the report."""
    for shape in _misshapes(result, entry):
        yield _of_part(entry["name"], *shape)


def _of_part(name: str, code: str, text: str, todo: str = "") -> Caution:
    return Caution(text, Subject("part", name), code=code, todo=todo)


def _misshapes(result: Answer, entry: dict[str, Any]) -> Iterator[_Shape]:
    name, quality = entry["name"], entry["quality"]
    if quality["flipped"]:
        where = f' of "{name}"'
        yield (
            FLIPPED,
            f"{folds(quality['flipped'], where)} onto a neighbour in this pose, at "
            f"{at_place(quality['flipped_place'])}",
            "remesh it, mark slivers as a form feature, or turn it less",
        )
    yield from _squeezed(name, quality)
    yield from _crossing(result, name)
    tear = result.session.cuts(name).tear(result.positions[name])
    if tear is not None:
        yield (
            "cut",
            f'"{name}" is cut: {counted(tear.vertices, "vertex", "vertices")} '
            f"separate from others at the same place, by up to {tear.width:.3g} mm "
            f"at {at_place(tear.place)}; nothing joins the two sides",
            'set "weld" to merge them',
        )


def _crossing(result: Answer, name: str) -> Iterator[_Shape]:
    triangles, places = result.session.meshes[name].triangles, result.positions[name]

    def where(pairs: Ints) -> str:
        number = counted(len(pairs), "pair", "pairs")
        return f"{at_place(places[triangles[pairs[0, 0]]].mean(axis=0))} ({number} of triangles)"

    found, drawn = crossed_anew(result, name), result.session.rest_crossings(name)
    if len(found):
        yield (
            "penetrates itself",
            f'"{name}" penetrates itself in this pose, at {where(found)}',
            "turn it less, or remesh it with shorter edges",
        )
    if len(drawn) and any(part.name == name and part.thin for part in result.session.model.parts):
        yield (
            "penetrates itself at rest",
            f'"{name}" penetrates itself at rest, at {where(drawn)}: it bends there '
            "as one surface, without a valid thickness",
            "separate it in CAD",
        )


def _squeezed(name: str, quality: dict[str, Any]) -> Iterator[_Shape]:
    worst, shortest = quality["worst_edge"], quality["shortest_edge"]
    if quality["collapsed_edges"]:
        yield (
            "collapsed",
            f'{counted(quality["collapsed_edges"], "edge", "edges")} of "{name}" '
            f"{('collapses', 'collapse')[quality['collapsed_edges'] > 1]} to less than a tenth of "
            f"the length, from {shortest['before']:.3g} to {shortest['after']:.3g} mm at "
            f"{at_place(shortest['place'])}",
            "move less, or remesh it",
        )
    elif quality["crushed_place"]:
        yield (
            "crushed",
            f'a triangle of "{name}" loses its height in this pose, at '
            f"{at_place(quality['crushed_place'])}",
            "move less, or remesh it",
        )
    is_told = quality["collapsed_edges"] and worst == shortest
    if worst is not None and quality["worst_strain"] > _STRAIN and not is_told:
        yield (
            "stretched",
            f'an edge of "{name}", {worst["before"]:.3g} mm long, changes its '
            f"length by {100.0 * quality['worst_strain']:.0f} % at "
            f"{at_place(worst['place'])} in this pose",
            "move less, remesh it, or mark small details there as a form feature",
        )
