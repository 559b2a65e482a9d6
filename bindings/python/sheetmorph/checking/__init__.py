# SPDX-License-Identifier: LGPL-2.1-or-later
"""Complete checks of a recipe before any computation; selectors and "auto" become vertex ids."""

from __future__ import annotations

from .checking import check_entries, check_pose, check_with_meshes, prepare, validate, with_ids

__all__ = ["check_entries", "check_pose", "check_with_meshes", "prepare", "validate", "with_ids"]
