# SPDX-License-Identifier: LGPL-2.1-or-later
"""What picks say: selectors in global coordinates while they are picked, of the file afterwards."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad.sheetmorph.tools.figures import DRAWN, number


@dataclass(frozen=True)
class Length:
    """How long a sentence is: digits behind the point, of a camera in all; how far a figure may be
    from the one that was drawn, px."""

    digits: int
    camera: int
    away: float = 0.0


LENGTHS_TRIED = (Length(3, 4, 6.0), Length(3, 5, 2.0), Length(3, 7), Length(6, 10), Length(17, 17))
"""With which a sentence is tried, the shortest first."""
SHOWN = LENGTHS_TRIED[2]
EXACT = LENGTHS_TRIED[-1]
KEPT = "kept"
"""A key around what is in the coordinates of the file already."""
POINTS = ("face_at", "rim_at", "piece_at")

Said = Any  # a selector, None where nobody knows what to say


@dataclass(frozen=True)
class DrawnFigure:
    """A figure on the screen: places (px), of a brush its radius, and what the view showed.

    camera: the rows that give px, depth and divisor, the last one left out without perspective.
    """

    tool: str
    places: list
    camera: list
    radius: float = 0.0
    through: bool = False

    def said(self) -> dict:
        """As a selector has it."""
        places = [value for place in self.places for value in place]
        told = {self.tool: places, "camera": self.camera}
        if self.radius:
            told["radius"] = self.radius
        if self.through:
            told["through"] = True
        return {"drawn": told}


def tool_of(told: dict) -> str:
    """What a figure was drawn with: the key of its places. Raises KeyError if there is none."""
    found = [tool for tool in DRAWN if tool in told]
    if len(found) != 1:
        raise KeyError("figure")
    return found[0]


def figure_of(told: dict) -> DrawnFigure:
    """The figure of a selector. Raises ValueError if it is none."""
    try:
        tool = tool_of(told)
        figure = DrawnFigure(
            tool,
            np.array(told[tool], float).reshape(-1, 2).tolist(),
            [float(value) for value in told["camera"]],
            float(told.get("radius", 0.0)),
            bool(told.get("through", False)),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"A drawn figure has a {', '.join(DRAWN)}, and a camera.") from error
    if not figure.places or len(figure.camera) not in (12, 16):
        raise ValueError("A drawn figure has places, and a camera of 12 or 16 numbers.")
    return figure


def added(first: Said, second: Said) -> Said:
    """Both together."""
    if first is None or second is None:
        return None
    return [*(first if isinstance(first, list) else [first]), second]


def removed(first: Said, second: Said) -> Said:
    """The first without the second."""
    return None if first is None or second is None else {"minus": [first, second]}


def changed(key: str, said: Said) -> Said:
    """Grown or shrunk by a ring."""
    return None if said is None else {key: 1, "of": said}


def in_file(said: Said, frame: Any, length: Length = EXACT) -> Said:
    """The same in the coordinates of a part's file, no longer than that.

    `frame`: has rotation, base, origin, as conversion.Frame.
    """
    if isinstance(said, list):
        return [in_file(one, frame, length) for one in said]
    if not isinstance(said, dict):
        return said
    if KEPT in said:
        return said[KEPT]
    found = {}
    for key, value in said.items():
        if key in POINTS:
            local = (np.asarray(value, float) - frame.base) @ frame.rotation + frame.origin
            found[key] = rounded(local, length.digits)
        elif key == "drawn":
            found[key] = {**value, "camera": camera_in_file(value["camera"], frame, length.camera)}
        elif key in ("union", "intersection", "minus", "of"):
            found[key] = in_file(value, frame, length)
        else:
            found[key] = value
    return found


def rounded(values: np.ndarray, digits: int) -> list[float]:
    """Plain numbers, whole ones as such."""
    return [number(round(float(value), digits)) for value in values]


def camera_in_file(camera: Sequence[float], frame: Any, digits: int) -> list[float]:
    """The rows of a camera for the coordinates of the file, with so many digits in all."""
    to_global = np.eye(4)
    to_global[:3, :3] = frame.rotation
    to_global[:3, 3] = frame.base - frame.rotation @ frame.origin
    matrix = np.array(camera, float).reshape(-1, 4)
    if np.array_equal(matrix[3:], [[0.0, 0.0, 0.0, 1.0]]):
        matrix = matrix[:3]
    if not np.array_equal(to_global, np.eye(4)):
        matrix = matrix @ to_global
    return [significant(value, digits) for value in matrix.ravel().tolist()]


def significant(value: float, digits: int) -> float:
    """A number with so many significant digits."""
    if value == 0.0 or not math.isfinite(value):
        return 0
    return number(float(f"{value:.{digits}g}"))


def with_moved_ids(where: Said, moved: Callable[[list], list]) -> Said:
    """A selector whose vertex ids are those that `moved(ids)` gives."""
    if isinstance(where, list):
        return [with_moved_ids(one, moved) for one in where]
    if not isinstance(where, dict):
        return where
    return {
        key: (
            moved(value)
            if key == "vertices"
            else with_moved_ids(value, moved)
            if key in ("union", "intersection", "minus", "of")
            else value
        )
        for key, value in where.items()
    }


def placed(where: Said, frame: Any) -> Said:
    """A selector of a part in global coordinates; ValueError where it has none.

    `frame`: as of `in_file`; a box has none where the part is turned, a drawn figure never.
    """
    if np.array_equal(frame.rotation, np.eye(3)) and np.array_equal(frame.base, frame.origin):
        return where
    if isinstance(where, list):
        return [placed(one, frame) for one in where]
    if not isinstance(where, dict):
        return where
    if "drawn" in where or ("box" in where and not np.array_equal(frame.rotation, np.eye(3))):
        raise ValueError("It is in the coordinates of the part's file alone.")
    found = {}
    for key, value in where.items():
        if key in PLACES:
            points = np.asarray(value, float)
            found[key] = ((points - frame.origin) @ frame.rotation.T + frame.base).tolist()
        elif key in DIRECTIONS:
            found[key] = (frame.rotation @ np.asarray(value, float)).tolist()
        elif key == "vertices" or not isinstance(value, (dict, list)):
            found[key] = value
        else:
            found[key] = placed(value, frame)
    return found


DIRECTIONS = ("normal", "direction")
PLACES = (*POINTS, "border_at", "cad_face_at", "cad_edge_at", "near", "box", "point", "center")
LENGTHS = ("radius", "length", "thickness", "diameter", "borders_longer")
"""Keys of a selector whose values are lengths, mm."""


def scaled(where: Said, factor: float) -> Said:
    """A selector of a part that is so many times as large."""
    if isinstance(where, list):
        return [scaled(one, factor) for one in where]
    if not isinstance(where, dict) or factor == 1.0:
        return where
    found = {}
    for key, value in where.items():
        if key in PLACES or key in LENGTHS:
            found[key] = (factor * np.asarray(value, float)).tolist()
        elif key == "drawn":
            shrunk = np.diag([1.0 / factor] * 3 + [1.0])
            camera = np.array(value["camera"], float).reshape(-1, 4) @ shrunk
            found[key] = {**value, "camera": camera.ravel().tolist()}
        else:
            found[key] = scaled(value, factor) if isinstance(value, (dict, list)) else value
    return found


def simplest(where: Said) -> Said:
    """A list of one is that one."""
    return where[0] if isinstance(where, list) and len(where) == 1 else where


def operands(said: Said) -> list:
    """The selectors that a list joins; one alone is itself."""
    if isinstance(said, dict) and set(said) == {"union"}:
        said = said["union"]
    return list(said) if isinstance(said, list) else [said]
