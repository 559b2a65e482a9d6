# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Coin, FreeCAD and Qt are given to call: they keep it for ever, so it can be let go."""


class Relay:
    """Calls a function until ``let_go``; then whoever still has the relay has nothing else."""

    __slots__ = ("_function",)  # what is kept for ever is small

    def __init__(self, function):
        self._function = function

    def __call__(self, *arguments):
        if self._function is not None:
            self._function(*arguments)

    def let_go(self) -> None:
        """Forgets the function."""
        self._function = None
