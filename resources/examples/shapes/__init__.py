# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generated sheet-metal parts: planar meshing, folding into space, assemblies."""
