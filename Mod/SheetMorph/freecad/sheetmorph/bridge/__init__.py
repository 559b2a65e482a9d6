# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between document and kernel: meshes, placements and recipes read, results brought back."""
