# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat pattern of a bent sheet: kinematic, without a forming simulation."""

from .bends import Bend, KTable
from .pattern import FlatPattern, NotFlat, flat_patterns, patterns_of
from .writing import table_of

__all__ = ["Bend", "FlatPattern", "KTable", "NotFlat", "flat_patterns", "patterns_of", "table_of"]
