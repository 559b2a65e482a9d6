# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors of picks: global while picking, in the coordinates of the file afterwards."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad.sheetmorph.tools.figures import DRAWN, number


@dataclass(frozen=True)
class Length:
    """The precision of a selector: decimals of a point, significant digits of a view.

    `away` is the largest deviation (px) of a shortened figure from the drawn one.
    """

    digits: int
    view: int
    away: float = 0.0


LENGTHS_TRIED = (Length(3, 4, 6.0), Length(3, 5, 2.0), Length(3, 7), Length(6, 10), Length(17, 17))
"""The precisions to try for a selector, the shortest first."""
SHOWN = LENGTHS_TRIED[2]
EXACT = LENGTHS_TRIED[-1]
KEPT = "kept"
"""The key around a selector that is in the coordinates of the file already."""
POINTS = ("face_at", "rim_at", "piece_at")

Said = Any  # a selector, None if unknown


@dataclass(frozen=True)
class DrawnFigure:
    """A figure on the screen: its places (px), the radius of a brush, and `Camera.view`."""

    tool: str
    places: list
    view: list
    radius: float = 0.0
    through: bool = False

    def said(self) -> dict:
        """Return the figure as a selector."""
        places = [value for place in self.places for value in place]
        figure = {self.tool: places, "view": self.view}
        if self.radius:
            figure["radius"] = self.radius
        if self.through:
            figure["through"] = True
        return {"drawn": figure}


def tool_of(told: dict) -> str:
    """Return the tool of a drawn figure, the key of its places.

    Raises KeyError if there is not exactly one.
    """
    found = [tool for tool in DRAWN if tool in told]
    if len(found) != 1:
        raise KeyError("figure")
    return found[0]


def figure_of(told: dict) -> DrawnFigure:
    """Return the figure of a selector.

    Raises ValueError if the selector describes no valid figure.
    """
    try:
        tool = tool_of(told)
        figure = DrawnFigure(
            tool,
            np.array(told[tool], float).reshape(-1, 2).tolist(),
            view_of(told),
            float(told.get("radius", 0.0)),
            bool(told.get("through", False)),
        )
    except (LookupError, TypeError, ValueError) as error:
        raise ValueError(f"A drawn figure has a {', '.join(DRAWN)}, and a view.") from error
    if not figure.places or len(figure.view) not in (8, 12):
        raise ValueError("A drawn figure has places, and a view of 8 or 12 numbers.")
    return figure


def view_of(figure: dict) -> list[float]:
    """Return the view of a drawn figure; the camera of an older document has a row for depths."""
    if "view" in figure:
        return [float(value) for value in figure["view"]]
    return np.delete(np.reshape(figure["camera"], (-1, 4)).astype(float), 2, 0).ravel().tolist()


def added(first: Said, second: Said) -> Said:
    """Return the union of two selectors."""
    if first is None or second is None:
        return None
    return [*(first if isinstance(first, list) else [first]), second]


def removed(first: Said, second: Said) -> Said:
    """Return the first selector without the second."""
    return None if first is None or second is None else {"minus": [first, second]}


def changed(key: str, said: Said) -> Said:
    """Return a selector grown or shrunk by one ring; `key` is "grow" or "shrink"."""
    return None if said is None else {key: 1, "of": said}


def in_file(said: Said, frame: Any, length: Length = EXACT) -> Said:
    """Return a selector in the coordinates of the part's file, with the given precision.

    `frame` has rotation, base and origin, as conversion.Frame.
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
            found[key] = {**value, "view": view_in_file(value["view"], frame, length.view)}
        elif key in ("union", "intersection", "minus", "of"):
            found[key] = in_file(value, frame, length)
        else:
            found[key] = value
    return found


def rounded(values: Sequence[float], digits: int) -> list[float]:
    """Return values rounded to a number of decimals, whole numbers as int."""
    return [number(round(float(value), digits)) for value in values]


def view_in_file(view: Sequence[float], frame: Any, digits: int) -> list[float]:
    """Return the numbers of a view for the coordinates of the file, rounded to `digits`."""
    to_global = np.eye(4)
    to_global[:3, :3] = frame.rotation
    to_global[:3, 3] = frame.base - frame.rotation @ frame.origin
    rows = np.reshape(view, (-1, 4)) @ to_global
    return [significant(value, digits) for value in rows.ravel().tolist()]


def significant(value: float, digits: int) -> float:
    """Return a number rounded to significant digits."""
    if value == 0.0 or not math.isfinite(value):
        return 0
    return number(float(f"{value:.{digits}g}"))


def with_moved_ids(where: Said, moved: Callable[[list], list]) -> Said:
    """Return a selector with its vertex ids replaced by those of `moved(ids)`."""
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
    """Return the selector of a part in global coordinates.

    `frame` is as for `in_file`. Raises ValueError for a box in a rotated part, and for a drawn
    figure.
    """
    if np.array_equal(frame.rotation, np.eye(3)) and np.array_equal(frame.base, frame.origin):
        return where
    if isinstance(where, list):
        return [placed(one, frame) for one in where]
    if not isinstance(where, dict):
        return where
    if "drawn" in where or ("box" in where and not np.array_equal(frame.rotation, np.eye(3))):
        raise ValueError("It uses only the coordinates of the part's file.")
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
    """Return the selector of a part enlarged by a factor."""
    if isinstance(where, list):
        return [scaled(one, factor) for one in where]
    if not isinstance(where, dict) or factor == 1.0:
        return where
    found = {}
    for key, value in where.items():
        if key in PLACES or key in LENGTHS:
            found[key] = (factor * np.asarray(value, float)).tolist()
        elif key == "drawn":
            rows = np.reshape(view_of(value), (-1, 4)) / ([factor] * 3 + [1.0])
            found[key] = {**value, "view": rows.ravel().tolist()}
        else:
            found[key] = scaled(value, factor) if isinstance(value, (dict, list)) else value
    return found


def simplest(where: Said) -> Said:
    """Return the only entry of a list, else the selector unchanged."""
    return where[0] if isinstance(where, list) and len(where) == 1 else where


def operands(said: Said) -> list:
    """Return the selectors that a list or union joins; a single one gives a list of one."""
    if isinstance(said, dict) and set(said) == {"union"}:
        said = said["union"]
    return list(said) if isinstance(said, list) else [said]
