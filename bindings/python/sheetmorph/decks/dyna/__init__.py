# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of LS-DYNA."""

from __future__ import annotations

from .reader import SUFFIXES, assumed_options, read_dyna

__all__ = ["SUFFIXES", "assumed_options", "read_dyna"]
