# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures for notebooks."""

from __future__ import annotations

import base64
import html
import tempfile
from pathlib import Path

from ..files.atomic import FileSet
from . import PictureError, Scene, draw


def picture_html(scene: Scene | None, title: str, told: str = "") -> str:
    """Return a title and an embedded picture of a scene, or a text if there is no scene."""
    line = f"<p><code>{html.escape(title)}</code></p>"
    if scene is not None:
        try:
            with tempfile.TemporaryDirectory(prefix="sheetmorph-") as folder:
                path = Path(folder) / "picture.png"
                with FileSet(is_own=True) as files:
                    draw([(scene, path)], files)
                    files.commit()
                data = base64.b64encode(path.read_bytes()).decode("ascii")
            return f'{line}<img src="data:image/png;base64,{data}" alt="{html.escape(title)}">'
        except PictureError as error:
            told = str(error)
    return line + "".join(f"<p>{html.escape(text)}</p>" for text in told.splitlines())
