# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths to numbers in a recipe: `pose.tip.translation[2]`, `features."a.b".size`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from ..base.errors import Fault, RecipeError

Step = str | int
_STEP = re.compile(r'\[(\d+)\]|\[?"((?:[^"\\]|\\.)+)"\]?|([^.\[\]"]+)')
# A missing entry of a pose means no motion; other numbers must exist in the recipe.
_NO_MOTION = {"translation": (0.0, 0.0, 0.0)}
_SHOWN = 6


def steps_of(path: str, where: str) -> list[Step]:
    """Return the steps of a path: keys and names as text, list positions as numbers.

    Raises RecipeError.
    """
    steps: list[Step] = []
    at = 0
    while at < len(path):
        if steps and path[at] == ".":
            at += 1
        found = _STEP.match(path, at)
        if found is None:
            what = f'"{path}" is not a path: it is not valid from "{path[at:]}" on'
            raise _error(where, what, 'write it such as "pose.tip.translation[2]"')
        number, quoted, plain = found.groups()
        text = plain if quoted is None else re.sub(r"\\(.)", r"\1", quoted)
        steps.append(int(number) if number is not None else text)
        at = found.end()
    return steps


def value_at(recipe: Any, steps: Sequence[Step]) -> Any:
    """Return the value at a path, or None."""
    for step in steps:
        key = _key(recipe, step)
        if key is None:
            return None
        recipe = recipe[key]
    return recipe


def with_value(
    recipe: dict[str, Any], steps: Sequence[Step], value: Any, where: str
) -> dict[str, Any]:
    """Return the recipe with another value at a path; only nodes on the path are copied.

    Missing motions of a pose are added. Raises RecipeError.
    """
    found: dict[str, Any] = _with(recipe, list(steps), value, _Trail(where, list(steps)))
    return found


class _Trail:
    """The parameter and the whole path, for messages."""

    def __init__(self, where: str, steps: list[Step]):
        self.where, self.steps = where, steps

    def error(self, left: int, what: str, todo: str) -> RecipeError:
        done = self.steps[: len(self.steps) - left]
        return _error(self.where, f"{what} at {_spelled(done) or 'the top of the recipe'}", todo)


def _with(node: Any, left: list[Step], value: Any, trail: _Trail) -> Any:
    if not left:
        return value
    step, rest = left[0], left[1:]
    if isinstance(node, dict) and isinstance(step, str):
        if step not in node and not _may_begin(trail.steps, len(trail.steps) - len(left)):
            known = [str(key) for key in node]
            raise trail.error(len(left), f'there is no "{step}"', _choice(known))
        inner = node.get(step, [*_NO_MOTION.get(step, ())] if step in _NO_MOTION else {})
        return {**node, step: _with(inner, rest, value, trail)}
    key = _key(node, step)
    if key is None:
        raise trail.error(len(left), f"there is no {_shown(step)}", _choice(_names(node)))
    return [*node[:key], _with(node[key], rest, value, trail), *node[key + 1 :]]


def _may_begin(steps: list[Step], depth: int) -> bool:
    """Return whether a key may be missing: in a pose, or at the end, where the schema checks it."""
    return steps[0] == "pose" or depth == len(steps) - 1


def _key(node: Any, step: Step) -> Any:
    """Return the key or index of a step in a node, or None."""
    if isinstance(node, dict):
        return step if step in node else None
    if not isinstance(node, list):
        return None
    if isinstance(step, int):
        return step if step < len(node) else None
    places = [k for k, entry in enumerate(node) if _name(entry) == step]
    return places[0] if places else None


def _name(entry: Any) -> Any:
    return entry.get("name") if isinstance(entry, dict) else None


def _names(node: Any) -> list[str]:
    if not isinstance(node, list):
        return []
    return [name for entry in node if isinstance(name := _name(entry), str)]


def _choice(known: list[str]) -> str:
    if not known:
        return "correct the path"
    more = "" if len(known) <= _SHOWN else f" and {len(known) - _SHOWN} more"
    return f"there are {', '.join(known[:_SHOWN])}{more}"


def _shown(step: Step) -> str:
    return f"entry {step}" if isinstance(step, int) else f'"{step}"'


def _spelled(steps: Sequence[Step]) -> str:
    text = ""
    for step in steps:
        if isinstance(step, int):
            text += f"[{step}]"
        else:
            quoted = f'"{step}"' if re.search(r'[.\[\]"]', step) else step
            text += f".{quoted}" if text else quoted
    return text


def _error(where: str, what: str, todo: str) -> RecipeError:
    return RecipeError([Fault(where, what, todo)])
