# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large arrays that are done with go back to the system, also after many of them."""

from __future__ import annotations

import ctypes
from functools import cache

# Of glibc's malloc.h. Left alone, it raises the size from which on memory is given back to that of
# the largest array freed so far, and what deck readers leave behind then stays with the process.
_M_MMAP_THRESHOLD, _SIZE = -3, 1 << 20


@cache
def give_back_large_arrays() -> None:
    """Sets it once; nothing where the C library has no such setting."""
    try:
        ctypes.CDLL(None).mallopt(_M_MMAP_THRESHOLD, _SIZE)
    except (AttributeError, OSError, TypeError):
        return
