# SPDX-License-Identifier: LGPL-2.1-or-later
"""Public decks, each bent by 5 % of its size through the whole way of a run."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sheetmorph import CertificateError, FileError, RecipeError, run
from sheetmorph.decks import Deck, read_deck, sheet_of
from sheetmorph.decks.placing import require_places

SHARED = Path(__file__).parents[3] / "shared" / "data" / "09-decks"
CALCULIX = Path("/usr/share/doc/calculix-ccx-test/examples/test")
SHARE = 0.05
# The first and the last of these shares of the longest side are held and moved.
_ENDS = 0.12


def all_decks(folder: Path) -> Iterator[tuple[str, Path]]:
    """(set, deck) of all public decks; packed ones are unpacked into a folder."""
    for name in ("nastran", "ls-dyna", "radioss"):
        if (SHARED / name).is_dir():
            for path in sorted((SHARED / name).iterdir()):
                yield name, path
    for path in sorted(CALCULIX.glob("*.inp*")) if CALCULIX.is_dir() else ():
        if path.suffix == ".gz":
            target = folder / path.stem
            target.write_bytes(gzip.decompress(path.read_bytes()))
            yield "calculix", target
        elif path.suffix == ".inp":
            yield "calculix", path


def with_stand_ins(path: Path, folder: Path) -> Path:
    """A copy of a deck beside which includes that are missing are empty files."""
    target = folder / path.name
    target.write_bytes(path.read_bytes())
    for _ in range(200):
        try:
            read_deck(target)
            return target
        except FileError as error:
            name = error.what.split('"')[1] if "is not there" in error.what else ""
            if not name:
                return target
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(b"")
    return target


def bent(path: Path, folder: Path) -> str:
    """ "bent", or why a deck is not; what must hold is asserted."""
    try:
        deck = read_deck(path)
        require_places(deck)
        sheet = sheet_of(deck)
    except FileError as error:
        return f"refused: {error.what.split(chr(34))[0].strip()}"
    if not len(sheet.triangles):
        return "no shells"
    place = recipe_of(path, deck, sheet.nodes, folder)
    if place is None:
        return "its nodes are in one place"
    try:
        report = run(place, folder / "out")
    except RecipeError as error:
        return f"refused: {error.faults[0].what}"
    except FileError as error:
        return f"refused: {error.what}"
    except CertificateError as error:
        return f"not certified: {error}"
    check(deck, read_deck(folder / "out" / path.name), report)
    return "bent"


def recipe_of(path: Path, deck: Deck, nodes: np.ndarray, folder: Path) -> Path | None:
    """One end stays, the other goes sideways; loose pieces go along."""
    points = deck.points[nodes]
    side = np.ptp(points, axis=0)
    size = float(np.linalg.norm(side))
    axis, across = int(side.argmax()), int(side.argmin())
    if not size > 0.0:
        return None
    along = (points[:, axis] - points[:, axis].min()) / side[axis]
    locked = np.isin(deck.ids[nodes], sorted(deck.raw.locked))
    ends = [deck.ids[nodes[(along <= _ENDS) & ~locked]], deck.ids[nodes[(along >= 1 - _ENDS)]]]
    held, moved = ([int(one) for one in end] for end in ends)
    if not held or not moved:
        return None
    shift = np.zeros(3)
    shift[across] = SHARE * size
    entry = {
        "sheetmorph": 1,
        "parts": [{"name": "deck", "file": str(path), "joints": {"broken": "tell"}}],
        "fixed": [{"part": "deck", "vertices": held}],
        "handles": [{"name": "end", "part": "deck", "vertices": moved}],
        "pose": {"end": {"translation": shift.tolist()}},
        "unheld": "along",
    }
    place = folder / "recipe.json"
    place.write_text(json.dumps(entry))
    return place


def masked(deck: Deck, file: int) -> list[bytes]:
    """The lines of a file of a deck without the numbers of its nodes, and without the blanks and
    commas that a short line gets."""
    text = deck.texts[file]
    spans = [
        (int(begin), int(begin) + int(width))
        for block in deck.raw.blocks
        if block.file == file
        for begin, width in zip(block.begins.reshape(-1), block.widths.reshape(-1))
    ]
    pieces, done = [], 0
    for begin, end in sorted(spans):
        pieces.append(text.data[done:begin])
        done = max(done, end)
    rest = b"".join([*pieces, text.data[done:]])
    return [line.translate(None, b" ,\t\r") for line in rest.split(b"\n")]


def check(before: Deck, after: Deck, report: dict) -> None:
    """Only coordinates changed; nodes, elements and what stays are as they were."""
    assert np.array_equal(before.ids, after.ids)
    assert np.isfinite(after.points).all()
    assert len(before.texts) == len(after.texts)
    for file in range(len(before.texts)):
        assert masked(before, file) == masked(after, file)
    for one, other in zip(before.elements, after.elements):
        assert one.kind == other.kind and np.array_equal(one.nodes, other.nodes)
    (told,) = report["decks"]
    assert int((before.points != after.points).any(axis=1).sum()) <= told["moved"]
    left = after.find(np.array(told["left"], dtype=np.int64))
    assert np.array_equal(before.points[left], after.points[left])
    part = report["parts"][0]
    assert part["largest_displacement"] > 0.0
    width = np.abs(after.points).max(initial=1.0)
    assert part["file"]["error"] <= 1e-4 * width, part["file"]
