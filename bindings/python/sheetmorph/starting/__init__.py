# SPDX-License-Identifier: LGPL-2.1-or-later
"""Before the first recipe: a diagnosis of files, advice, and a recipe to start from."""

from __future__ import annotations

from .doctor import diagnose
from .first_recipe import starting_recipe

__all__ = ["diagnose", "starting_recipe"]
