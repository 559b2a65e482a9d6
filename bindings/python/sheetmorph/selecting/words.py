# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors in Python: functions with the names of the recipe, joined by | & -."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..base.arrays import Floats, Ids
from ..base.errors import InputError

Vector = Sequence[float] | Floats
Where = dict[str, Any] | Sequence[dict[str, Any]]
"""A selector, or several for their union."""
Region = Where | Ids


class Selector(dict[str, Any]):
    """A selector in the form of the recipe; `a | b`, `a & b` and `a - b` join two."""

    # A dict only for JSON: here | joins regions, not keys.
    def __or__(self, other: Where) -> Selector:  # type: ignore[override]
        return union(self, other)

    def __and__(self, other: Where) -> Selector:
        return intersection(self, other)

    def __sub__(self, other: Where) -> Selector:
        return minus(self, other)

    def __repr__(self) -> str:
        return sentence(self)


def _numbers(values: Any) -> Any:
    """Convert tuples and arrays to lists of plain numbers, as in JSON."""
    if hasattr(values, "tolist"):
        return values.tolist()
    is_list = isinstance(values, (list, tuple, range))
    return [_numbers(value) for value in values] if is_list else values


def _made(**keys: Any) -> Selector:
    return Selector({key: _numbers(value) for key, value in keys.items() if value is not None})


def vertices(ids: Ids) -> Selector:
    """Select vertices by their ids.

    Parameters
    ----------
    ids : sequence of int
        Ids of the file.

    Returns
    -------
    Selector
    """
    return _made(vertices=ids)


def box(low: Vector, high: Vector) -> Selector:
    """Select the vertices in an axis-aligned box.

    Parameters
    ----------
    low, high : sequence of float
        Opposite corners (3,), mm.

    Returns
    -------
    Selector
    """
    return _made(box=[low, high])


def half_space(point: Vector, normal: Vector) -> Selector:
    """Select the vertices on one side of a plane.

    Parameters
    ----------
    point : sequence of float
        Point on the plane (3,), mm.
    normal : sequence of float
        Direction (3,) to the selected side.

    Returns
    -------
    Selector
    """
    return Selector(half_space=dict(_made(point=point, normal=normal)))


def slab(point: Vector, normal: Vector, thickness: float) -> Selector:
    """Select the vertices between two parallel planes.

    Parameters
    ----------
    point : sequence of float
        Point on the mid-plane (3,), mm.
    normal : sequence of float
        Normal (3,).
    thickness : float
        Distance of the planes, mm.

    Returns
    -------
    Selector
    """
    return Selector(slab=dict(_made(point=point, normal=normal, thickness=thickness)))


def cylinder(
    point: Vector, direction: Vector, radius: float, length: float | None = None
) -> Selector:
    """Select the vertices in a cylinder.

    Parameters
    ----------
    point : sequence of float
        Point on the axis (3,), mm; the cylinder starts here if it has a length.
    direction : sequence of float
        Direction of the axis (3,).
    radius : float
        mm.
    length : float, optional
        mm; infinite in both directions by default.

    Returns
    -------
    Selector
    """
    told = _made(point=point, direction=direction, radius=radius, length=length)
    return Selector(cylinder=dict(told))


def sphere(center: Vector, radius: float) -> Selector:
    """Select the vertices in a sphere.

    Parameters
    ----------
    center : sequence of float
        Centre (3,), mm.
    radius : float
        mm.

    Returns
    -------
    Selector
    """
    return Selector(sphere=dict(_made(center=center, radius=radius)))


def face_at(point: Vector, crease_angle: float | None = None) -> Selector:
    """Select the face nearest to a point, up to its creases.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.
    crease_angle : float, optional
        Smallest angle of a crease, degrees; 20 by default.

    Returns
    -------
    Selector
    """
    return _made(face_at=point, crease_angle=crease_angle)


def rim_at(point: Vector, rings: int | None = None) -> Selector:
    """Select the rim nearest to a point.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.
    rings : int, optional
        Rings of triangles around the rim to include.

    Returns
    -------
    Selector
    """
    return _made(rim_at=point, rings=rings)


def border_at(point: Vector) -> Selector:
    """Select the border of the sheet nearest to a point.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.

    Returns
    -------
    Selector
    """
    return _made(border_at=point)


def borders_longer(length: float) -> Selector:
    """Select all borders of the sheet longer than a length.

    Parameters
    ----------
    length : float
        mm.

    Returns
    -------
    Selector
    """
    return _made(borders_longer=length)


def piece_at(point: Vector) -> Selector:
    """Select the connected component nearest to a point.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.

    Returns
    -------
    Selector
    """
    return _made(piece_at=point)


def group(name: str) -> Selector:
    """Select a group, set or property by its name in the file.

    Parameters
    ----------
    name : str
        The name.

    Returns
    -------
    Selector
    """
    return _made(group=name)


def cad_face_at(
    point: Vector,
    kind: str | None = None,
    name: str | None = None,
    number: int | None = None,
) -> Selector:
    """Select the face of the CAD file nearest to a point.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.
    kind : str, optional
        Surface kind of the face.
    name : str, optional
        Name of the face in the file.
    number : int, optional
        Expected number of the face; another one gives a remark.

    Returns
    -------
    Selector
    """
    return _made(cad_face_at=point, kind=kind, name=name, number=number)


def cad_edge_at(point: Vector) -> Selector:
    """Select the edge of the CAD file nearest to a point.

    Parameters
    ----------
    point : sequence of float
        Point (3,), mm.

    Returns
    -------
    Selector
    """
    return _made(cad_edge_at=point)


def found(
    kind: str, near: Vector | None = None, diameter: Vector | None = None, count: int | None = None
) -> Selector:
    """Select features that the search finds.

    Parameters
    ----------
    kind : str
        Kind of feature, such as "round hole".
    near : sequence of float, optional
        Select only the feature nearest to this point (3,), mm.
    diameter : sequence of float, optional
        Select only features in this range (2,), mm.
    count : int, optional
        Expected number of features.

    Returns
    -------
    Selector
    """
    return _made(found=kind, near=near, diameter=diameter, count=count)


def everything() -> Selector:
    """Select the whole part.

    Returns
    -------
    Selector
    """
    return Selector(all=True)


def union(*selectors: Where) -> Selector:
    """Select the vertices in any of the selectors.

    Parameters
    ----------
    *selectors : selector
        The operands.

    Returns
    -------
    Selector
    """
    return Selector(union=list(selectors))


def intersection(*selectors: Where) -> Selector:
    """Select the vertices in all selectors.

    Parameters
    ----------
    *selectors : selector
        The operands.

    Returns
    -------
    Selector
    """
    return Selector(intersection=list(selectors))


def minus(first: Where, *others: Where) -> Selector:
    """Select the vertices in the first selector but in none of the others.

    Parameters
    ----------
    first, *others : selector
        The operands.

    Returns
    -------
    Selector
    """
    return Selector(minus=[first, *others])


def grow(selector: Where, rings: int | None = None, length: float | None = None) -> Selector:
    """Add the surroundings of a region.

    Parameters
    ----------
    selector : selector
        The region.
    rings : int, optional
        Number of rings of triangles.
    length : float, optional
        Length along the sheet, mm.

    Returns
    -------
    Selector

    Raises
    ------
    InputError
        Unless exactly one of rings and length is given.
    """
    return Selector(grow=_amount(rings, length), of=selector)


def shrink(selector: Where, rings: int | None = None, length: float | None = None) -> Selector:
    """Remove the outer zone of a region.

    Parameters
    ----------
    selector : selector
        The region.
    rings : int, optional
        Number of rings of triangles.
    length : float, optional
        Length along the sheet, mm.

    Returns
    -------
    Selector

    Raises
    ------
    InputError
        Unless exactly one of rings and length is given.
    """
    return Selector(shrink=_amount(rings, length), of=selector)


def _amount(rings: int | None, length: float | None) -> int | dict[str, float]:
    if rings is not None and length is None:
        return int(rings)
    if length is not None and rings is None:
        return {"length": float(length)}
    raise InputError("give either rings or a length")


def sentence(selector: Where) -> str:
    """Return a short text for a selector: face_at [1, 2, 3], (a minus b)."""
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
