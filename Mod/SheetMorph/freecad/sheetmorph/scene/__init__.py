# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings in the 3D view; the only package that uses Coin."""
