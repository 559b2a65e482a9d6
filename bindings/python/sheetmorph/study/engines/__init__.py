# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the variants of a study are computed: others' engines, none of our own."""
