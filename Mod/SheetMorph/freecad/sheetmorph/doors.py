# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that document objects call without a dependency on solvers and views.

The workbench's `__init__` provides them. So documents open without a solver or a view.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Door:
    """A function that is provided once by another module."""

    def __init__(self) -> None:
        self._function: Callable | None = None

    def lead_to(self, function: Callable) -> None:
        """Provide the function."""
        self._function = function

    def __call__(self, *arguments: Any) -> Any:
        """Call the function.

        Raises RuntimeError if none was provided.
        """
        if self._function is None:
            raise RuntimeError("The package freecad.sheetmorph was not loaded as a whole.")
        return self._function(*arguments)


give_looks = Door()
"""Attaches a view provider to a new document object, where there is a window."""
without_traceback = Door()
"""Turns a method that returns an exception or None into a function that raises it.

The exception has a sentence for users, so it gets no traceback.
"""
new_solver = Door()
"""Returns the solver of one assembly, which stores its sessions."""
