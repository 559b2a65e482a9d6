# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pose: the motions of all handles and the sizes of form features, under a name."""

from __future__ import annotations

import json

from freecad.sheetmorph.objects.model import POSE
from freecad.sheetmorph.objects.orphans import MemberProxy
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.tools.poses import Pose, from_text, to_text


class PoseProxy(MemberProxy):
    """Proxy of a pose; no object depends on it."""

    Type = POSE
    PROPERTIES = (
        Property("String", "Motions", "Pose", "Motions by region, as JSON", "", HIDDEN),
        Property("String", "Sizes", "Pose", "Sizes of form features by region", "", HIDDEN),
        Property("LinkListHidden", "Regions", "Pose", "The moved regions", mode=HIDDEN),
    )


def keep_motions(pose, motions: Pose, sizes: dict[str, float]) -> None:
    """Store motions and sizes by `region.Name`, and links to the regions."""
    pose.Motions, pose.Sizes = to_text(motions), json.dumps(sizes)
    pose.Regions = [pose.Document.getObject(name) for name in sorted({*motions, *sizes})]


def kept_motions(pose) -> Pose:
    """Return the motions by `region.Name`."""
    return _by_present_name(pose, from_text(pose.Motions))


def kept_sizes(pose) -> dict[str, float]:
    """Return the sizes of form features by `region.Name`, 0 for the mesh; old poses have none."""
    return _by_present_name(pose, json.loads(pose.Sizes or "{}"))


def _by_present_name(pose, kept: dict) -> dict:
    """Return the stored data under the current names of the regions.

    In a copy the regions have other names, and the links identify them. A deleted region loses its
    link; then the names identify the others.
    """
    names = sorted({*from_text(pose.Motions), *json.loads(pose.Sizes or "{}")})
    links = [region for region in pose.Regions if region is not None]
    if len(links) != len(names):
        return kept
    return {region.Name: kept[name] for region, name in zip(links, names) if name in kept}
