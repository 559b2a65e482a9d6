# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations on JSON data: copies, and values that no recipe can use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..base.errors import Fault
from .places import place_of

# The squares of larger coordinates can overflow.
_LARGEST = 1e100
# A recipe has 6 levels.
_DEEPEST = 32


def are_ids(node: Any) -> bool:
    """Return whether a node is a list of non-negative integers; the test is fast for long lists."""
    if not isinstance(node, list) or not set(map(type, node)) <= {int}:
        return False
    return not node or (min(node) >= 0 and max(node) < _LARGEST)


def copied(node: Any) -> Any:
    """Return a copy of JSON data."""
    if isinstance(node, dict):
        return {key: copied(child) for key, child in node.items()}
    if isinstance(node, list):
        return node[:] if are_ids(node) else [copied(child) for child in node]
    return node


def depth_faults(node: Any) -> list[Fault]:
    """Return a fault if the data is nested too deeply for recursive functions."""
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
    """Yield path and fault of non-finite numbers and unstorable texts below a node at `path`."""
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
    what = "a text with an invalid character (half a surrogate pair, or NUL)"
    return Fault(place_of(recipe, path), what, "remove that character")
