# SPDX-License-Identifier: LGPL-2.1-or-later
"""The appearance of a study in the tree; a double click opens its panel."""

from freecad.sheetmorph.views.base import View


class StudyView(View):
    """A study of a morph."""

    icon = opened_by = "Study"
