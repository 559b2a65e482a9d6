# SPDX-License-Identifier: LGPL-2.1-or-later
"""Return of large freed arrays to the operating system."""

from __future__ import annotations

import ctypes
from functools import cache

# From glibc's malloc.h. By default, glibc raises this threshold to the size of the largest freed
# array, and memory freed by the deck readers then stays with the process.
_M_MMAP_THRESHOLD, _SIZE = -3, 1 << 20


@cache
def give_back_large_arrays() -> None:
    """Fix the threshold once; do nothing if the C library has no such setting."""
    try:
        ctypes.CDLL(None).mallopt(_M_MMAP_THRESHOLD, _SIZE)
    except (AttributeError, OSError, TypeError):
        return
