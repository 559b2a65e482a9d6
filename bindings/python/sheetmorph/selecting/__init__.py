# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions that say what they are: selectors, and the one place that turns them into vertices."""

from .resolving import has_selectors, resolved, selected
from .part_shape import PartShape
from .words import Selector

__all__ = ["PartShape", "Selector", "has_selectors", "resolved", "selected"]
