# SPDX-License-Identifier: LGPL-2.1-or-later
"""The times at which result objects follow a changing motion; the preview always follows."""

from __future__ import annotations

AUTOMATIC, WHILE_CHANGING, ON_PAUSE, ON_OK = range(4)
BUDGET = 0.05  # s: largest duration of a commit made at every change
PAUSE = 0.3  # s: time without a change that counts as a pause


class Updating:
    """The decision by the preference and by the duration of the last commit."""

    def __init__(self, preference: int = AUTOMATIC):
        self.preference = preference
        self._cost: float | None = None

    def took(self, seconds: float) -> None:
        """Store the duration of a commit."""
        self._cost = seconds

    def is_due_now(self) -> bool:
        """Return whether to commit at once; in automatic mode, if the last commit was fast."""
        if self.preference == AUTOMATIC:
            return self._cost is not None and self._cost <= BUDGET
        return self.preference == WHILE_CHANGING

    def is_due_on_pause(self) -> bool:
        """Return whether to commit when the user pauses."""
        return self.preference in (AUTOMATIC, ON_PAUSE)
