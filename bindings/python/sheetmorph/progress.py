# SPDX-License-Identifier: LGPL-2.1-or-later
"""How whatever takes long tells how far it is, everywhere in the package."""

from collections.abc import Callable

Progress = Callable[[float, str], bool]
"""progress(fraction from 0 to 1, task in words) returns whether to go on."""
