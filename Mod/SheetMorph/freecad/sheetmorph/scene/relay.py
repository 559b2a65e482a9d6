# SPDX-License-Identifier: LGPL-2.1-or-later
"""Callbacks for Coin, FreeCAD and Qt that can be cut off, since these never release them."""


class Relay:
    """A callable that calls a function until `let_go`, and nothing afterwards."""

    __slots__ = ("_function",)  # what is kept for ever is small

    def __init__(self, function):
        self._function = function

    def __call__(self, *arguments):
        if self._function is not None:
            self._function(*arguments)

    def let_go(self) -> None:
        """Release the function."""
        self._function = None
