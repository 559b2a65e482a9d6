# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors as Python writes them: functions of the recipe's names, joined by | & -."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..arrays import Floats, Ids

Vector = Sequence[float] | Floats
Where = dict[str, Any] | Sequence[dict[str, Any]]
"""A selector; or several, whose union it is."""
Region = Where | Ids


class Selector(dict[str, Any]):
    """A selector as a recipe has it; `a | b`, `a & b` and `a - b` join two."""

    # As JSON it is a dict, and that is all it shares with one: | joins regions, not keys.
    def __or__(self, other: Where) -> Selector:  # type: ignore[override]
        return union(self, other)

    def __and__(self, other: Where) -> Selector:
        return intersection(self, other)

    def __sub__(self, other: Where) -> Selector:
        return minus(self, other)

    def __repr__(self) -> str:
        return sentence(self)


def _numbers(values: Any) -> Any:
    """Lists of plain numbers, as JSON has them, of tuples and arrays too."""
    if hasattr(values, "tolist"):
        return values.tolist()
    is_list = isinstance(values, (list, tuple, range))
    return [_numbers(value) for value in values] if is_list else values


def _made(**keys: Any) -> Selector:
    return Selector({key: _numbers(value) for key, value in keys.items() if value is not None})


def vertices(ids: Ids) -> Selector:
    """Vertices by their ids."""
    return _made(vertices=ids)


def box(low: Vector, high: Vector) -> Selector:
    """What lies between two opposite corners, mm."""
    return _made(box=[low, high])


def half_space(point: Vector, normal: Vector) -> Selector:
    """The side of a plane that its normal points to."""
    return Selector(half_space=dict(_made(point=point, normal=normal)))


def slab(point: Vector, normal: Vector, thickness: float) -> Selector:
    """What is nearer than half the thickness to a plane."""
    return Selector(slab=dict(_made(point=point, normal=normal, thickness=thickness)))


def cylinder(
    point: Vector, direction: Vector, radius: float, length: float | None = None
) -> Selector:
    """What is within a cylinder around an axis; without a length it goes on both ways."""
    told = _made(point=point, direction=direction, radius=radius, length=length)
    return Selector(cylinder=dict(told))


def sphere(center: Vector, radius: float) -> Selector:
    """What is within a sphere."""
    return Selector(sphere=dict(_made(center=center, radius=radius)))


def face_at(point: Vector, crease_angle: float | None = None) -> Selector:
    """The face nearest to a point, up to bends of the crease angle (degrees, 20)."""
    return _made(face_at=point, crease_angle=crease_angle)


def rim_at(point: Vector, rings: int | None = None) -> Selector:
    """The rim nearest to a point, with rings of triangles around it."""
    return _made(rim_at=point, rings=rings)


def border_at(point: Vector) -> Selector:
    """The border of the sheet nearest to a point."""
    return _made(border_at=point)


def borders_longer(length: float) -> Selector:
    """All borders of the sheet longer than a length, mm."""
    return _made(borders_longer=length)


def piece_at(point: Vector) -> Selector:
    """The connected component nearest to a point."""
    return _made(piece_at=point)


def group(name: str) -> Selector:
    """What the file calls by a name."""
    return _made(group=name)


def cad_face_at(
    point: Vector,
    kind: str | None = None,
    name: str | None = None,
    number: int | None = None,
) -> Selector:
    """The face of the CAD file nearest to a point."""
    return _made(cad_face_at=point, kind=kind, name=name, number=number)


def cad_edge_at(point: Vector) -> Selector:
    """The edge of the CAD file nearest to a point."""
    return _made(cad_edge_at=point)


def found(
    kind: str, near: Vector | None = None, diameter: Vector | None = None, count: int | None = None
) -> Selector:
    """What `find` finds: all of a kind, those of a diameter, the nearest to a point."""
    return _made(found=kind, near=near, diameter=diameter, count=count)


def everything() -> Selector:
    """The whole part."""
    return Selector(all=True)


def union(*selectors: Where) -> Selector:
    """What is in one of them."""
    return Selector(union=list(selectors))


def intersection(*selectors: Where) -> Selector:
    """What is in all of them."""
    return Selector(intersection=list(selectors))


def minus(first: Where, *others: Where) -> Selector:
    """What is in the first, and in none of the others."""
    return Selector(minus=[first, *others])


def grow(selector: Where, rings: int | None = None, length: float | None = None) -> Selector:
    """A region and the rings of triangles, or the length, mm, around it."""
    return Selector(grow=_amount(rings, length), of=selector)


def shrink(selector: Where, rings: int | None = None, length: float | None = None) -> Selector:
    """A region without the rings of triangles, or the length, mm, at its edge."""
    return Selector(shrink=_amount(rings, length), of=selector)


def _amount(rings: int | None, length: float | None) -> int | dict[str, float]:
    if rings is not None and length is None:
        return int(rings)
    if length is not None and rings is None:
        return {"length": float(length)}
    raise ValueError("give either rings or a length")


def sentence(selector: Where) -> str:
    """A selector in a few words: face_at [1, 2, 3], (a minus b)."""
    if not isinstance(selector, dict):
        return _joined(selector, "or")
    for key, word in (("union", "or"), ("intersection", "and"), ("minus", "minus")):
        if key in selector:
            return _joined(selector[key], word)
    for key in ("grow", "shrink"):
        if key in selector:
            amount = selector[key]
            told = f"{amount['length']:g} mm" if isinstance(amount, dict) else str(amount)
            return f"{key} {told} of {sentence(selector['of'])}"
    return ", ".join(f"{key} {_short(value)}" for key, value in selector.items())


def _joined(selectors: Sequence[Where], word: str) -> str:
    return "(" + f" {word} ".join(sentence(inner) for inner in selectors) + ")"


def _short(value: Any) -> str:
    if isinstance(value, list) and len(value) > 6:
        return f"[{len(value)} ids]"
    if isinstance(value, list):
        return "[" + ", ".join(_short(inner) for inner in value) + "]"
    if isinstance(value, dict):
        return " ".join(f"{key} {_short(inner)}" for key, inner in value.items())
    return f"{value:g}" if isinstance(value, float) else str(value)
