# SPDX-License-Identifier: LGPL-2.1-or-later
"""Version of the package."""

__version__ = "0.2.0"
