# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `copy`: read files and write them again unchanged, to show what a morph keeps."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from ..base.errors import Fault, FileError, RecipeError
from ..decks import Deck, is_deck, output_places, read_deck
from ..files import FileSet, read_part
from ..files.places import Places
from ..joint_files import JointFile, is_joint_file, read_joint_file
from .output import Outcome


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Copy the files and return a sentence for each."""
    sentences = copy_files(wanted.files, wanted.output, files)
    return Outcome(sentences, {"files": sentences})


def copy_files(paths: Sequence[str | Path], out: str | Path, files: FileSet) -> list[str]:
    """Copy files, and decks with their includes, into a folder; return a sentence for each.

    Either all files are written or none. Raises FileError, RecipeError, OSError.
    """
    folder = Path(out)
    work = [_Copy(Path(path), folder) for path in paths]
    targets = [place for copy in work for place in copy.places]
    twice = {place for place in targets if targets.count(place) > 1}
    if twice:
        what = f"two of the files would be written as {sorted(twice)[0]}"
        raise RecipeError([Fault("-o", what, "copy them into different folders")])
    read = [path for copy in work for path in copy.read]
    places = Places(read, folder, targets, None)
    places.check()
    places.require_ours(files)
    with files:
        folder.mkdir(parents=True, exist_ok=True)
        told = [copy.write(files) for copy in work]
        files.commit()
    return told


class _Copy:
    """One file to copy, with the paths that it reads and writes."""

    def __init__(self, path: Path, folder: Path):
        self.read = [path]
        self.places = [folder / path.name]
        self._deck: Deck | None = None
        self._joints = read_joint_file(path) if is_joint_file(path) else None
        if self._joints is not None:
            pass
        elif is_deck(path):
            self._deck = read_deck(path)
            self.read = [text.path for text in self._deck.texts]
            self.places = output_places(self._deck.texts, self.places[0])
        else:
            self._file = read_part(path)
            self.places = [folder / self._file.output_name]

    def write(self, files: FileSet) -> str:
        if self._joints is not None:
            return self._write_joints(files, self._joints)
        if self._deck is None:
            self._file.write_into(files, self.places[0], self._file.mesh.points)
            return f"{self.places[0]}: {len(self._file.mesh.points)} vertices"
        same = True
        for number, place in enumerate(self.places):
            place.parent.mkdir(parents=True, exist_ok=True)
            temporary = files.temporary_for(place)
            with files.named(temporary):
                with temporary.open("wb") as written:
                    self._deck.save(self._deck.points, number, written)
                same = same and _holds(temporary, self._deck.texts[number].whole)
        if not same:
            what = "the copy differs from the original"
            raise FileError(self.read[0], what, "please report it with this deck")
        return _told(self._deck, self.places[0])

    def _write_joints(self, files: FileSet, joints: JointFile) -> str:
        place = self.places[0]
        temporary = files.temporary_for(place)
        with files.named(temporary), temporary.open("wb") as written:
            joints.save(joints.points, joints.directions, written)
        count, points = len(joints.joints), len(joints.points)
        told = f"{place}: {joints.form}, {count} joints, {points} points, every byte as it was"
        return "; ".join([told, *joints.notes])


def _holds(path: Path, data: bytes) -> bool:
    """Return whether a file contains exactly these bytes; it is read in blocks."""
    if path.stat().st_size != len(data):
        return False
    whole, size = memoryview(data), 1 << 20
    with path.open("rb") as file:
        return all(file.read(size) == whole[at : at + size] for at in range(0, len(data), size))


def _told(deck: Deck, place: Path) -> str:
    counts: dict[str, int] = {}
    for block in deck.elements:
        counts[block.kind] = counts.get(block.kind, 0) + len(block.ids)
    words = [f"{count} {_WORDS[kind]}" for kind, count in counts.items()]
    files = f", {len(deck.texts)} files" if len(deck.texts) > 1 else ""
    elements = f", {', '.join(words)}" if words else ""
    nodes = int((deck.ids > 0).sum())
    told = f"{place}: {deck.form}, {nodes} nodes{elements}{files}, every byte as it was"
    placing = [
        f"{card.card} {card.what}: the deck cannot be deformed" for card in deck.raw.placing[:1]
    ]
    return "; ".join([told, *deck.notes, *placing])


_WORDS = {
    "shell": "shells",
    "solid": "solids",
    "line": "beams and springs",
    "rigid": "rigid elements",
    "constraint": "constraints",
    "mass": "masses",
    "weld": "welds",
    "frame": "systems by nodes",
}
