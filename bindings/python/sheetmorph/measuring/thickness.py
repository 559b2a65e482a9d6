# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness of a thin solid, at rest and deformed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Floats
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh

if TYPE_CHECKING:
    from .. import _core


def thickness_change(
    rest: PartMesh, solid: _core.ThinSolid, positions: Floats
) -> _core.ThicknessChange:
    """Return how the thickness of a solid changes from rest to positions (n, 3), mm."""
    core = load_kernel()
    mesh = core.TriangleMesh(rest.points, rest.triangles)
    found: _core.ThicknessChange = core.thickness_change(mesh, solid, np.array(positions))
    return found
