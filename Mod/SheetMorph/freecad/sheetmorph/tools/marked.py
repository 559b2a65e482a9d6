# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks texts for translation where no Qt may be imported; who shows them translates them."""


def QT_TRANSLATE_NOOP(_context: str, text: str) -> str:
    """Return `text` as it is; the name is what the translation tools look for."""
    return text
