# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well features and contacts are found: precision and recall on generated and real models.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/package/finding_scores.py

prints tables of resources/docs/accuracy.md.
"""

from __future__ import annotations

import json
import os
import sys
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from coarsening import coarsened
from labelled_contacts import pairs
from labelled_shapes import catalogue
from sheetmorph import PartMesh
from sheetmorph.finding import FindPart, find, find_in_files
from sheetmorph.finding.options import CONTACT_KINDS, KINDS

REPOSITORY = Path(__file__).resolve().parents[2]
LABELS = REPOSITORY / "tests/real/labels/holes_and_contacts.json"
sys.path.insert(0, str(REPOSITORY / "resources/examples"))

# Edges over those as drawn; standard deviation of measured vertices over the median edge as drawn.
VARIANTS = {
    "as drawn": (1.0, 0.0),
    "scatter 2 %": (1.0, 0.02),
    "scatter 5 %": (1.0, 0.05),
    "coarse": (2.0, 0.0),
    "coarse, scatter 2 %": (2.0, 0.02),
}
FEWEST = 8  # vertices of the rims of round holes that count


@dataclass(frozen=True)
class Score:
    """labelled, found: numbers of each; hit: labels that were found; right: findings that are."""

    labelled: int = 0
    found: int = 0
    hit: int = 0
    right: int = 0

    @property
    def recall(self) -> float:
        return self.hit / self.labelled if self.labelled else 1.0

    @property
    def precision(self) -> float:
        return self.right / self.found if self.found else 1.0

    def __add__(self, other: Score) -> Score:
        mine, theirs = vars(self).values(), vars(other).values()
        return Score(*(a + b for a, b in zip(mine, theirs)))

    def __str__(self) -> str:
        shares = f"{100 * self.precision:.0f} / {100 * self.recall:.0f} %"
        return f"{shares} ({self.found}, {self.labelled})" if self.labelled or self.found else "-"


Scores = defaultdict[str, Score]


def summed(tables: Sequence[dict[str, Score]]) -> Scores:
    """The scores of several tables, by kind."""
    total: Scores = defaultdict(Score)
    for table in tables:
        for kind, score in table.items():
            total[kind] += score
    return total


def matched(labels: Sequence[Any], found: Sequence[Any], is_that: Callable) -> Score:
    """Every finding stands for at most one label, and the other way round."""
    left = list(labels)
    for entry in found:
        place = next((k for k, label in enumerate(left) if is_that(label, entry)), None)
        if place is not None:
            del left[place]
    hit = len(labels) - len(left)
    return Score(len(labels), len(found), hit, hit)


def by_kind(labels: Sequence[tuple], found: Sequence[dict], is_that: Callable) -> dict[str, Score]:
    """Scores of labels, each with its kind first, and entries."""
    kinds = {label[0] for label in labels} | {entry["kind"] for entry in found}
    return {
        kind: matched(
            [label for label in labels if label[0] == kind],
            [entry for entry in found if entry["kind"] == kind],
            is_that,
        )
        for kind in kinds
    }


def median_edge(points: np.ndarray, triangles: np.ndarray) -> float:
    ends = points[triangles]
    return float(np.median(np.linalg.norm(ends - np.roll(ends, 1, axis=1), axis=2)))


def scattered(points: np.ndarray, deviation: float, seed: int) -> np.ndarray:
    """The points as measured."""
    return points + np.random.default_rng(seed).normal(0.0, deviation, points.shape)


# -- generated: simple shapes, pairs of parts


def shape_scores(coarse: float, scatter: float) -> Scores:
    """Features of every kind on the parts of the catalogue."""

    def is_that(label: tuple, entry: dict) -> bool:
        vertices = set(entry["vertices"])
        return 2 * len(label[1] & vertices) >= len(label[1] | vertices)

    tables = []
    for seed, shape in enumerate(catalogue(coarse)):
        points = scattered(shape.points, scatter * median_edge(shape.points, shape.triangles), seed)
        found = find([FindPart(shape.name, PartMesh(points, shape.triangles))]).features
        tables.append(by_kind(shape.labels, found, is_that))
    return summed(tables)


def pair_scores(coarse: float, scatter: float) -> Scores:
    """Contacts of every kind between pairs of parts."""
    made = pairs(coarse)
    index = {name: k for k, name in enumerate(made.parts)}
    parts = [
        FindPart(n, PartMesh(scattered(points, scatter * median_edge(points, t), index[n]), t))
        for n, (points, t) in made.parts.items()
    ]
    elements = [(index[a], v, index[b], w, -1, 0) for a, v, b, w in made.connections]

    def is_that(label: tuple, entry: dict) -> bool:
        _, a, b, center, reach = label
        is_pair = (entry["a"]["part"], entry["b"]["part"]) == (a, b)
        return is_pair and bool(np.linalg.norm(center - entry["center"]) <= reach)

    labels = [(kind, a, b, center, reach) for a, b, kind, center, reach in made.labels]
    return summed([by_kind(labels, find(parts, connections=elements).contacts, is_that)])


# -- generated: the examples


@cache
def examples() -> tuple:
    from shapes import body_panels, door_mirror, welded_frame

    return tuple(module.example() for module in (door_mirror, body_panels, welded_frame))


@dataclass(frozen=True)
class Variant:
    """A part of an example: its mesh, its edge as drawn, the rims of its holes as vertices."""

    mesh: PartMesh
    edge: float
    rims: list[frozenset[int]]


def variant_of(sheet, seed: int, coarse: float, scatter: float) -> Variant:
    """A part with every hole down to 8 vertices and half the others if coarse; measured."""
    points, triangles = np.array(sheet.points), np.array(sheet.triangles)
    rims = [[int(v) for v in rim] for rim in sheet.rims.values()]
    edge = median_edge(points, triangles)
    if coarse > 1.0:
        points, triangles, rims = coarsened(points, triangles, rims)
    mesh = PartMesh(scattered(points, scatter * edge, seed), triangles)
    return Variant(mesh, edge, [frozenset(rim) for rim in rims])


def example_scores(coarse: float, scatter: float) -> Scores:
    """Round holes, exactly by their rims, and contacts, of any kind, of all three examples."""
    tables = []
    for example in examples():
        made = {s.name: variant_of(s, k, coarse, scatter) for k, s in enumerate(example.sheets)}
        found = find([FindPart(name, one.mesh) for name, one in made.items()])
        labels = [(name, rim) for name, one in made.items() for rim in one.rims]
        holes = [(e["part"], frozenset(e["vertices"])) for e in rims_of(found.features)]
        tables.append({"round hole": matched(labels, holes, lambda a, b: a == b)})
        tables.append({"contact": _example_contacts(example, made, found.contacts)})
    return summed(tables)


def rims_of(features: Sequence[dict]) -> list[dict]:
    """The round holes that count."""
    holes = [entry for entry in features if entry["kind"] == "round hole"]
    return [hole for hole in holes if len(hole["rims"][0]) >= FEWEST]


def _example_contacts(example, made: dict[str, Variant], found: list[dict]) -> Score:
    """A label is a place that has been found if half of both its sides are in contacts found there;
    a contact is right if half of both its sides are in labels."""
    drawn = {sheet.name: sheet.points for sheet in example.sheets}
    measured = {name: one.mesh.points for name, one in made.items()}
    labels = [_sides(entry, drawn) for entry in example.contacts()]
    answers = [_sides(entry, measured) for entry in found]

    def share(one: dict, others: list[dict]) -> float:
        shares = []
        for part, points in one.items():
            near = [other[part] for other in others if other.keys() == one.keys()]
            away = cKDTree(np.vstack(near)).query(points)[0] if near else np.array([np.inf])
            shares.append(float(np.mean(away <= 1.5 * made[part].edge)))
        return min(shares)

    hit = sum(share(label, answers) >= 0.5 for label in labels)
    right = sum(share(answer, labels) >= 0.5 for answer in answers)
    return Score(len(labels), len(found), hit, right)


def _sides(entry: dict, points: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {entry[s]["part"]: points[entry[s]["part"]][entry[s]["vertices"]] for s in "ab"}


# -- the real models


def data_folder() -> Path | None:
    """The folder of the public meshes, None if it is not at hand."""
    shared = os.environ.get("SHEETMORPH_SHARED")
    folder = (Path(shared) if shared else REPOSITORY.parent / "shared") / "data"
    return folder if folder.is_dir() else None


def real_models() -> list[dict]:
    """What was labelled by hand."""
    return json.loads(LABELS.read_text("utf-8"))["models"]


def real_scores(model: dict, folder: Path) -> Scores:
    """Round holes and contacts of a real model."""
    found = find_in_files([folder / file for file in model["files"]])
    scores: Scores = defaultdict(Score)
    scores["round hole"] = matched(model["holes"], rims_of(found["features"]), _is_that_hole)
    if model["contacts"] is not None:
        # Labels are places where sheets touch; single welds and bolts of a deck are its elements.
        places = [e for e in found["contacts"] if (e["kind"], e["type"]) != ("weld", "rigid")]
        scores["contact"] = matched(model["contacts"], places, _is_that_contact)
    return scores


def _is_that_hole(label: dict, entry: dict) -> bool:
    off = np.subtract(entry["center"], label["center"])
    axis = np.asarray(entry["axis"])
    aside = np.linalg.norm(off - axis * (off @ axis))
    along = abs(off @ axis) <= 3.0 * label["radius"] + entry.get("depth", 0.0)
    is_like = abs(entry["radius"] - label["radius"]) <= 0.25 * label["radius"]
    is_there = along and is_like and aside <= 0.5 * label["radius"]
    return entry["part"] == label["part"] and bool(is_there)


def _is_that_contact(label: dict, entry: dict) -> bool:
    if {entry["a"]["part"], entry["b"]["part"]} != {label["a"], label["b"]}:
        return False
    if "center" not in label:
        return True
    away = np.linalg.norm(np.subtract(entry["center"], label["center"]))
    return bool(away <= max(label.get("reach", 0.0), 0.35 * entry["size"]))


# -- the tables


def table(rows: Sequence[str], columns: dict[str, Scores]) -> str:
    """Scores as Markdown, precision / recall (found, labelled)."""
    lines = ["| | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for row in rows:
        cells = [str(scores[row]) for scores in columns.values()]
        lines.append(f"| {row} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main() -> None:
    """Prints everything."""
    print(table(KINDS, {name: shape_scores(*how) for name, how in VARIANTS.items()}), "\n")
    print(table(CONTACT_KINDS, {name: pair_scores(*how) for name, how in VARIANTS.items()}), "\n")
    of_examples = {name: example_scores(*how) for name, how in VARIANTS.items()}
    print(table(("round hole", "contact"), of_examples), "\n")
    folder = data_folder()
    if folder is None:
        return
    real = {model["name"]: real_scores(model, folder) for model in real_models()}
    real["together"] = summed(list(real.values()))
    print(table(("round hole", "contact"), real))


if __name__ == "__main__":
    main()
