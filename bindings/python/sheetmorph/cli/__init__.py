# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python3 -m sheetmorph init | show | check | run | resolve | find | ..."""

from __future__ import annotations

from .arguments import parser
from .entry import main

__all__ = ["main", "parser"]
