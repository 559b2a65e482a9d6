# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data of a deck that become stale when coordinates change, grouped by card."""

from __future__ import annotations

from typing import Any

from .deck import Deck

_SHOWN = 50


def stale_report(deck: Deck) -> list[dict[str, Any]]:
    """Return for each card and reason the file, the count, and the first ids and lines."""
    found: dict[tuple[str, str, int], list[tuple[int, int]]] = {}
    for place in deck.raw.stale:
        key = (place.card, place.what, place.file)
        found.setdefault(key, []).append((place.number, place.line + 1))
    return [
        {
            "card": card,
            "what": what,
            "file": deck.texts[file].name,
            "count": len(rows),
            "ids": [number for number, _ in rows[:_SHOWN]],
            "lines": [line for _, line in rows[:_SHOWN]],
        }
        for (card, what, file), rows in found.items()
    ]
