# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether two paths are one file, by any spelling, link or hard link."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from pathlib import Path


def identity(path: Path) -> Hashable:
    """Return what two paths share if they are one file, or would be once they exist."""
    place = path.resolve()  # first: a folder on the way to it need not exist yet
    try:
        found = place.stat()
    except OSError:
        return place
    return found.st_dev, found.st_ino


def is_one_of(path: Path, others: Iterable[Path]) -> bool:
    """Return whether a path is one of the others."""
    return identity(path) in {identity(other) for other in others}
