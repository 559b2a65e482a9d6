# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of a mesh diagnosis: one sentence for each, and the cure that it offers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..base.words import counted, either
from ..base.file_unit import AS_GIVEN

# Share of the size of the mesh. With longer edges the mesh is too coarse to bend around features.
_COARSE = 0.05
# Percent of the triangles. Fewer slivers that do not fold do not justify a new mesh.
_MANY_SLIVERS = 5.0
# Part keys with which a deck is still written as a deck.
_OF_DECKS = frozenset(("split",))


def findings_of(diagnosis: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the findings of a diagnosis, the most important kind first.

    Each finding has the keys finding, count, text, cure and recipe. The cure is "weld", "orient",
    "remesh", "thin", "split", "scale" or None. The recipe holds the part keys that apply the cure,
    or None.
    """
    found = [*_seams(diagnosis), *_facets(diagnosis), *_shape(diagnosis)]
    return [
        {"finding": name, "count": count, "text": text, "cure": cure, "recipe": recipe}
        for name, count, text, cure, recipe in found
    ]


def missing_findings(missing: list[str]) -> list[dict[str, Any]]:
    """Return the findings for content that the reader skipped; see PartFile.missing."""
    keys = {"finding": "not read whole", "count": 1, "cure": None, "recipe": None}
    return [{**keys, "text": text} for text in missing]


def for_deck(findings: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the findings of a deck, without cures that need a new mesh."""
    return [
        finding
        if set(finding["recipe"] or ()) <= _OF_DECKS and finding["cure"] != "orient"
        else {**finding, "cure": None, "recipe": None}
        for finding in findings
    ]


def part_entry(findings: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the part keys that apply all cures together."""
    entry: dict[str, Any] = {}
    for finding in findings:
        entry |= finding["recipe"] or {}
    order = ("split", "scale", "weld", "remesh", "thin")
    return {key: entry[key] for key in order if key in entry}


_Found = tuple[str, int, str, "str | None", "dict[str, Any] | None"]


def _seams(diagnosis: dict[str, Any]) -> Iterator[_Found]:
    counts = diagnosis["counts"]
    weld = _in_mm(diagnosis, {"weld": diagnosis["tolerance"]})
    doubled = counts["duplicate_vertices"] + counts["near_duplicate_vertices"]
    if doubled:
        text = counted(doubled, "vertex lies", "vertices lie")
        text += " at nearly the same place as another: the mesh is cut there"
        closed = counts["open_edges"] - counts["open_edges_welded"]
        if closed > 0:
            text += f"; merging closes {closed} of {counts['open_edges']} open edges"
        yield "near-duplicate vertices", doubled, text, "weld", weld
    if counts["t_junctions"]:
        text = counted(counts["t_junctions"], "vertex lies", "vertices lie")
        text += " on an edge of other triangles"
        yield "T-junctions", counts["t_junctions"], text, "weld", weld
    if counts["open_edges_welded"]:
        text = counted(counts["open_edges_welded"], "open edge", "open edges")
        text += ": borders and holes of open sheets"
        yield "open edges", counts["open_edges_welded"], text, None, None
    if counts["non_manifold_edges_welded"]:
        number = counts["non_manifold_edges_welded"]
        text = counted(number, "edge", "edges") + " with three triangles or more: "
        if counts["open_edges_welded"]:
            text += "sheets meet there and stay connected"
            yield "non-manifold edges", number, text, None, None
        else:
            text += "solids touch there; merging joins those that share a flat wall"
            yield "non-manifold edges", number, text, "weld", weld


def _in_mm(diagnosis: dict[str, Any], recipe: dict[str, Any]) -> dict[str, Any]:
    """Convert the lengths of part keys from the unit of the file to mm."""
    scale = diagnosis["unit"]["scale"]
    if scale == 1.0:
        return recipe
    found: dict[str, Any] = {"scale": scale}
    if "weld" in recipe:
        found["weld"] = scale * recipe["weld"]
    if "remesh" in recipe:
        found["remesh"] = recipe["remesh"]
    return found


def _facets(diagnosis: dict[str, Any]) -> Iterator[_Found]:
    counts = diagnosis["counts"]
    weld = _in_mm(diagnosis, {"weld": diagnosis["tolerance"]})
    for name, what in (
        ("duplicate_triangles", ("triangle is duplicated", "triangles are duplicated")),
        ("degenerate_triangles", ("triangle has no height", "triangles have no height")),
        ("unused_vertices", ("vertex belongs to no triangle", "vertices belong to no triangle")),
    ):
        if counts[name]:
            text = counted(counts[name], *what)
            yield name.replace("_", " "), counts[name], text, "weld", weld
    if diagnosis["is_one_sided"]:
        yield "one-sided", 1, "a piece has one side only, like a Moebius strip", None, None
    if counts["flipped_triangles"]:
        text = counted(counts["flipped_triangles"], "triangle faces", "triangles face")
        text += " against the neighbours"
        yield "flipped triangles", counts["flipped_triangles"], text, "orient", weld
    inverted = sum(piece["is_inside_out"] for piece in diagnosis["components"])
    if inverted:
        text = counted(inverted, "closed component faces", "closed components face")
        text += " inwards: cavities, or inside-out solids"
        yield "facing inwards", inverted, text, None, None


def unit_word(diagnosis: dict[str, Any]) -> str:
    """Return the unit to print after a length of the file."""
    guess: str = diagnosis["unit"]["guess"]
    return "units" if guess == "unknown" else guess


def _shape(diagnosis: dict[str, Any]) -> Iterator[_Found]:
    counts, edges, rims = (diagnosis[key] for key in ("counts", "edge_lengths", "round_rims"))
    unit = unit_word(diagnosis)
    remesh = _in_mm(diagnosis, {"remesh": {"edge": diagnosis["suggested_edge"], "rims": "polygon"}})
    if counts["slivers"]:
        share = 100.0 * counts["slivers"] / diagnosis["triangles"]
        text = counted(counts["slivers"], "sliver", "slivers")
        text += f" ({share:.2g} % of the triangles)"
        folds = counts["folded_slivers"]
        if folds:
            shortest = f"{edges['shortest']:.2g} {unit}"
            text += f", {folds} of them in bends (shortest edge {shortest})"
        is_cured = folds > 0 or share >= _MANY_SLIVERS
        cure = ("remesh", remesh) if is_cured else (None, None)
        yield "slivers", counts["slivers"], text, *cure
    if edges["longest"] > _COARSE * diagnosis["size"] > 0.0:
        text = f"edges up to {edges['longest']:.3g} {unit}: too coarse to bend"
        if rims["count"] and rims["smallest_radius"] < edges["longest"]:
            text += f", next to round rims of radius {rims['smallest_radius']:.3g} {unit}"
        yield "long edges", 1, text, "remesh", remesh
    if diagnosis["thickness"] is not None:
        number = sum(piece["kind"] == "thin solid" for piece in diagnosis["components"])
        text = f"a sheet {diagnosis['thickness']:.4g} {unit} thick, with two skins"
        if len(diagnosis["components"]) > 1:
            text = counted(number, "sheet", "sheets") + " with two skins, most "
            text += f"{diagnosis['thickness']:.4g} {unit} thick"
        yield "thin solid", number, text, "thin", {"thin": "auto"}
    if len(diagnosis["components"]) > 1:
        number = len(diagnosis["components"])
        text = f"{number} unconnected components"
        yield "components", number, text, "split", {"split": True}
    guess = diagnosis["unit"]
    if guess["scale"] != 1.0:
        is_given = guess["reason"] == AS_GIVEN
        text = f"the unit {'is' if is_given else 'seems to be'} {unit}: {guess['reason']}"
        yield "unit", 1, text, "scale", {"scale": guess["scale"]}
    elif not guess["is_certain"]:
        options = either([f"--unit {name}" for name in guess["plausible"]])
        text = f"the unit is not certain: {guess['reason']}; give it with {options}"
        yield "unit", 1, text, None, None
