# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose: the motions of all handles under a name, to come back to."""

from __future__ import annotations

from freecad.sheetmorph.objects.model import POSE
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.objects.proxy import ObjectProxy


class PoseProxy(ObjectProxy):
    """Proxy of a pose; nothing depends on it."""

    Type = POSE
    PROPERTIES = (Property("String", "Motions", "Pose", "Motions by region, as JSON", "", HIDDEN),)

    def execute(self, _obj) -> None:
        """Do nothing: a pose is only kept."""
