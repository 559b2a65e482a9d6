# SPDX-License-Identifier: LGPL-2.1-or-later
"""Generates the example assemblies: `python3 generate.py [folder]` (default: beside this file).

Needs numpy and scipy. The generated files are part of the repository; run it after a change here.
"""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from shapes import body_panels, bracket, door_mirror, welded_frame  # noqa: E402
from shapes.output import recipe_text, write_example, write_text  # noqa: E402

EXAMPLES = (door_mirror, body_panels, welded_frame)


def main(folder: Path) -> None:
    for module in EXAMPLES:
        example = module.example()
        for path in write_example(example, folder / example.folder):
            print(path)
    place = folder / "bracket"
    print(write_text(place / "bracket.inp", bracket.deck(8, 6)))
    print(write_text(place / "recipe.json", recipe_text(bracket.recipe())))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
