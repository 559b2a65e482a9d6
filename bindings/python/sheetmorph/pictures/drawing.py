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
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

from ..base.errors import FailedError
from ..files.atomic import FileSet
from .scene import Scene

_SECONDS_TO_START = 20.0
_SECONDS_FOR_ONE = 120.0


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
    require_tools()
    temporaries = [(scene, files.temporary_for(path)) for scene, path in pictures]
    with tempfile.TemporaryDirectory(prefix="sheetmorph-picture-") as folder, _screen() as screen:
        wanted = Path(folder) / "scenes"
        wanted.write_bytes(
            pickle.dumps([(_plain(scene), str(path)) for scene, path in temporaries])
        )
        _draw_on(screen, wanted, len(pictures))


def _plain(scene: Scene) -> SimpleNamespace:
    """Return the scene as plain objects, for a program that does not load this package."""
    sheets = [SimpleNamespace(**vars(sheet)) for sheet in scene.sheets]
    arrows = [SimpleNamespace(**vars(arrow)) for arrow in scene.arrows]
    return SimpleNamespace(**{**vars(scene), "sheets": sheets, "arrows": arrows})


def require_tools() -> None:
    """Check that the drawing tools are installed. Raises PictureError."""
    missing = []
    if importlib.util.find_spec("vtkmodules") is None:
        missing.append("python3-vtk9")
    if shutil.which("Xvfb") is None:
        missing.append("xvfb")
    if missing:
        raise PictureError("no picture can be drawn", f"install {' and '.join(missing)}")


def _draw_on(screen: str, wanted: Path, count: int) -> None:
    environment = {**os.environ, "DISPLAY": screen, "LIBGL_ALWAYS_SOFTWARE": "1"}
    try:
        done = subprocess.run(
            [sys.executable, str(Path(__file__).with_name("painter.py")), str(wanted)],
            env=environment,
            capture_output=True,
            timeout=_SECONDS_FOR_ONE * max(1, count),
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise PictureError("the picture took too long", "try a coarser mesh") from None
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        said = lines[-1] if lines else f"status {done.returncode}"
        what = f"VTK could not draw the picture ({said})"
        raise PictureError(what, "check that python3-vtk9 works")


@contextmanager
def _screen() -> Iterator[str]:
    """Provide the name of a new virtual screen, such as ":7", for the duration of the block."""
    reading, writing = os.pipe()
    command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1200x24", "-noreset"]
    try:
        server = subprocess.Popen(
            [*command, "-nolisten", "tcp"],
            pass_fds=[writing],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
    finally:
        os.close(writing)
    try:
        yield f":{_number_from(reading)}"
    finally:
        os.close(reading)
        server.terminate()
        server.wait()


def _number_from(reading: int) -> int:
    """Return the screen number that the server writes when it is ready."""
    told = b""
    while not told.endswith(b"\n"):
        ready, _, _ = select.select([reading], [], [], _SECONDS_TO_START)
        more = os.read(reading, 64) if ready else b""
        if not more:
            raise PictureError("no virtual screen starts", "check that Xvfb works")
        told += more
    return int(told)
