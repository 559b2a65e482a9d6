# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a pose in the tree; a double click applies it."""

from freecad.sheetmorph.views.base import View


class PoseView(View):
    """A saved pose."""

    icon = "Pose"
    opened_by = "ApplyPose"
