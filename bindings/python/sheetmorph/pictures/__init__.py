# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of morphs without a window: scenes of sheets, regions and arrows as PNG files."""

from .drawing import Painter, PictureError, draw, drawn, missing_tools
from .morphs import before_and_after, scene_of_answer, scene_of_recipe, with_room
from .scene import SHEET, Arrow, Colour, Scene, Sheet

__all__ = [
    "SHEET",
    "Arrow",
    "Colour",
    "Painter",
    "PictureError",
    "Scene",
    "Sheet",
    "before_and_after",
    "draw",
    "drawn",
    "missing_tools",
    "scene_of_answer",
    "scene_of_recipe",
    "with_room",
]
