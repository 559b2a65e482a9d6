# SPDX-License-Identifier: LGPL-2.1-or-later
"""When the result objects follow a motion that changes; the preview always does at once."""

from __future__ import annotations

AUTOMATIC, WHILE_CHANGING, ON_PAUSE, ON_OK = range(4)
BUDGET = 0.05  # seconds a commit may take to be done at every change
PAUSE = 0.3  # seconds without a change that count as a pause


class Updating:
    """Decides by the preference and by what the last commit cost."""

    def __init__(self, preference: int = AUTOMATIC):
        self.preference = preference
        self._cost: float | None = None

    def took(self, seconds: float) -> None:
        """Notes what a commit cost."""
        self._cost = seconds

    def is_due_now(self) -> bool:
        """Whether a change is committed at once; automatically only if the last one was quick."""
        if self.preference == AUTOMATIC:
            return self._cost is not None and self._cost <= BUDGET
        return self.preference == WHILE_CHANGING

    def is_due_on_pause(self) -> bool:
        """Whether a change is committed when the user pauses."""
        return self.preference in (AUTOMATIC, ON_PAUSE)
