# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document objects ask for without knowing who answers; `__init__` of the workbench says.

So data knows nothing of solvers and views, and documents open without either.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Door:
    """A function that is put in place once, by those who know it."""

    def __init__(self) -> None:
        self._function: Callable | None = None

    def lead_to(self, function: Callable) -> None:
        """Let `function` answer from now on."""
        self._function = function

    def __call__(self, *arguments: Any) -> Any:
        """Return what the function answers; raises RuntimeError while there is none."""
        if self._function is None:
            raise RuntimeError("The package freecad.sheetmorph was not loaded as a whole.")
        return self._function(*arguments)


give_looks = Door()
"""Called with a new document object: its view provider, where there is a window."""
without_traceback = Door()
"""Called with a method that returns an exception or None. Returns a function that raises the
exception without a traceback: it holds a sentence for the user."""
new_solver = Door()
"""Returns what solves one assembly and keeps its sessions."""
