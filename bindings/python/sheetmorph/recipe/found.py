# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of the search for "auto" entries and of selectors."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any


@dataclass
class Found:
    """Entries that a search found.

    gap is the contact gap of the search, mm. left_out has sentences on features that were found but
    not used.
    """

    features: list[dict[str, Any]] = field(default_factory=list)
    contacts: list[dict[str, Any]] = field(default_factory=list)
    gap: float = 0.0
    left_out: list[str] = field(default_factory=list)

    def for_report(self, asked: Collection[str]) -> dict[str, Any]:
        """Return the requested sections as the report has them."""
        told: dict[str, Any] = {"left_out": self.left_out}
        if "features" in asked:
            told["features"] = self.features
        if "contacts" in asked:
            told |= {"contacts": self.contacts, "gap": self.gap}
        return told


@dataclass
class Resolved:
    """A recipe with vertex ids only.

    The dict `told` maps the place of a region to its selector result. The result has the area in
    mm^2, the distance in mm of the farthest match from its point or None, matches and remarks.
    """

    recipe: dict[str, Any]
    told: dict[str, dict[str, Any]] = field(default_factory=dict)
