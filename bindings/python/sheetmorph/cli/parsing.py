# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options with an optional value, which never consumes a required argument."""

from __future__ import annotations

import argparse
from typing import Any

STDOUT = "-"
"""Value of `--json` without a file."""


class Parser(argparse.ArgumentParser):
    """A parser in which an optional value never consumes a required argument.

    Plain argparse reads the recipe of `run -o x --repair recipe.json` as the criteria.
    """

    def __init__(self, *arguments: Any, **keywords: Any):
        self._known: dict[str, argparse.Action] = {}
        self._required = 0
        self._words: set[str] = set()  # values of an argument with choices
        super().__init__(*arguments, **keywords)

    def add_argument(self, *names: Any, **keywords: Any) -> argparse.Action:
        """Add an argument as argparse does."""
        action = super().add_argument(*names, **keywords)
        self._known.update(dict.fromkeys(action.option_strings, action))
        if not action.option_strings and action.nargs in (None, "+"):
            self._required += 1
        if not action.option_strings:
            self._words.update(action.choices or ())
        return action

    def parse_known_args(self, args=None, namespace=None):  # type: ignore[no-untyped-def]
        """Parse as argparse does, after every optional value is assigned."""
        return super().parse_known_args(
            args if args is None else self._settled(list(args)), namespace
        )

    def _settled(self, words: list[str]) -> list[str]:
        """Write `--option=default` where the word after an option is a required argument."""
        values, free = self._values(words)
        missing = self._required - free
        named = [k for k in values if words[k + 1] in self._words]
        if not named and (not values or missing <= 0):
            return words
        if not named and missing < len(values):
            options = " or ".join(f"{words[k]}={words[k + 1]}" for k in values)
            self.error(f"it is not clear which word is the value of an option; write {options}")
        for k in named or values:
            action = self._action(words[k])
            words[k] = f"{words[k]}={action.const}" if action is not None else words[k]
        return words

    def _values(self, words: list[str]) -> tuple[list[int], int]:
        """Return the options whose next word may be their value, and count the sure arguments."""
        values: list[int] = []
        free, k = 0, 0
        while k < len(words):
            if words[k] == "--":
                return values, free + len(words) - k - 1
            if not _is_option(words[k]):
                free += 1
                k += 1
                continue
            action = self._action(words[k])
            k += 1
            if action is None:
                continue
            if action.nargs == "?":
                if k < len(words) and not _is_option(words[k]):
                    values.append(k - 1)
                    k += 1
            else:
                k += action.nargs if isinstance(action.nargs, int) else action.nargs is None
        return values, free

    def _action(self, word: str) -> argparse.Action | None:
        """Return the option that consumes the next words; `--option=value` consumes none."""
        if word in self._known:
            return self._known[word]
        found = {id(a): a for name, a in self._known.items() if name.startswith(word)}
        is_short = not word.startswith("--")
        return None if is_short or len(found) != 1 else next(iter(found.values()))


def _is_option(word: str) -> bool:
    return word.startswith("-") and word != STDOUT
