# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for form features and contacts: on meshes in memory, in files, and for recipes."""

from __future__ import annotations

from .findings import FindPart, Findings, find_schema
from .options import FindOptions
from .reading import find_in_files, parts_of_files
from .search import find

__all__ = [
    "FindOptions",
    "FindPart",
    "Findings",
    "find",
    "find_in_files",
    "find_schema",
    "parts_of_files",
]
