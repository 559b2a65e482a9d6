# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparison of paths across spellings, symbolic links and hard links."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from pathlib import Path


def identity(path: Path) -> Hashable:
    """Return a key that is equal for two paths of one existing or future file."""
    place = path.resolve()  # resolve() comes first because a folder in the path can be missing
    try:
        found = place.stat()
    except OSError:
        return place
    return found.st_dev, found.st_ino


def is_one_of(path: Path, others: Iterable[Path]) -> bool:
    """Return whether a path is one of the others."""
    return identity(path) in {identity(other) for other in others}
