# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks: a part of every property, everything kept that they include, certified when written."""

import json
import os
import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.rest import read_rest
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tests import support

ALONG, ACROSS, APART = 11, 4, 3.0


def plates() -> tuple[str, str]:
    """The text of a deck of two plates, one above the other, joined by bushes, and its include."""
    head = ["BEGIN BULK", "INCLUDE 'parts/doubler.bdf'", "$ Femap Property 7 : skin"]
    head += ["PSHELL,7,1,1.5", "PSHELL,8,1,2.5", "MAT1,1,210000.,,.3,7.85-9"]
    skin, doubler = (plate(first, pid, z) for first, pid, z in ((1, 7, 0.0), (101, 8, APART)))
    row = [ACROSS * k + 2 for k in range(ALONG)]
    head += [f"CBUSH,{500 + k},9,{k},{k + 100}" for k in row]
    return "\n".join([*head, *skin, "ENDDATA", ""]), "\n".join([*doubler, ""])


def plate(first: int, pid: int, z: float) -> list[str]:
    """Nodes from a number on, and quads between them."""
    lines = [
        f"GRID*   {first + ACROSS * i + j:16d}{'':16}{10.0 * i:16.4f}{10.0 * j:16.4f}\n*{z:23.4f}"
        for i in range(ALONG)
        for j in range(ACROSS)
    ]
    for i in range(ALONG - 1):
        for j in range(ACROSS - 1):
            k = first + ACROSS * i + j
            lines.append(f"CQUAD4,{k},{pid},{k},{k + ACROSS},{k + ACROSS + 1},{k + 1}")
    return lines


class DeckTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.path = os.path.join(self.folder, "plates.bdf")
        os.makedirs(os.path.join(self.folder, "parts"))
        for name, text in zip(("plates.bdf", "parts/doubler.bdf"), plates()):
            with open(os.path.join(self.folder, name), "w", encoding="ascii") as out:
                out.write(text)
        self.assembly = api.create_assembly(self.document)
        self.output = os.path.join(self.folder, "out")

    def bent(self, height: float = 12.0) -> list:
        """The deck imported, held on its left, lifted on its right; the doubler follows."""
        skin, doubler = api.import_deck(self.assembly, self.path)
        count = len(api.rest_mesh(skin)[0])
        api.add_fixed(self.assembly, skin, range(2 * ACROSS))
        handle = api.add_handle(self.assembly, skin, range(count - ACROSS, count), "Tip")
        api.set_motion(handle, (0, 0, height))
        row = [ACROSS * k + 1 for k in range(ALONG)]
        api.add_contact(self.assembly, (skin, row), (doubler, row))
        self.document.recompute()
        return [skin, doubler]

    def written(self, name: str) -> bytes:
        with open(os.path.join(self.output, name), "rb") as file:
            return file.read()


class TestImport(DeckTest):
    def test_a_part_of_every_property_with_name_number_and_thickness(self):
        parts = api.import_deck(self.assembly, self.path)
        self.assertEqual([part.Label for part in parts], ["skin", "PID 8"])
        titles = [[one.Label for one in part.Shells] for part in parts]
        self.assertEqual(titles, [["skin · PID 7 · 1.5 mm"], ["PID 8 · 2.5 mm"]])
        (shells,) = parts[0].Shells
        self.assertEqual((shells.Number, shells.Elements, shells.Material), (7, 30, "MAT1 1"))
        (deck,) = model.decks(self.assembly)
        told = (deck.FileName, deck.Format, deck.Nodes, deck.Elements)
        self.assertEqual(told, ("plates.bdf", "Nastran", 88, 71))

    def test_the_sheet_is_as_thick_as_the_deck_says(self):
        parts = api.import_deck(self.assembly, self.path)
        self.assertEqual([part.SheetThickness.Value for part in parts], [1.5, 2.5])
        (whole,) = api.import_deck(self.assembly, self.path, "")
        self.assertEqual(whole.SheetThickness.Value, 2.0)

    def test_quads_are_known_as_quads(self):
        skin, _ = api.import_deck(self.assembly, self.path)
        faces = read_rest(skin).faces
        self.assertEqual(faces.shape, (30, 4))
        self.assertEqual(faces[0].tolist(), [0, ACROSS, ACROSS + 1, 1])

    def test_properties_that_share_nodes_are_one_part(self):
        with open(self.path, encoding="ascii") as file:
            text = file.read()
        with open(self.path, "w", encoding="ascii") as out:
            out.write(text.replace("CQUAD4,1,7", "CQUAD4,1,6"))
        parts = api.import_deck(self.assembly, self.path)
        self.assertEqual([part.Label for part in parts], ["plates 1", "PID 8"])
        self.assertEqual([one.Number for one in parts[0].Shells], [6, 7])

    def test_labels_of_pieces_of_one_property_tell_which_they_are(self):
        place = os.path.join(self.folder, "parts", "doubler.bdf")
        with open(place, "w", encoding="ascii") as out:
            out.write(plates()[1].replace(",8,", ",7,"))
        parts = api.import_deck(self.assembly, self.path)
        self.assertEqual([part.Label for part in parts], ["skin", "skin (plates 2)"])
        (shells,) = parts[1].Shells
        self.assertEqual(shells.Label, "skin · PID 7 · 1.5 mm (plates 2)")

    def test_what_is_no_deck_is_refused_in_words(self):
        path = os.path.join(self.folder, "strip.obj")
        support.write_obj(path, *support.strip())
        with self.assertRaisesRegex(ValueError, "not a deck; use import_part"):
            api.import_deck(self.assembly, path)

    def test_deleting_its_parts_deletes_the_deck(self):
        parts = api.import_deck(self.assembly, self.path)
        for part in parts:
            api.remove(part)
        kinds = {objects.kind(obj) for obj in self.document.Objects} - {""}
        self.assertEqual(kinds, {model.ASSEMBLY, model.DEFORMATION})


class TestWriting(DeckTest):
    def test_nothing_moved_is_the_same_to_the_byte(self):
        api.import_deck(self.assembly, self.path)
        os.remove(self.path)
        api.write_parts(self.assembly, self.output)
        for name, text in zip(("plates.bdf", "parts/doubler.bdf"), plates()):
            self.assertEqual(self.written(name), text.encode())

    def test_both_parts_are_written_into_one_deck(self):
        self.bent()
        api.write_parts(self.assembly, self.output)
        file = kernel.load().read_part(os.path.join(self.output, "plates.bdf"))
        heights = file.mesh.points[:, 2].reshape(2, ALONG, ACROSS)
        np.testing.assert_allclose(heights[0, -1], 12.0, atol=1e-9)
        self.assertGreater(heights[1, -1].min(), APART + 10.0)
        report = json.loads(self.written("report.json"))
        self.assertEqual(report["decks"][0]["joints"]["count"], ALONG)

    def test_a_joint_that_comes_apart_is_an_error_until_it_is_only_to_be_told(self):
        skin, doubler = self.bent(30.0)
        for contact in model.contacts(self.assembly):
            api.remove(contact)
        self.document.recompute()
        with self.assertRaisesRegex(ValueError, "CBUSH .* came apart"):
            api.write_parts(self.assembly, self.output)
        self.assertFalse(os.path.exists(os.path.join(self.output, "plates.bdf")))
        skin.Deck.BrokenJoints = "tell"
        api.write_parts(self.assembly, self.output)
        self.assertTrue(os.path.exists(os.path.join(self.output, "parts", "doubler.bdf")))

    def test_the_certificate_lies_beside_the_deck(self):
        self.bent()
        found = api.certify(self.assembly, self.output, "static")
        self.assertTrue(found["passed"], found["failures"])
        self.assertEqual([part["name"] for part in found["parts"]], ["plates/7", "plates/8"])
        self.assertEqual([part["thickness"] for part in found["parts"]], [1.5, 2.5])
        self.assertIn(b"<html", self.written("certificate.html"))

    def test_a_recipe_of_a_deck_gives_the_same_morph_again(self):
        self.bent()
        place = api.export_recipe(self.assembly, os.path.join(self.folder, "kept", "r.json"))
        again = api.import_recipe(self.document, place)
        self.document.recompute()
        before, after = (list(api.deform(one).values()) for one in (self.assembly, again))
        for one, other in zip(before, after):
            np.testing.assert_array_equal(one, other)

    def test_a_recipe_tells_a_thickness_where_it_is_another_than_the_decks(self):
        self.bent()
        self.assertNotIn("thickness", self.exported()["parts"][0])
        again = api.import_recipe(self.document, os.path.join(self.folder, "kept", "r.json"))
        self.assertEqual([p.SheetThickness.Value for p in objects.parts(again)], [1.5, 2.5])
        for part in objects.parts(self.assembly):
            part.SheetThickness = 3.0
        self.assertEqual(self.exported()["parts"][0]["thickness"], 3.0)

    def test_repair_and_files_of_welds_come_through_a_document(self):
        self.bent()
        recipe, folder = self.exported(), os.path.join(self.folder, "kept")
        texts = {"mine.json": b'{"elements": {"aspect": {"max": 9}}}\r\n'}
        texts["w.csv"] = b"id,x,y,z\n1,20,10,1\n"
        for name, text in texts.items():
            with open(os.path.join(folder, name), "wb") as out:
                out.write(text)
        recipe |= {"repair": "mine.json", "joint_files": [{"file": "w.csv", "limit": 3.0}]}
        with open(os.path.join(folder, "asks.json"), "w", encoding="utf-8") as out:
            json.dump(recipe, out)
        again = api.import_recipe(self.document, os.path.join(folder, "asks.json"))
        self.assertEqual(again.Repair, "mine.json")
        place = api.export_recipe(again, os.path.join(self.folder, "other", "r.json"))
        with open(place, encoding="utf-8") as file:
            told = json.load(file)
        for key in ("repair", "joint_files"):
            self.assertEqual(told[key], recipe[key])
        for name, text in texts.items():
            with open(os.path.join(self.folder, "other", name), "rb") as file:
                self.assertEqual(file.read(), text)
        again.Repair = ""
        place = api.export_recipe(again, os.path.join(self.folder, "third", "r.json"))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "third", "mine.json")))

    def exported(self) -> dict:
        place = api.export_recipe(self.assembly, os.path.join(self.folder, "kept", "r.json"))
        with open(place, encoding="utf-8") as file:
            return json.load(file)

    def test_parts_that_differ_cannot_be_one_entry_of_a_recipe(self):
        skin, _ = self.bent()
        skin.Poisson = 0.25
        with self.assertRaisesRegex(ValueError, "differ in Mode"):
            api.export_recipe(self.assembly, os.path.join(self.folder, "r.json"))

    def test_a_document_keeps_the_deck(self):
        self.bent()
        os.remove(self.path)
        found = self.reopen(self.document).Objects
        (assembly,) = (obj for obj in found if objects.kind(obj) == model.ASSEMBLY)
        api.write_parts(assembly, self.output)
        self.assertIn(b"Femap Property 7", self.written("plates.bdf"))


if __name__ == "__main__":
    unittest.main()
