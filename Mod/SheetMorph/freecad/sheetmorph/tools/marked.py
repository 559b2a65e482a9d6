# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mark for texts that need translation, in modules without Qt; the caller translates them."""


def QT_TRANSLATE_NOOP(_context: str, text: str) -> str:
    """Return `text` unchanged; translation tools search for the name of this function."""
    return text
