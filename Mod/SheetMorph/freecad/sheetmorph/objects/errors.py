# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong with a morph, for the person to read."""


class MorphError(ValueError):
    """A morph that cannot be computed; one sentence: where, what, what to do."""
