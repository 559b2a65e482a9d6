# SPDX-License-Identifier: LGPL-2.1-or-later
"""GRID cards of moved nodes rewritten in large fields, with 16 in place of 8 characters."""

from __future__ import annotations

from collections.abc import Sequence

from .text import DeckText


def is_small_grid(text: DeckText, line: int) -> bool:
    """Return whether a line is a GRID card in columns of 8, without tabs."""
    shown = _body(text, line)
    return shown[:8].upper().strip() == "GRID" and "\t" not in shown and "," not in shown[:10]


def wide_grid(text: DeckText, line: int, numbers: Sequence[str]) -> tuple[int, int, bytes]:
    """Return (offset, length, bytes) that replace a small GRID card by a large one."""
    body = _body(text, line)
    fields = [body[8 + 8 * k : 16 + 8 * k].strip() for k in range(8)]
    x, y, z = numbers
    first = "".join(f"{one:>16}" for one in (fields[0], fields[1], x, y))
    second = "".join(f"{one:>16}" for one in (z, *fields[5:8])).rstrip()
    begin, end = int(text.begins[line]), int(text.ends[line])
    newline = "\r\n" if text.data[end : end + 2] == b"\r\n" else "\n"
    new = f"GRID*   {first}*{newline}*       {second}"
    has_comment = begin + len(body) < end
    return begin, len(body), (new + " " * has_comment).encode("latin-1")


def _body(text: DeckText, line: int) -> str:
    return text.line(line).split("$", 1)[0]
