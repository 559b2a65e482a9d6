# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where in the text of a JSON file the entries of a recipe stand."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from ..errors import Fault
from .places import place_of

_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')
_STEPS = re.compile(r"(?:\.[^.\[]*|\[\d+\](?: \([^()]*\))?)$")


class Lines:
    """Line and column, from 1, of every entry of a sound JSON text."""

    def __init__(self, text: str, recipe: Any):
        self._places: dict[str, tuple[int, int]] = {}
        starts = [0, *(found.end() for found in re.finditer("\n", text))]
        line = 0
        for path, place in _entries(text):
            while line + 1 < len(starts) and starts[line + 1] <= place:
                line += 1
            name = place_of(recipe, path)
            self._places.setdefault(name, (line + 1, place - starts[line] + 1))

    def of(self, fault: Fault) -> Fault:
        """The fault with line and column of its place, or of the nearest entry around it."""
        name = fault.where
        while name and name not in self._places:
            shorter = _STEPS.sub("", name)
            name = shorter if shorter != name else ""
        if not name:
            return fault
        line, column = self._places[name]
        return replace(fault, where=f"line {line}, column {column}, {fault.where}")


def _entries(text: str) -> Iterator[tuple[list[str | int], int]]:
    """Path and place of every value but single numbers in lists, in the order of the text."""
    path: list[str | int] = []
    kinds: list[str] = []
    is_key = False
    for found in _TOKEN.finditer(text):
        token = found[0]
        if token in "}]":
            kinds.pop()
            path.pop()
            is_key = False
        elif token == ",":
            is_key = kinds[-1] == "{"
            if kinds[-1] == "[":
                path[-1] = int(path[-1]) + 1
        elif token == ":":
            is_key = False
        elif is_key:
            path[-1] = json.loads(token)
            yield list(path), found.start()
        else:
            if kinds and kinds[-1] == "[" and token[0] not in "-0123456789":
                yield list(path), found.start()
            if token in "{[":
                kinds.append(token)
                path.append(0 if token == "[" else "")
                is_key = token == "{"
