# SPDX-License-Identifier: LGPL-2.1-or-later
"""An example assembly as a recipe: regions, features, pose, contacts found from geometry."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from shapes.contacts import touching_patches
from shapes.sheet import Sheet


@dataclass(frozen=True)
class Grip:
    """A named region: the vertices of a part that `chosen((n, 3) points) -> (n,) bool` picks."""

    name: str
    part: str
    chosen: Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Example:
    """Sheets, the primary first, and what a designer would mark on them.

    `fixed` and `supports` are fixed regions, on the primary and on other parts. `reach` is the
    distance in mm below which two sheets touch, `margin` how far around the touching vertices a
    contact goes.
    """

    folder: str
    sheets: tuple[Sheet, ...]
    formats: tuple[str, ...]
    fixed: tuple[Grip, ...]
    handles: tuple[Grip, ...]
    pose: dict
    supports: tuple[Grip, ...]
    reach: float
    propagation: str
    margin: float = 0.0
    one_contact_per_pair: bool = False

    def recipe(self) -> dict:
        """The whole assembly: every part's holes, and the contacts along which parts follow."""
        return {
            "sheetmorph": 1,
            "parts": [
                {"name": sheet.name, "file": f"{_stem(sheet.name)}.{suffix}"}
                for sheet, suffix in zip(self.sheets, self.formats)
            ],
            "primary": self.sheets[0].name,
            "energy": "neumann",
            "fixed": [self._fixed(grip) for grip in (*self.fixed, *self.supports)],
            "handles": [self._handle(grip) for grip in self.handles],
            "features": self._features(),
            "propagation": {"type": self.propagation},
            "contacts": self.contacts(),
            "pose": self.pose,
        }

    def contacts(self) -> list[dict]:
        """One contact per patch where two sheets lie within `reach`, named after both parts."""
        found = []
        for number, a in enumerate(self.sheets):
            for b in self.sheets[number + 1 :]:
                patches = touching_patches(a, b, self.reach, self.margin)
                if self.one_contact_per_pair and patches:
                    patches = [tuple(np.concatenate(side) for side in zip(*patches))]
                for count, (of_a, of_b) in enumerate(patches, start=1):
                    name = f"{a.name} - {b.name}" + (f" {count}" if len(patches) > 1 else "")
                    found.append({"name": name, "a": _side(a, of_a), "b": _side(b, of_b)})
        return found

    def _vertices(self, grip: Grip) -> dict:
        sheet = next(sheet for sheet in self.sheets if sheet.name == grip.part)
        vertices = np.flatnonzero(grip.chosen(sheet.points))
        return {"part": grip.part, "vertices": _without_torn_holes(sheet, vertices)}

    def _fixed(self, grip: Grip) -> dict:
        return {"name": grip.name, **self._vertices(grip)}

    def _handle(self, grip: Grip) -> dict:
        region = self._vertices(grip)
        sheet = next(sheet for sheet in self.sheets if sheet.name == grip.part)
        pivot = np.round(sheet.points[region["vertices"]].mean(axis=0), 3)
        return {"name": grip.name, **region, "pivot": pivot.tolist()}

    def _features(self) -> list[dict]:
        taken = {(g["part"], v) for g in self._regions() for v in g["vertices"]}
        features = []
        for sheet in self.sheets:
            for hole in sheet.rims:
                vertices = sheet.feature(hole)
                if any((sheet.name, v) in taken for v in vertices):
                    continue
                name = f"{sheet.name}: {hole}"
                region = {"name": name, "part": sheet.name, "vertices": vertices}
                features.append({**region, "rotation": "interpolated"})
        return features

    def _regions(self) -> list[dict]:
        return [self._vertices(g) for g in (*self.fixed, *self.handles, *self.supports)]


def motion(
    translation: Sequence[float], axis: Sequence[float], degrees: float
) -> dict[str, list | dict]:
    """A handle's entry in a pose: mm and degrees."""
    return {"translation": list(translation), "rotation": {"axis": list(axis), "degrees": degrees}}


def _without_torn_holes(sheet: Sheet, vertices: np.ndarray) -> list[int]:
    """The region, with every hole it touches taken in whole."""
    chosen = {int(v) for v in vertices}
    for hole in sheet.rims:
        if chosen & set(sheet.feature(hole)):
            chosen |= set(sheet.feature(hole))
    return sorted(chosen)


def _side(sheet: Sheet, vertices: np.ndarray) -> dict:
    return {"part": sheet.name, "vertices": sorted(int(v) for v in vertices)}


def _stem(name: str) -> str:
    return name.replace(" ", "_")
