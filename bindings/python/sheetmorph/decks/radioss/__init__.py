# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of Radioss."""

from __future__ import annotations

from .reader import SUFFIXES, read_radioss

__all__ = ["SUFFIXES", "read_radioss"]
