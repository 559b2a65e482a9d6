# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of morphs without a window: scenes of sheets, regions and arrows as PNG files."""

from .drawing import PictureError, draw
from .morphs import before_and_after, scene_of_answer, scene_of_recipe
from .scene import Arrow, Scene, Sheet

__all__ = [
    "Arrow",
    "PictureError",
    "Scene",
    "Sheet",
    "before_and_after",
    "draw",
    "scene_of_answer",
    "scene_of_recipe",
]
