# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work on many rows block by block: what is made on the way stays small beside the rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from .arrays import Floats

# Rows that are worked on at once.
CHUNK = 1 << 14


def chunks(count: int) -> Iterator[slice]:
    """Slices that cover 0 .. count."""
    return (slice(at, min(at + CHUNK, count)) for at in range(0, count, CHUNK))


def in_blocks(work: Callable[[slice], Floats], count: int) -> Floats:
    """(count, ...) what work makes of slices that cover 0 .. count, put together."""
    first = work(slice(0, min(CHUNK, count)))
    if len(first) == count:
        return first
    found = np.empty((count, *first.shape[1:]), first.dtype)
    found[: len(first)] = first
    for part in list(chunks(count))[1:]:
        found[part] = work(part)
    return found
