# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipes of public real meshes, made from the data beside the repository.

    /usr/bin/python3 tests/real/recipes.py <folder> [name ...]

writes them into a folder; python3 -m sheetmorph runs them. Needs the staged package on
PYTHONPATH. Says so and writes nothing where the data is not at hand.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import classics
import laser_cut_box
import rear_wing
import riveted_support
import stainless_plate
import step_enclosure

REPOSITORY = Path(__file__).resolve().parents[2]
ABSENT = "the public meshes are not at hand; set SHEETMORPH_SHARED to the folder above data/"

MAKERS: dict[str, Callable[[Path], dict]] = {
    "support": riveted_support.support,
    "shelf": riveted_support.shelf_alone,
    "bracket": riveted_support.bracket_alone,
    "wing": rear_wing.wing,
    "end plate": rear_wing.end_plate_alone,
    "plate": stainless_plate.stainless_plate,
    "plate as it comes": partial(stainless_plate.stainless_plate, keys=stainless_plate.METRES),
    "box": laser_cut_box.box,
    "enclosure": step_enclosure.enclosure,
    "bar": partial(classics.classic, name="bar"),
    "cylinder": partial(classics.classic, name="cylinder"),
    "bumpy_plane": partial(classics.classic, name="bumpy_plane"),
}


def data_folder() -> Path | None:
    """The folder of the public meshes, None if it is not at hand."""
    shared = os.environ.get("SHEETMORPH_SHARED")
    folder = (Path(shared) if shared else REPOSITORY.parent / "shared") / "data"
    return folder if folder.is_dir() else None


def make(name: str) -> dict:
    """One of the recipes; raises FileNotFoundError where the data is not at hand."""
    folder = data_folder()
    if folder is None:
        raise FileNotFoundError(ABSENT)
    return MAKERS[name](folder)


def main(folder: Path, names: list[str]) -> None:
    """Writes the recipes with these names, all if there are none."""
    if data_folder() is None:
        print(f"Nothing written: {ABSENT}.")
        return
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or MAKERS:
        path = folder / f"{name.replace(' ', '_')}.json"
        path.write_text(json.dumps(make(name)), encoding="utf-8")
        print(path)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
