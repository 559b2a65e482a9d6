# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples: their recipes become documents and come back, their macros run."""

import json
import runpy
import unittest
from pathlib import Path

import FreeCAD
import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.tests import support

NAMES = ("door_mirror", "body_panels", "welded_frame")
LISTS = ("fixed", "handles", "features", "regions", "contacts", "points")


def examples() -> Path | None:
    """Return the folder of the examples, installed or in a working copy; None if there is none."""
    for folder in Path(__file__).absolute().parents:
        found = folder / "resources" / "examples"
        if found.is_dir():
            return found
    return None


def read(path) -> dict:
    return json.loads(Path(path).read_text(encoding="utf-8"))


def spelled_out(recipe: dict) -> dict:
    """Return a recipe with every default written, and pivots of handles where they act: the pose.

    A turn by nothing and a file's place do not count.
    """
    full = {"energy": "neumann", "operator": "cotangent", **recipe}
    defaults = {"type": "local", "levels": 3, "smoothness": 0.05}
    full["propagation"] = {**defaults, **recipe.get("propagation", {})}
    for key in LISTS:
        full[key] = [dict(entry) for entry in recipe.get(key, [])]
    full["contacts"] = [{"type": "control mesh", **entry} for entry in full["contacts"]]
    full["features"] = [{"rotation": "free", **entry} for entry in full["features"]]
    full["pose"] = {name: dict(move) for name, move in recipe.get("pose", {}).items()}
    for handle in full["handles"]:
        pivot = handle.pop("pivot", None)
        if pivot is not None:
            full["pose"].setdefault(handle["name"], {}).setdefault("pivot", pivot)
    return full


class ExampleTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.examples = examples()
        if self.examples is None:
            self.skipTest("The examples are not installed beside the add-on.")

    def recipe(self, name: str) -> Path:
        return self.examples / name / "recipe.json"


class TestRecipes(ExampleTest):
    def test_a_document_morphs_as_the_command_line_does(self):
        for name in NAMES:
            with self.subTest(name):
                out = Path(self.folder) / name
                kernel.load().run(self.recipe(name), out)
                assembly = api.import_recipe(self.new_document(), self.recipe(name))
                found = api.deform(assembly)
                for part in objects.parts(assembly):
                    expected = kernel.load().read_part(out / part.FileName).mesh.points
                    np.testing.assert_array_equal(found[part.Name], expected, part.Label)

    def test_a_recipe_comes_back_as_it_was_but_for_defaults(self):
        for name in NAMES:
            with self.subTest(name):
                assembly = api.import_recipe(self.new_document(), self.recipe(name))
                path = Path(self.folder) / name / "again.json"
                path.parent.mkdir()
                api.export_recipe(assembly, path)
                expected, found = (spelled_out(read(p)) for p in (self.recipe(name), path))
                self.assertEqual(set(found), set(expected))
                for key, value in expected.items():
                    self.assertTrue(found[key] == value, key)

    def test_every_part_follows_and_every_weld_says_how_well(self):
        for name in NAMES:
            with self.subTest(name):
                document = self.new_document()
                assembly = api.import_recipe(document, self.recipe(name))
                document.recompute()
                self.assert_up_to_date(document)
                self.assertEqual(list(assembly.Unreached), [])
                self.assertEqual(len(assembly.Order), len(objects.parts(assembly)))
                # A single control mesh holds no contact, but still tells how each fares.
                widest = 0.5 if assembly.Propagation == "local" else 2.0
                for contact in objects.contacts(assembly):
                    self.assertGreater(contact.Deviation.Value, 0.0, contact.Label)
                    self.assertLess(contact.GapChange.Value, widest, contact.Label)


class TestMacros(ExampleTest):
    def test_the_macros_run_and_move_every_part(self):
        for name in NAMES:
            with self.subTest(name):
                before = set(FreeCAD.listDocuments())
                runpy.run_path(str(self.examples / name / f"{name}.FCMacro"))
                self.documents += sorted(set(FreeCAD.listDocuments()) - before)
                document = FreeCAD.getDocument(self.documents[-1])
                self.assert_up_to_date(document)
                assembly = next(
                    o for o in document.Objects if objects.kind(o) == "SheetMorph::Assembly"
                )
                self.assertEqual(assembly.Status, "Up to date.")
                for part in objects.parts(assembly):
                    moved = support.seen_points(part) - api.rest_mesh(part)[0]
                    self.assertGreater(support.largest(moved), 0.1, part.Label)


class TestSplit(ExampleTest):
    def split_recipe(self) -> str:
        """Write two strips in one file and a recipe that splits it; return its path."""
        points, triangles = support.strip()
        both = np.concatenate([points, points + (0.0, 90.0, 1.0)])
        faces = np.concatenate([triangles, triangles + len(points)])
        folder = Path(self.folder)
        support.write_obj(str(folder / "both.obj"), both, faces)
        edge = np.flatnonzero((points[:, 1] > 85) & (np.abs(points[:, 0] - 150) < 60))
        other = np.flatnonzero((points[:, 1] < 15) & (np.abs(points[:, 0] - 150) < 60))
        recipe = {
            "sheetmorph": 1,
            "parts": [{"file": "both.obj", "split": True, "mode": 2}],
            "primary": "both/1",
            "fixed": [{"part": "both/1", "vertices": support.left_edge(points)}],
            "handles": [{"name": "tip", "part": "both/1", "vertices": support.right_edge(points)}],
            "contacts": [
                {
                    "a": {"part": "both/1", "vertices": edge.tolist()},
                    "b": {"part": "both/2", "vertices": (other + len(points)).tolist()},
                }
            ],
            "pose": {"tip": {"translation": [0, 0, 40]}},
        }
        path = folder / "morph.json"
        path.write_text(json.dumps(recipe), encoding="utf-8")
        return str(path)

    def test_a_split_file_becomes_several_parts_that_morph_as_on_the_command_line(self):
        path = self.split_recipe()
        kernel.load().run(path, Path(self.folder) / "out")
        expected = kernel.load().read_part(Path(self.folder) / "out" / "both.obj").mesh.points
        assembly = api.import_recipe(self.document, path)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual([p.Label for p in objects.parts(assembly)], ["both/1", "both/2"])
        self.assertEqual([p.Mode for p in objects.parts(assembly)], ["2 regions"] * 2)
        found = api.deform(assembly)
        together = np.concatenate([found[p.Name] for p in objects.parts(assembly)])
        np.testing.assert_array_equal(together, expected)
        names = [file.name for file in api.write_parts(assembly, Path(self.folder) / "parts")]
        self.assertEqual(names, ["both_1.obj", "both_2.obj", "report.json"])

    def test_its_export_morphs_alike(self):
        assembly = api.import_recipe(self.document, self.split_recipe())
        exported = Path(self.folder) / "exported" / "morph.json"
        exported.parent.mkdir()
        api.export_recipe(assembly, exported)
        again = api.import_recipe(self.new_document(), exported)
        one, other = api.deform(assembly), api.deform(again)
        for left, right in zip(objects.parts(assembly), objects.parts(again)):
            np.testing.assert_array_equal(one[left.Name], other[right.Name])


if __name__ == "__main__":
    unittest.main()
