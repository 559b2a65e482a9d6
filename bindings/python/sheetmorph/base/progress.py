# SPDX-License-Identifier: LGPL-2.1-or-later
"""The progress callback of every long operation in the package."""

from collections.abc import Callable

Progress = Callable[[float, str], bool]
"""progress(fraction from 0 to 1, description) returns whether to continue."""
