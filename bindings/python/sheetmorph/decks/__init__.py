# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finite element decks: read as written, and copied byte for byte except for moved nodes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..base.errors import FileError
from .abaqus import SUFFIXES as ABAQUS
from .abaqus import read_abaqus
from .deck import Deck
from .dyna import SUFFIXES as DYNA
from .dyna import read_dyna
from .forms import require_form
from .gmsh import SUFFIXES as GMSH
from .gmsh import read_gmsh
from .heap import give_back_large_arrays
from .includes import output_places
from .model import Elements, Opener, Place
from .nastran import SUFFIXES as NASTRAN
from .nastran import read_nastran
from .radioss import SUFFIXES as RADIOSS
from .radioss import read_radioss
from .shells import Sheet, sheet_of

__all__ = [
    "Deck", "Elements", "Place", "Sheet", "is_deck", "output_places", "read_bytes", "read_deck",
    "sheet_of", "suffixes",
]  # fmt: skip

_FORMATS: dict[str, tuple[str, Callable[[Path, Opener], Deck]]] = {
    **dict.fromkeys(NASTRAN, ("Nastran", read_nastran)),
    **dict.fromkeys(DYNA, ("LS-DYNA", read_dyna)),
    **dict.fromkeys(ABAQUS, ("Abaqus", read_abaqus)),
    **dict.fromkeys(RADIOSS, ("Radioss", read_radioss)),
    **dict.fromkeys(GMSH, ("Gmsh", read_gmsh)),
}


def suffixes() -> list[str]:
    """Return the file name suffixes that read_deck() supports."""
    return sorted(_FORMATS)


def is_deck(path: Path) -> bool:
    """Return whether a file name is that of a deck."""
    return path.suffix.lower() in _FORMATS


def read_deck(path: Path, opener: Opener | None = None) -> Deck:
    """Read a deck with all its includes. Raises FileError, also for a wrong suffix.

    opener returns the bytes of a file; by default they come from disk.
    """
    give_back_large_arrays()
    form, reader = _FORMATS[path.suffix.lower()]
    opened = opener or read_bytes

    def checked(file: Path) -> bytes:
        data = opened(file)
        if file == path:
            require_form(path, data.removeprefix(b"\xef\xbb\xbf"), form)
        return data

    try:
        deck = reader(path, checked)
    except RecursionError:
        what = "cards refer to one another in an endless chain"
        raise FileError(path, what, "correct the deck") from None
    return deck


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file. Raises FileError if it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise FileError.of(path, error) from None
