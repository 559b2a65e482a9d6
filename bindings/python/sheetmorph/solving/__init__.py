# SPDX-License-Identifier: LGPL-2.1-or-later
"""The morph in the kernel: translation of a recipe, pre-processing, and the answer to a pose."""
