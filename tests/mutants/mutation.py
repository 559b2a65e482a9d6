# SPDX-License-Identifier: LGPL-2.1-or-later
"""One plausible mistake in a source of the kernel, and the tests that must notice it."""
from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
KERNEL = ROOT / "core" / "sheetmorph"


class Mutation(NamedTuple):
    """A mistake: `new` replaces `old`, which occurs exactly once in a file of the kernel.

    file: relative to core/sheetmorph; tests: a GoogleTest filter; layer: whose test program runs,
    that of the file if empty.
    """

    file: str
    old: str
    new: str
    tests: str
    layer: str = ""

    @property
    def program(self) -> str:
        """The name of the test program."""
        return f"sheetmorph_{self.layer or self.file.split('/')[0]}_tests"

    @property
    def folder(self) -> str:
        """The folder of the kernel that the mistake is in."""
        return self.file.rpartition("/")[0]

    @property
    def label(self) -> str:
        """One line: the file and the first line that changes, as it becomes."""
        before, after = self.old.splitlines(), self.new.splitlines() or [""]
        pairs = zip(before + [""] * len(after), after)
        changed = next((new for old, new in pairs if new != old), after[0])
        return f"{self.file}: {' '.join(changed.split()) or 'a line is missing'}"

    def applied(self) -> str:
        """The source with the mistake in it.

        Raises ValueError if the text to replace does not occur exactly once.
        """
        text = (KERNEL / self.file).read_text("utf-8")
        count = text.count(self.old)
        if count != 1 or self.old == self.new:
            raise ValueError(f"{self.file}: {self.old!r} occurs {count} times; bring it up to date")
        return text.replace(self.old, self.new)
