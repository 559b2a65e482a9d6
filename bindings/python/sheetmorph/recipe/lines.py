# SPDX-License-Identifier: LGPL-2.1-or-later
"""Locations of recipe entries in the text of a JSON or TOML file."""

from __future__ import annotations

import json
import re
from bisect import bisect_right
from collections.abc import Generator, Iterator
from dataclasses import replace
from typing import Any

from ..base.errors import Fault
from .places import place_of

_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')
_QUOTED = r'"""(?:\\.|[^\\])*?"""|\'{3}.*?\'{3}|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\''
_TOML = re.compile(_QUOTED + r"""|\#[^\n]*|\n|[\[\]{}=,.]|[^\s\[\]{}=,.#"']+""", re.DOTALL)

Entry = tuple[list[str | int], int]
_Token = re.Match[str]


class Lines:
    """Line and column, from 1, of every entry of a valid text."""

    def __init__(self, text: str, recipe: Any, is_toml: bool = False):
        self._places: dict[str, tuple[int, int]] = {}
        starts = [0, *(found.end() for found in re.finditer("\n", text))]
        for path, place in _toml_entries(text) if is_toml else _entries(text):
            line = bisect_right(starts, place)
            found = line, place - starts[line - 1] + 1
            self._places.setdefault(place_of(recipe, path), found)

    def of(self, fault: Fault) -> Fault:
        """Add line and column of the fault's entry, or of the nearest enclosing entry."""
        # Prefixes of the place are looked up, which is faster than a search through all entries.
        where = fault.where
        ends = [len(where), *(k for k in range(len(where)) if where[k] in ".[")]
        around = [where[:k] for k in ends if where[:k] in self._places]
        if not around:
            return fault
        line, column = self._places[max(around, key=len)]
        return replace(fault, where=f"line {line}, column {column}, {fault.where}")


def repeated_key(text: str) -> tuple[int, int] | None:
    """Return line and column of the first duplicate key in an object of a JSON text, or None."""
    seen: set[tuple[str | int, ...]] = set()
    for path, place in _entries(text):
        if tuple(path) in seen:
            return text.count("\n", 0, place) + 1, place - text.rfind("\n", 0, place)
        seen.add(tuple(path))
    return None


def _entries(text: str) -> Iterator[Entry]:
    """Yield path and offset of every value except numbers in lists, in the order of the text."""
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


def _toml_entries(text: str) -> Iterator[Entry]:
    """Yield path and offset of TOML table headers, keys, and non-numbers in lists."""
    last: dict[tuple[str | int, ...], int] = {}  # index of the last table in every array of tables
    base: list[str | int] = []
    tokens = [token for token in _TOML.finditer(text) if token[0][0] != "#"]
    at = 0
    while at < len(tokens):
        begin = tokens[at]
        if begin[0] == "\n":
            at += 1
        elif begin[0] == "[":
            is_list = text[begin.end()] == "["
            names, at = _names(tokens, at + 1 + is_list, "]")
            base = []
            for name in names:
                place = tuple(base)
                base += [last[place], name] if place in last else [name]
            if is_list:
                last[tuple(base)] = last.get(tuple(base), -1) + 1
                base.append(last[tuple(base)])
            at += is_list
            yield list(base), begin.start()
        else:
            names, at = _names(tokens, at, "=")
            yield [*base, *names], begin.start()
            at = yield from _value(tokens, at, [*base, *names])


def _names(tokens: list[_Token], at: int, end: str) -> tuple[list[str], int]:
    """Return the parts of a dotted key, and the token index after its end."""
    names = []
    while tokens[at][0] != end:
        token = tokens[at][0]
        names += [json.loads(token) if token[0] == '"' else token.strip("'")] * (token != ".")
        at += 1
    return names, at + 1


def _value(tokens: list[_Token], at: int, path: list[str | int]) -> Generator[Entry, None, int]:
    """Yield the entries in a value; return the token index after it."""
    kind, number = tokens[at][0], 0
    if kind not in ("[", "{"):
        while at < len(tokens) and tokens[at][0] not in (",", "]", "}", "\n"):
            at += 1
        return at
    at += 1
    while tokens[at][0] not in ("]", "}"):
        begin = tokens[at]
        if begin[0] in (",", "\n"):
            number += begin[0] == ","
            at += 1
        elif kind == "{":
            names, at = _names(tokens, at, "=")
            yield [*path, *names], begin.start()
            at = yield from _value(tokens, at, [*path, *names])
        else:
            if begin[0][0] not in "-+.0123456789":
                yield [*path, number], begin.start()
            at = yield from _value(tokens, at, [*path, number])
    return at + 1
