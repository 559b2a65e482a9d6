# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever an export writes is asked for, or refused, where a file of the user stands."""

import os
from collections.abc import Callable
from pathlib import Path

from freecad.sheetmorph import api
from freecad.sheetmorph.tests import test_cad, test_decks, test_files

THEIRS = b"this is the only copy\n"


class Exports:
    """For tests with an assembly: all exports of it."""

    def ways(self) -> list[Callable[[str], object]]:
        """Return what exports to a folder, one function a way."""
        return [
            lambda folder: api.write_parts(self.assembly, folder),
            lambda folder: api.certify(self.assembly, folder),
            lambda folder: api.export_recipe(self.assembly, os.path.join(folder, "morph.json")),
        ]

    def places(self, number: int, folder: Path) -> set[str]:
        """Return what the question of a way would name in a folder."""
        place = folder / "morph.json" if number == 2 else folder
        return {str(found.relative_to(folder)) for found in api.in_the_way(self.assembly, place)}

    def check_all(self) -> None:
        """Put a file of the user at each place that an export writes, one at a time."""
        for number, export in enumerate(self.ways()):
            empty = Path(self.folder) / f"empty {number}"
            empty.mkdir()
            export(str(empty))
            written = {str(p.relative_to(empty)) for p in empty.rglob("*") if p.is_file()}
            self.assertGreater(len(written), 1)
            self.assertEqual(self.places(number, empty), set())
            for name in sorted(written):
                with self.subTest(way=number, name=name):
                    taken = Path(self.folder) / f"taken {number} {len(os.listdir(self.folder))}"
                    theirs = taken / name
                    theirs.parent.mkdir(parents=True)
                    theirs.write_bytes(THEIRS)
                    self.assertEqual(self.places(number, taken), {name})
                    with self.assertRaisesRegex(ValueError, "already exists"):
                        export(str(taken))
                    self.assertEqual(theirs.read_bytes(), THEIRS)


class TestMeshes(Exports, test_files.FileTest):
    def test_no_file_of_the_user_is_written_over(self):
        self.import_and_lift(self.points)
        self.document.recompute()
        self.check_all()


class TestDecks(Exports, test_decks.DeckTest):
    def test_no_file_of_the_user_is_written_over(self):
        self.bent()
        self.check_all()


class TestShapes(Exports, test_cad.CadTest):
    def test_no_file_of_the_user_is_written_over(self):
        (part,) = api.add_shape(self.assembly, self.add(test_cad.plate()), mesh=test_cad.SIZES)
        self.bend(part)
        api.deformed_shape(part)
        self.check_all()
