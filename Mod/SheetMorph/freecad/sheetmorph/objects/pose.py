# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose: the motions of all handles under a name, to come back to."""

from __future__ import annotations

from freecad.sheetmorph.objects.model import POSE
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.objects.proxy import ObjectProxy
from freecad.sheetmorph.tools.poses import Pose, from_text, to_text


class PoseProxy(ObjectProxy):
    """Proxy of a pose; nothing depends on it."""

    Type = POSE
    PROPERTIES = (
        Property("String", "Motions", "Pose", "Motions by region, as JSON", "", HIDDEN),
        Property("LinkListHidden", "Regions", "Pose", "The regions, by their names", mode=HIDDEN),
    )

    def execute(self, _obj) -> None:
        """Do nothing: a pose is only kept."""


def keep_motions(pose, motions: Pose) -> None:
    """Store motions by `region.Name`, and links to the regions."""
    pose.Motions = to_text(motions)
    pose.Regions = [pose.Document.getObject(name) for name in sorted(motions)]


def kept_motions(pose) -> Pose:
    """Return the motions by `region.Name`.

    In a copy the regions have other names: there the links tell which they are. When a region is
    deleted its link vanishes: then the names do.
    """
    kept = from_text(pose.Motions)
    links = [region for region in pose.Regions if region is not None]
    if len(links) != len(kept):
        return kept
    return {region.Name: kept[name] for region, name in zip(links, sorted(kept))}
