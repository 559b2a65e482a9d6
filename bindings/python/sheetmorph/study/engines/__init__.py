# SPDX-License-Identifier: LGPL-2.1-or-later
"""Execution of the variants of a study with existing engines."""
