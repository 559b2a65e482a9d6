# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a search has put in place of the word `auto` in a recipe, and ids in place of selectors."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any


@dataclass
class Found:
    """What a search put into a recipe: the entries; gap: the one used, mm; left_out: sentences on
    features that were found and not taken."""

    features: list[dict[str, Any]] = field(default_factory=list)
    contacts: list[dict[str, Any]] = field(default_factory=list)
    gap: float = 0.0
    left_out: list[str] = field(default_factory=list)

    def for_report(self, asked: Collection[str]) -> dict[str, Any]:
        """The sections that were asked for, as the report tells them."""
        told: dict[str, Any] = {"left_out": self.left_out}
        if "features" in asked:
            told["features"] = self.features
        if "contacts" in asked:
            told |= {"contacts": self.contacts, "gap": self.gap}
        return told


@dataclass
class Resolved:
    """A recipe with vertex ids alone; told: by place of a region what its selector came to: area
    (mm^2), distance (mm, of the farthest match from its point, or None), matches, remarks."""

    recipe: dict[str, Any]
    told: dict[str, dict[str, Any]] = field(default_factory=dict)
