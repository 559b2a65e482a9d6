# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of a document: stored with their includes, read again, and written as recipe parts."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.rest import RestPart
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.deck import told_thickness

PACKED = ".zip"


def keep_file(deck, file) -> None:
    """Store a sheetmorph file in a deck object, packed if it consists of several files."""
    paths = [Path(path).absolute() for path in file.files_read]
    if len(paths) == 1:
        deck.FileData = str(paths[0])
        return
    file.targets(paths[0].parent)  # raises FileError for an include outside the folder
    with tempfile.TemporaryDirectory() as folder:
        packed = os.path.join(folder, f"{paths[0].name}{PACKED}")
        with ZipFile(packed, "w") as archive:
            for path in paths:
                archive.write(path, os.path.relpath(path, paths[0].parent))
        deck.FileData = packed


@contextmanager
def opened(deck) -> Iterator[Any]:
    """Provide the sheetmorph file of a deck with its settings. Raises FileError."""
    with tempfile.TemporaryDirectory() as folder:
        path = deck.FileData
        if path.endswith(PACKED):
            with ZipFile(path) as archive:
                archive.extractall(folder)
            path = os.path.join(folder, deck.FileName)
        file = kernel.load().read_part(path)
        file.settings = settings_of(deck)
        yield file


def includes_of(deck) -> list[str]:
    """Return the paths of a deck's includes, relative to its folder."""
    if not deck.FileData.endswith(PACKED):
        return []
    with ZipFile(deck.FileData) as archive:
        return [name for name in archive.namelist() if name != deck.FileName]


def settings_of(deck) -> dict:
    """Return the recipe keys `passengers` and `joints` of a deck."""
    settings = json.loads(deck.Settings or "{}")
    if deck.BrokenJoints != "refuse":
        settings["joints"] = {**settings.get("joints", {}), "broken": deck.BrokenJoints}
    return settings


def deck_of(part, rest: RestPart):
    """Return the deck of a part with unchanged vertices, or None."""
    deck = part.Deck
    is_there = deck is not None and bool(deck.FileData) and rest.rows is not None
    return deck if is_there and rest.is_from_file else None


def whole(file, parts: list, rests: dict[str, RestPart], positions: dict) -> np.ndarray:
    """Return the positions (n, 3) of a deck's mesh from those of its parts, by object name."""
    found = file.mesh.points.copy()
    for part in parts:
        found[rests[part.Name].rows] = positions[part.Name]
    return found


def entry_of(deck, parts: list, entries: list[dict]) -> dict:
    """Return the recipe entry of a deck whose parts have `entries`.

    Raises ValueError if they differ in more than their names, because a recipe has one entry for
    all.
    """
    told = [told_thickness(part) for part in parts]
    given = [None if "thin" in entry else entry.get("thickness", 0.0) for entry in entries]
    left_out = ("name", "thickness") if given == told else ("name",)
    kept = [{key: entry[key] for key in entry if key not in left_out} for entry in entries]
    if any(one != kept[0] for one in kept):
        raise ValueError(
            f"The parts of {deck.FileName} differ in Mode, Thin, Thickness, SheetThickness or "
            "Poisson; a recipe has one entry for the whole deck: give them the same."
        )
    name = {} if deck.Split else {"name": entries[0]["name"]}
    split = {"split": deck.Split} if deck.Split else {}
    return {**name, "file": deck.FileName, **split, **kept[0], **settings_of(deck)}


def names_in_recipe(assembly, rests: dict[str, RestPart], names: dict[str, str]) -> dict[str, str]:
    """Return the recipe names of the parts of split decks, by their current names."""
    found = {}
    for part in model.parts(assembly):
        deck = deck_of(part, rests[part.Name])
        if deck is not None and deck.Split:
            found[names[part.Name]] = f"{Path(deck.FileName).stem}/{part.DeckPart}"
    return found


def renamed(entry: Any, names: dict[str, str]) -> Any:
    """Return a recipe, or a piece of it, with renamed parts."""
    if isinstance(entry, list):
        return [renamed(one, names) for one in entry]
    if not isinstance(entry, dict):
        return entry
    told = {key: renamed(value, names) for key, value in entry.items()}
    for key in ("part", "primary"):
        if isinstance(told.get(key), str):
            told[key] = names.get(told[key], told[key])
    return told
