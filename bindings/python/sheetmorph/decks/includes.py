# SPDX-License-Identifier: LGPL-2.1-or-later
"""The includes of a deck: search, reading, and output paths."""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Sequence
from pathlib import Path

from ..base.errors import FileError
from .model import Opener, Raw
from .text import DeckText

_DEEPEST = 50


class Included:
    """The files of a deck while it is read.

    folders are searched for includes besides the folders of the deck and of the including file.
    """

    def __init__(self, raw: Raw, path: Path, opener: Opener):
        self._raw = raw
        self._open = opener
        self._root = path.parent
        self._stack: list[Path] = []
        self.folders: list[Path] = []

    def first(self, path: Path) -> int:
        """Read the first file and return the index of its text. Raises FileError if it is empty."""
        file = self._read(path)
        if not self._raw.texts[file].data:
            raise FileError(path, "the file is empty", "export it again")
        return file

    def add(self, name: str, place: tuple[int, int]) -> int:
        """Read the file named at a place (file, line) and return the index of its text.

        Raises FileError if it is missing or includes itself.
        """
        path = self._found(name, place)
        if path.resolve() in self._stack:
            what = f'"{name}" includes itself'
            raise self._raw.error(place, what, "remove the INCLUDE")
        if len(self._stack) > _DEEPEST:
            raise self._raw.error(place, f"includes are over {_DEEPEST} deep", "flatten them")
        known = [text.path.resolve() for text in self._raw.texts]
        if path.resolve() in known:
            what = f'"{name}" is included twice'
            raise self._raw.error(place, what, "include it once: a node has one place")
        return self._read(path)

    def add_folder(self, name: str) -> None:
        """Add a search folder, relative to the deck."""
        self.folders += [self._root / one for one in _names_of(name.strip().replace("\\", "/"))]

    def enter(self, file: int) -> None:
        """Make this file the including one, until leave()."""
        self._stack.append(self._raw.texts[file].path.resolve())

    def leave(self) -> None:
        """Return to the file that includes this one."""
        self._stack.pop()

    def _read(self, path: Path) -> int:
        self._raw.texts.append(DeckText(path, self._open(path)))
        return len(self._raw.texts) - 1

    def _found(self, name: str, place: tuple[int, int]) -> Path:
        shown = name.strip()
        if not shown or "\0" in shown:
            raise self._raw.error(place, "an INCLUDE names no file", "name one")
        names = _names_of(shown.replace("\\", "/"))
        here = self._raw.texts[place[0]].path.parent
        for name in names:
            for folder in dict.fromkeys([here, self._root, *self.folders]):
                path = folder / name
                if _is_file(path):
                    return path
        what = f'the include "{names[0]}" does not exist'
        raise self._raw.error(place, what, "put the file next to the deck, or correct its name")


def _names_of(name: str) -> list[str]:
    """Return the possible meanings of a file name in a deck, whose bytes were read as Latin-1.

    UTF-8 precedes Latin-1. The disk can use either, and UTF-8 also with decomposed accents.
    """
    found = [name]
    raw = name.encode("latin-1", "replace")
    try:
        found.insert(0, raw.decode("utf-8"))
    except UnicodeDecodeError:
        pass
    forms = [unicodedata.normalize(form, one) for one in found for form in ("NFC", "NFD")]
    found += [one for one in forms if one not in found]
    found += [os.fsdecode(one.encode("latin-1")) for one in found if _is_latin(one)]
    found.append(os.fsdecode(raw))
    return list(dict.fromkeys(found))


def _is_latin(name: str) -> bool:
    return all(ord(letter) < 256 for letter in name)


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):  # a name that is too long, for example
        return False


def output_places(texts: Sequence[DeckText], out: Path) -> list[Path]:
    """Return the output paths of a deck whose first file is `out`, with the same relative layout.

    Raises FileError for an include outside the folder.
    """
    root = texts[0].path.parent.absolute()
    places = [out]
    for text in texts[1:]:
        relative = os.path.relpath(text.path.absolute(), root)
        if relative.startswith("..") or os.path.isabs(relative):
            what = f"this include of {texts[0].name} is outside its folder"
            raise FileError(text.path, what, "move it into or below the folder of the deck")
        places.append(out.parent / relative)
    return places
