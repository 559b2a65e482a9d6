# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of Nastran."""

from __future__ import annotations

from .reader import SUFFIXES, read_nastran

__all__ = ["SUFFIXES", "read_nastran"]
