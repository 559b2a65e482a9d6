# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphs: from a recipe file, from meshes in memory, live frames, and a builder in Python."""

from __future__ import annotations

from .morph import Morph, open_files
from .session import Session

__all__ = ["Morph", "Session", "open_files"]
