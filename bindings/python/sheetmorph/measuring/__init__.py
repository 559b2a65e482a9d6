# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measurements on arrays: strain, gaps, rigidity of features, element quality, sizes."""
