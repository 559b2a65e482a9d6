# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person reads them."""

from __future__ import annotations


def counted(number: int, one: str, many: str) -> str:
    """`1 vertex stands`, `2 vertices stand`."""
    return f"{number} {one if number == 1 else many}"
