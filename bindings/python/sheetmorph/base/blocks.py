# SPDX-License-Identifier: LGPL-2.1-or-later
"""Block-wise work on many rows, so that temporary arrays stay small."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from .arrays import Floats

# Rows in a block.
CHUNK = 1 << 14


def chunks(count: int) -> Iterator[slice]:
    """Return slices that cover the rows 0 to count."""
    return (slice(at, min(at + CHUNK, count)) for at in range(0, count, CHUNK))


def in_blocks(work: Callable[[slice], Floats], count: int) -> Floats:
    """Apply work to slices of the rows and return the joined result, (count, ...)."""
    first = work(slice(0, min(CHUNK, count)))
    if len(first) == count:
        return first
    found = np.empty((count, *first.shape[1:]), first.dtype)
    found[: len(first)] = first
    for part in list(chunks(count))[1:]:
        found[part] = work(part)
    return found
