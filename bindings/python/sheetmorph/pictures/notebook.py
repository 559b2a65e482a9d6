# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures for notebooks."""

from __future__ import annotations

from ..base.pages import page
from .drawing import PictureError, drawn
from .scene import Scene


def picture_html(scene: Scene | None, title: str, told: str = "") -> str:
    """Return a title and an embedded picture of a scene, or a text if there is no scene."""
    image = None
    if scene is not None:
        try:
            (image,) = drawn([scene])
        except PictureError as error:
            told = str(error)
    lines = [] if image else told.splitlines()
    return page("pictures/notebook.html", title=title, image=image, lines=lines)
