# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors: regions described by their shape or name, and their conversion to vertices."""

from .following import Following
from .part_shape import PartShape
from .questions import Question
from .resolving import has_selectors, resolved, selected
from .words import Selector

__all__ = [
    "Following",
    "PartShape",
    "Question",
    "Selector",
    "has_selectors",
    "resolved",
    "selected",
]
