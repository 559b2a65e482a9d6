# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bridge between document and kernel: meshes, placements and recipes in, results out."""
