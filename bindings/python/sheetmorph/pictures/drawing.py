# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes drawn by VTK on a virtual screen, in a separate process.

A crash of a graphics driver ends only that process and becomes an error message.
"""

from __future__ import annotations

import importlib.util
import os
import pickle
import select
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace

from ..base.errors import FailedError
from ..files.atomic import FileSet
from .scene import Scene

_SECONDS_FOR_ONE = 120.0
_BLOCK = 1 << 16


class PictureError(FailedError):
    """A picture that cannot be drawn on this machine, with the remedy."""


def draw(pictures: Sequence[tuple[Scene, Path]], files: FileSet | None = None) -> None:
    """Draw every scene into its PNG file; all files appear, or none.

    With files, the pictures join its set and the caller commits. Raises PictureError, FileError.
    """
    if files is None:
        with FileSet() as own:
            draw(pictures, own)
            own.commit()
        return
    temporaries = [files.temporary_for(path) for _, path in pictures]
    for temporary, image in zip(temporaries, drawn([scene for scene, _ in pictures])):
        temporary.write_bytes(image)


def drawn(scenes: Sequence[Scene]) -> list[bytes]:
    """Return every scene as a PNG image. Raises PictureError."""
    with Painter() as painter:
        return [painter.draw(scene) for scene in scenes]


class Painter:
    """A process that draws one scene after the other, for a ``with`` block.

    The process also ends with this one, however that happens. Raises PictureError.
    """

    def __init__(self) -> None:
        if missing := missing_tools():
            raise PictureError("no picture can be drawn", f"install {' and '.join(missing)}")
        self._said = tempfile.TemporaryFile()
        try:
            self.process = subprocess.Popen(
                [_interpreter(), str(Path(__file__).with_name("painter.py"))],
                env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._said,
            )
        except OSError as error:
            raise PictureError(
                "no picture can be drawn", f"check that Python starts programs ({error})"
            ) from None

    def __enter__(self) -> Painter:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def draw(self, scene: Scene) -> bytes:
        """Return a scene as a PNG image. Raises PictureError; the painter is useless then."""
        content = pickle.dumps(_plain(scene))
        deadline = time.monotonic() + _SECONDS_FOR_ONE
        assert self.process.stdin is not None
        with suppress(BrokenPipeError):
            self.process.stdin.write(len(content).to_bytes(8, "little") + content)
            self.process.stdin.flush()
        return self._read(int.from_bytes(self._read(8, deadline), "little"), deadline)

    def close(self) -> None:
        """End the process."""
        assert self.process.stdin is not None and self.process.stdout is not None
        with suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()
        self._said.close()

    def _read(self, count: int, deadline: float) -> bytes:
        assert self.process.stdout is not None
        found = bytearray()
        while len(found) < count:
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self.process.stdout], [], [], left)[0]:
                self.process.kill()
                raise PictureError("the picture took too long", "try a coarser mesh")
            more = os.read(self.process.stdout.fileno(), min(_BLOCK, count - len(found)))
            if not more:
                what = f"VTK could not draw the picture ({self._reason()})"
                raise PictureError(what, "check that python3-vtk9 works")
            found += more
        return bytes(found)

    def _reason(self) -> str:
        """Return the last words of a process that ended."""
        status = self.process.wait()
        self._said.seek(0)
        lines = self._said.read().decode(errors="replace").strip().splitlines()
        return lines[-1] if lines else f"status {status}"


def _interpreter() -> str:
    """Return the path of Python; in FreeCAD sys.executable may be FreeCAD."""
    if "python" in Path(sys.executable).name:
        return sys.executable
    return os.path.join(sys.base_prefix, "bin", "python{}.{}".format(*sys.version_info))


def _plain(scene: Scene) -> SimpleNamespace:
    """Return the scene as plain objects, for a program that does not load this package."""
    sheets = [SimpleNamespace(**vars(sheet)) for sheet in scene.sheets]
    arrows = [SimpleNamespace(**vars(arrow)) for arrow in scene.arrows]
    return SimpleNamespace(**{**vars(scene), "sheets": sheets, "arrows": arrows})


def missing_tools() -> list[str]:
    """Return the Debian packages without which nothing can be drawn here."""
    missing = []
    if importlib.util.find_spec("vtkmodules") is None:
        missing.append("python3-vtk9")
    if shutil.which("Xvfb") is None:
        missing.append("xvfb")
    return missing
