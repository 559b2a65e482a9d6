# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of each variant, with fixed colours of the parts and a fixed view."""

from __future__ import annotations

from pathlib import Path

from ..pictures import Colour, Painter, PictureError, Scene, Sheet, with_room
from ..solving.answer import Answer

_SIZE = (240, 180)
_COLOURS: tuple[Colour, ...] = (
    *((0.43, 0.59, 0.75), (0.80, 0.55, 0.35), (0.47, 0.67, 0.47), (0.71, 0.47, 0.63)),
    *((0.59, 0.59, 0.43), (0.39, 0.65, 0.69), (0.75, 0.43, 0.41), (0.55, 0.51, 0.75)),
)
# Failures in a row after which no more pictures are tried.
_PATIENCE = 3


class Thumbnails:
    """The pictures of one worker; its painter starts with the first one and is started again if it
    ends."""

    def __init__(self) -> None:
        self._painter: Painter | None = None
        self._failed = 0
        self._why = ""

    def write(self, result: Answer, place: Path) -> str:
        """Write the picture of a result, or return why it cannot be drawn."""
        if self._failed < _PATIENCE:
            try:
                self._painter = self._painter or Painter()
                place.write_bytes(self._painter.draw(thumbnail(result)))
                self._failed, self._why = 0, ""
            except PictureError as error:
                self._failed, self._why = self._failed + 1, str(error)
                self.close()
        return self._why

    def close(self) -> None:
        """End the painter."""
        if self._painter is not None:
            self._painter.close()
        self._painter = None


def thumbnail(result: Answer) -> Scene:
    """Return a scene of all parts of a result, with room for their rest shape."""
    meshes = result.session.meshes
    parts = enumerate(meshes.items())
    rest = Scene([Sheet(mesh.points, mesh.triangles) for mesh in meshes.values()])
    sheets = [
        Sheet(result.positions[name], mesh.triangles, _COLOURS[k % len(_COLOURS)])
        for k, (name, mesh) in parts
    ]
    return with_room(Scene(sheets, size=_SIZE), rest)
