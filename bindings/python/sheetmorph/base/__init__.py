# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every room uses: errors, arrays, meshes of parts, words and the compiled kernel."""
