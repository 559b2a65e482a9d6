# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph goes through a recipe file and comes back to the last digit."""

import json
import os
import subprocess
import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import kernel, recipes, solving
from freecad.sheetmorph.bridge.study_run import interpreter
from freecad.sheetmorph.tests import support


class RecipeTest(support.DocumentTest):
    def path(self, *names: str) -> str:
        return os.path.join(self.folder, *names)

    def rich_morph(self):
        """Return a morph with every kind of region, a moved source and an imported part."""
        source = self.add_source()
        source.Placement = support.placement((500, -40, 70), (1, 2, 3), 75)
        assembly, part, handle = self.add_morph(source)
        rims = api.hole_rims(part)
        api.add_feature(assembly, part, rims[0], "Hole")
        api.add_feature(assembly, part, rims[1], "Turned hole", rotation=((1, 2, 3), 20))
        api.set_motion(handle, (1 / 3, 2, 30), (0, 1, 0), 400, pivot=(300, 50, 1 / 7))
        api.set_energy(assembly, "paper")
        points, triangles = support.strip()
        support.write_obj(self.path("Second.obj"), points + 1 / 3, triangles)
        second = api.import_part(assembly, self.path("Second.obj"))
        api.add_fixed(assembly, second, support.left_edge(points), "Second clamp")
        return assembly

    def exported(self, assembly) -> str:
        os.makedirs(self.path("recipe"), exist_ok=True)
        return str(api.export_recipe(assembly, self.path("recipe", "morph.json")))


class TestRoundTrip(RecipeTest):
    def test_positions_are_identical(self):
        assembly = self.rich_morph()
        again = api.import_recipe(self.new_document(), self.exported(assembly))
        expected, found = api.deform(assembly), api.deform(again)
        for one, other in zip(objects.parts(assembly), objects.parts(again)):
            np.testing.assert_array_equal(found[other.Name], expected[one.Name])

    def test_regions_pose_primary_and_energy_come_back(self):
        assembly = self.rich_morph()
        again = api.import_recipe(self.new_document(), self.exported(assembly))
        self.assertEqual(recipes.pose_of(again), recipes.pose_of(assembly))
        one, other = solving.read_morph(assembly).recipe, solving.read_morph(again).recipe
        self.assertEqual(other, one)

    def test_a_second_export_is_the_same_text(self):
        path = self.exported(self.rich_morph())
        with open(path, encoding="utf-8") as file:
            first = file.read()
        again = api.import_recipe(self.new_document(), path)
        with open(self.exported(again), encoding="utf-8") as file:
            self.assertEqual(file.read(), first)

    def test_the_package_runs_what_was_exported_to_the_same_positions(self):
        assembly = self.rich_morph()
        kernel.load().run(self.exported(assembly), self.path("out"))
        expected = api.deform(assembly)
        part = objects.parts(assembly)[0]
        found = kernel.load().read_part(self.path("out", f"{part.Label}.obj")).mesh.points
        np.testing.assert_array_equal(found, expected[part.Name])

    def test_a_recipe_of_the_command_line_is_valid(self):
        path = self.exported(self.rich_morph())
        package = os.path.dirname(kernel.package_folder())
        result = subprocess.run(
            [interpreter(), "-m", "sheetmorph", "check", path],
            env={**os.environ, "PYTHONPATH": package},
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stderr)


class TestPlacement(RecipeTest):
    """`placement` of a part: the placement of its source, there and back."""

    PLACE = {
        "translation": [100.0, -20.0, 7.0],
        "rotation": {"axis": [1.0, 2.0, 2.0], "degrees": 40.0},
    }

    def placed_morph(self):
        """Import a strip that is placed, its left end held, its right end lifted."""
        points, triangles = support.strip()
        support.write_obj(self.path("strip.obj"), points, triangles)
        low = float(points[:, 0].min())
        recipe = {
            "sheetmorph": 1,
            "parts": [{"name": "strip", "file": "strip.obj", "placement": self.PLACE}],
            "fixed": [
                {
                    "name": "clamp",
                    "part": "strip",
                    "where": {"box": [[low - 1, -1e3, -1e3], [low + 1, 1e3, 1e3]]},
                }
            ],
            "handles": [{"name": "tip", "part": "strip", "vertices": support.right_edge(points)}],
            "pose": {"tip": {"translation": [0, 0, 30]}},
        }
        with open(self.path("placed.json"), "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        return api.import_recipe(self.document, self.path("placed.json")), points

    def test_it_stands_where_the_recipe_says_and_goes_back_as_it_came(self):
        assembly, points = self.placed_morph()
        (part,) = objects.parts(assembly)
        package = kernel.load()
        place = package.recipe.placement.Placement.of_entry(self.PLACE)
        there = place.placed(points)
        self.assertLess(support.largest(api.rest_mesh(part)[0] - there), 1e-9)
        with open(self.exported(assembly), encoding="utf-8") as file:
            recipe = json.load(file)
        again = package.recipe.placement.Placement.of_entry(recipe["parts"][0]["placement"])
        self.assertLess(support.largest(again.placed(points) - there), 1e-9)
        self.assertIn("box", json.dumps(recipe["fixed"][0]["where"]))
        in_toml = api.export_recipe(assembly, self.path("recipe", "recipe.toml"))
        self.assertEqual(package.recipe.read_json(in_toml), recipe)
        with open(self.path("strip.obj"), "rb") as one:
            with open(self.path("recipe", "strip.obj"), "rb") as other:
                self.assertEqual(other.read(), one.read())
        package.run(self.path("recipe", "morph.json"), self.path("out"))
        found = package.read_part(self.path("out", "strip.obj")).mesh.points
        expected = api.deform(assembly)[part.Name]
        self.assertLess(support.largest(place.placed(found) - expected), 1e-9)

    def test_a_source_that_is_moved_is_exported_where_it_stands(self):
        assembly, points = self.placed_morph()
        (part,) = objects.parts(assembly)
        part.Source.Placement = support.placement((3, 4, 5), (0, 0, 1), 90)
        self.document.recompute()
        again = api.import_recipe(self.new_document(), self.exported(assembly))
        (other,) = objects.parts(again)
        rest = api.rest_mesh(part)[0]
        self.assertLess(support.largest(api.rest_mesh(other)[0] - rest), 1e-9)
        self.assertLess(
            support.largest(api.deform(again)[other.Name] - api.deform(assembly)[part.Name]), 1e-9
        )
        self.assertGreater(support.largest(rest - points), 1.0)
        certificate = api.certify(assembly, self.path("certified"))
        self.assertEqual(certificate["failures"], [])


class TestOneFolder(RecipeTest):
    """Recipe and deformed parts into one folder: nobody's meshes at rest are lost."""

    def test_parts_are_not_written_over_what_a_recipe_there_reads(self):
        assembly = self.rich_morph()
        path = self.exported(assembly)
        before = self.contents()
        with self.assertRaisesRegex(ValueError, '"morph.json" next to it reads this file'):
            api.write_parts(assembly, self.path("recipe"))
        self.assertEqual(self.contents(), before)
        again = api.import_recipe(self.new_document(), path)
        expected, found = api.deform(assembly), api.deform(again)
        for one, other in zip(objects.parts(assembly), objects.parts(again)):
            np.testing.assert_array_equal(found[other.Name], expected[one.Name])

    def test_another_recipe_with_the_same_meshes_may_stand_beside(self):
        assembly = self.rich_morph()
        first = self.exported(assembly)
        second = api.export_recipe(assembly, self.path("recipe", "second.json"))
        self.assertTrue(os.path.isfile(first) and os.path.isfile(second))

    def test_another_recipe_with_other_meshes_is_refused(self):
        assembly = self.rich_morph()
        self.exported(assembly)
        objects.parts(assembly)[0].Source.Placement = support.placement((1, 2, 3), (0, 0, 1), 5)
        before = self.contents()
        with self.assertRaisesRegex(ValueError, "choose another folder"):
            api.export_recipe(assembly, self.path("recipe", "second.json"))
        self.assertEqual(self.contents(), before)

    def contents(self) -> dict[str, bytes]:
        """What is in the folder of the recipe."""
        found = {}
        for name in os.listdir(self.path("recipe")):
            with open(self.path("recipe", name), "rb") as file:
                found[name] = file.read()
        return found


class TestNodeIds(RecipeTest):
    def deck_morph(self):
        """Return a morph of a Nastran deck with node ids 5001, 5004, ... in falling order."""
        points, triangles = support.strip()
        ids = 5001 + 3 * np.arange(len(points))[::-1]
        support.write_deck(self.path("deck.nas"), points, (triangles, ids))
        assembly = api.create_assembly(self.document)
        part = api.import_part(assembly, self.path("deck.nas"))
        found, _ = api.rest_mesh(part)
        api.add_fixed(assembly, part, support.left_edge(found), "Clamp")
        handle = api.add_handle(assembly, part, support.right_edge(found), "Tip")
        api.set_motion(handle, (0, 0, 30))
        return assembly

    def test_a_recipe_of_a_deck_speaks_its_node_ids(self):
        assembly = self.deck_morph()
        with open(self.exported(assembly), encoding="utf-8") as file:
            vertices = json.load(file)["fixed"][0]["vertices"]
        self.assertTrue(all(k > 5000 and k % 3 == 0 for k in vertices))
        again = api.import_recipe(self.new_document(), self.path("recipe", "morph.json"))
        expected = api.deform(assembly)[assembly.Primary.Name]
        np.testing.assert_array_equal(api.deform(again)[again.Primary.Name], expected)

    def test_the_deck_is_written_with_its_node_ids(self):
        assembly = self.deck_morph()
        api.write_parts(assembly, self.path("out"))
        written = kernel.load().read_part(self.path("out", "deck.nas")).mesh
        original = kernel.load().read_part(self.path("deck.nas")).mesh
        np.testing.assert_array_equal(written.ids, original.ids)
        moved = written.points - api.deform(assembly)[assembly.Primary.Name]
        self.assertLess(support.largest(moved), 1e-3)


class TestImport(RecipeTest):
    def write_recipe(self, **changes) -> str:
        points, triangles = support.strip()
        support.write_obj(self.path("cover.obj"), points, triangles)
        recipe = {
            "sheetmorph": 1,
            "parts": [{"name": "cover", "file": "cover.obj"}],
            "fixed": [{"part": "cover", "vertices": support.left_edge(points)}],
            "handles": [
                {
                    "name": "tip",
                    "part": "cover",
                    "vertices": support.right_edge(points),
                    "pivot": [300, 0, 0],
                }
            ],
            "pose": {"tip": {"translation": [0, 0, 20]}},
        }
        recipe.update(changes)
        with open(self.path("morph.json"), "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        return self.path("morph.json")

    def test_a_hand_written_recipe_becomes_a_morph(self):
        assembly = api.import_recipe(self.document, self.write_recipe())
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(assembly.Label, "morph")
        self.assertEqual([p.Label for p in objects.parts(assembly)], ["cover"])
        handle = objects.regions(assembly)[1]
        self.assertEqual((handle.Label, handle.TranslationZ.Value), ("tip", 20.0))
        self.assertEqual(tuple(api.pivot(handle)), (300.0, 0.0, 0.0))

    def test_what_a_recipe_leaves_to_a_search_is_found(self):
        kinds = ["hole", "round hole", "slotted hole", "rectangular hole"]
        path = self.write_recipe(features={"auto": {"kinds": kinds}}, contacts="auto")
        assembly = api.import_recipe(self.document, path)
        features = [r for r in objects.regions(assembly) if r.Role == "form feature"]
        self.assertEqual(len(features), len(support.HOLES))

    def test_points_on_triangles_are_kept_and_act(self):
        point = {
            "name": "pin",
            "part": "cover",
            "triangle": 250,
            "barycentric": [0.2, 0.3, 0.5],
            "target": [150, 50, 12],
        }
        assembly = api.import_recipe(self.document, self.write_recipe(points=[point]))
        found = api.deform(assembly)
        points, triangles = support.strip()
        on_part = found[objects.parts(assembly)[0].Name]
        pinned = np.array(point["barycentric"]) @ on_part[triangles[250]]
        self.assertLess(support.largest(pinned - (150, 50, 12)), 1e-9)
        objects.parts(assembly)[0].Label = "renamed"
        again = api.import_recipe(self.new_document(), self.exported(assembly))
        np.testing.assert_array_equal(api.deform(again)[objects.parts(again)[0].Name], on_part)

    def test_a_remeshed_part_comes_in_as_its_new_mesh_with_its_regions(self):
        points = np.array([[0, 0, 0], [60, 0, 0], [60, 20, 0], [0, 20, 0]], dtype=float)
        support.write_obj(self.path("coarse.obj"), points, np.array([[0, 1, 2], [0, 2, 3]]))
        recipe = {
            "sheetmorph": 1,
            "parts": [{"name": "coarse", "file": "coarse.obj", "remesh": {"edge": 4}}],
            "fixed": [{"part": "coarse", "vertices": [0, 3]}],
            "handles": [{"name": "tip", "part": "coarse", "vertices": [1, 2]}],
            "pose": {"tip": {"translation": [0, 0, 5]}},
        }
        with open(self.path("coarse.json"), "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        assembly = api.import_recipe(self.new_document(), self.path("coarse.json"))
        (part,) = objects.parts(assembly)
        positions = api.deform(assembly)[part.Name]
        self.assertGreater(len(positions), 60)
        end = positions[positions[:, 0] > 59.9]
        self.assertGreater(len(end), 4)
        np.testing.assert_allclose(end[:, 2], 5.0)

    def test_regions_without_names_get_those_the_pose_calls_them(self):
        points, _ = support.strip()
        handle = {"part": "cover", "vertices": support.right_edge(points)}
        pose = {"handle0": {"translation": [0, 0, 20]}}
        path = self.write_recipe(handles=[handle], pose=pose)
        assembly = api.import_recipe(self.document, path)
        self.assertEqual([r.Label for r in objects.regions(assembly)], ["fixed0", "handle0"])
        found = api.deform(assembly)[assembly.Primary.Name]
        self.assertEqual(found[:, 2].max(), 20.0)

    def test_a_recipe_read_twice_makes_two_morphs_of_one_document(self):
        path = self.write_recipe()
        first, second = (api.import_recipe(self.document, path) for _ in range(2))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        one, other = (support.seen_points(objects.parts(m)[0]) for m in (first, second))
        np.testing.assert_array_equal(one, other)

    def test_faults_are_told_and_the_document_stays_as_it_is(self):
        bad = self.path("bad.json")
        with open(bad, "w", encoding="utf-8") as file:
            file.write('{"sheetmorph": 1,\n "parts": [}')
        missing = self.path("missing.json")
        for path, words in (
            (bad, "bad.json, line 2"),
            (self.write_recipe(handels=[]), "handels"),
            (missing, "missing.json"),
        ):
            with self.subTest(words), self.assertRaisesRegex((ValueError, OSError), words):
                api.import_recipe(self.document, path)
        vertices = [{"part": "cover", "vertices": [10**6]}]
        with self.assertRaisesRegex(ValueError, "1000000"):
            api.import_recipe(self.document, self.write_recipe(fixed=vertices))
        self.assertEqual(self.document.Objects, [])

    def test_an_empty_morph_is_not_exported(self):
        assembly = api.create_assembly(self.document)
        with self.assertRaisesRegex(ValueError, "no part yet"):
            api.export_recipe(assembly, self.path("morph.json"))
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
