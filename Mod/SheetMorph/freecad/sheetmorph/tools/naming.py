# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whom a sentence names."""

from __future__ import annotations

import re
from collections.abc import Iterable


def named_in(sentence: str, labels: Iterable[str]) -> list[str]:
    """Return the labels that a sentence names as whole words, in its order.

    Of two labels at one place, `Tip` and `Tip 2`, the longer one is meant.
    """
    places: dict[int, str] = {}
    for label in sorted(filter(None, labels), key=len):
        for found in re.finditer(rf"(?<!\w){re.escape(label)}(?!\w)", sentence):
            places[found.start()] = label
    return list(dict.fromkeys(places[start] for start in sorted(places)))
