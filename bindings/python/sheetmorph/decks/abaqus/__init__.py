# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of Abaqus and CalculiX."""

from __future__ import annotations

from .reader import SUFFIXES, read_abaqus

__all__ = ["SUFFIXES", "read_abaqus"]
