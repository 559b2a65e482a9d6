# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formulas of parameters and measures: numbers, names, arithmetic and comparisons only."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from typing import Any

from ..base.errors import Fault, RecipeError

_TWO: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Mod: operator.mod,
}
_ONE: dict[type, Callable[[Any], Any]] = {
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Not: operator.not_,
}
_COMPARED: dict[type, Callable[[Any, Any], bool]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
_FUNCTIONS: dict[str, Callable[..., float]] = {
    "abs": abs,
    "min": min,
    "max": max,
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "radians": math.radians,
    "degrees": math.degrees,
    "hypot": math.hypot,
}
_CONSTANTS = {"pi": math.pi}
_LONGEST = 1000


class Expression:
    """A formula, such as `lift + 2 * reach <= 40`; names with spaces are in "quotes".

    Raises RecipeError if the text is not a formula, or has a name that is not in the list of names.
    """

    def __init__(self, text: str, known: list[str], where: str):
        self.text, self._where = text, where
        if len(text) > _LONGEST:
            raise self._error("it is too long", f"use at most {_LONGEST} characters")
        try:
            self._tree = ast.parse(text, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            raise self._error(f'"{text}" is not a formula', "write it such as lift <= 2 * reach")
        self.names = self._checked(set(known))

    @property
    def is_comparison(self) -> bool:
        """Whether the formula is true or false."""
        return isinstance(self._tree, (ast.Compare, ast.BoolOp)) or (
            isinstance(self._tree, ast.UnaryOp) and isinstance(self._tree.op, ast.Not)
        )

    def value(self, values: Mapping[str, float]) -> Any:
        """Return the number or truth value; NaN if it is undefined, as after a division by zero."""
        try:
            found = _value(self._tree, values)
        except (ArithmeticError, ValueError):
            return math.nan
        return found if isinstance(found, bool) else float(found)

    def _checked(self, known: set[str]) -> set[str]:
        names = set()
        for node in ast.walk(self._tree):
            if not _is_allowed(node):
                what = (
                    f'"{self.text}" has something that a formula cannot have '
                    f"({type(node).__name__})"
                )
                raise self._error(what, "use numbers, names, + - * / ( ), comparisons")
            name = _name_of(node)
            if name is not None and name not in _FUNCTIONS and name not in _CONSTANTS:
                names.add(name)
        for name in sorted(names - known):
            choice = ", ".join(sorted(known))
            raise self._error(f'"{self.text}" has an unknown name, "{name}"', f"known: {choice}")
        return names

    def _error(self, what: str, todo: str) -> RecipeError:
        return RecipeError([Fault(self._where, what, todo)])


def _is_allowed(node: ast.AST) -> bool:
    if isinstance(node, ast.Constant):
        return type(node.value) in (int, float, str)
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name) and node.func.id in _FUNCTIONS and not node.keywords
    kinds = (ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.Name, ast.Load, ast.And, ast.Or)
    return isinstance(node, kinds) or type(node) in _TWO | _ONE | _COMPARED


def _name_of(node: ast.AST) -> str | None:
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    return None


def _value(node: ast.AST, values: Mapping[str, float]) -> Any:
    name = _name_of(node)
    if name is not None:
        return values[name] if name in values else _CONSTANTS[name]
    if isinstance(node, ast.Constant):
        return float(node.value)
    if isinstance(node, ast.BinOp):
        return _TWO[type(node.op)](_value(node.left, values), _value(node.right, values))
    if isinstance(node, ast.UnaryOp):
        return _ONE[type(node.op)](_value(node.operand, values))
    if isinstance(node, ast.BoolOp):
        every = all if isinstance(node.op, ast.And) else any
        return every(bool(_value(part, values)) for part in node.values)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return _FUNCTIONS[node.func.id](*(_value(part, values) for part in node.args))
    assert isinstance(node, ast.Compare)  # the only remaining admissible node
    sides = [_value(part, values) for part in (node.left, *node.comparators)]
    return all(_COMPARED[type(op)](a, b) for op, a, b in zip(node.ops, sides, sides[1:]))
