# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of Gmsh."""

from __future__ import annotations

from .reader import SUFFIXES, read_gmsh

__all__ = ["SUFFIXES", "read_gmsh"]
