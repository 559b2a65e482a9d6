# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON data as such: copies, and values that JSON can hold but no recipe can use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..errors import Fault
from .places import place_of

# Beyond it, squares of coordinates overflow.
_LARGEST = 1e100
# A recipe has 6 levels.
_DEEPEST = 32


def are_ids(node: Any) -> bool:
    """Whether a node is a list of whole numbers, 0 or more; there may be millions of them."""
    if not isinstance(node, list) or not set(map(type, node)) <= {int}:
        return False
    return not node or (min(node) >= 0 and max(node) < _LARGEST)


def copied(node: Any) -> Any:
    """A copy of JSON data."""
    if isinstance(node, dict):
        return {key: copied(child) for key, child in node.items()}
    if isinstance(node, list):
        return node[:] if are_ids(node) else [copied(child) for child in node]
    return node


def depth_faults(node: Any) -> list[Fault]:
    """A fault if the data is nested so deeply that walking through it would fail."""
    level = [node]
    for _ in range(_DEEPEST):
        inner = [child for parent in level for child in _children(parent)]
        level = [child for child in inner if isinstance(child, (dict, list))]
    return [Fault("recipe", "it is nested too deeply", "simplify it")] if level else []


def _children(node: Any) -> list[Any]:
    if isinstance(node, dict):
        return list(node.values())
    return [] if are_ids(node) or not isinstance(node, list) else node


def bad_values(
    recipe: Any, node: Any, path: list[str | int]
) -> Iterator[tuple[list[str | int], Fault]]:
    """Numbers that are not finite and texts that cannot be stored, below a node at `path`."""
    if isinstance(node, dict):
        for key, child in node.items():
            if _is_bad_text(key):
                yield [*path, key], _text_fault(recipe, [*path, key])
            yield from bad_values(recipe, child, [*path, key])
    elif isinstance(node, list) and not are_ids(node):
        for key, child in enumerate(node):
            yield from bad_values(recipe, child, [*path, key])
    elif isinstance(node, (int, float)) and not abs(node) <= _LARGEST:
        what = "a number too large" if node == node else "not a number (NaN)"
        yield path, Fault(place_of(recipe, path), what, "give a finite number")
    elif _is_bad_text(node):
        yield path, _text_fault(recipe, path)


def _is_bad_text(node: Any) -> bool:
    return isinstance(node, str) and any(c == "\0" or "\ud800" <= c <= "\udfff" for c in node)


def _text_fault(recipe: Any, path: list[str | int]) -> Fault:
    what = "a text with a character that cannot be stored (half a surrogate pair, or NUL)"
    return Fault(place_of(recipe, path), what, "write it without that character")
